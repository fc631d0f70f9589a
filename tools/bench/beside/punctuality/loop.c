/* A loop of 500 Hz on an absolute grid: how late clock_nanosleep wakes it. Arguments: milliseconds, FIFO priority (0: none).
   Prints one lateness in nanoseconds a line; a period that has passed already is skipped, as Onika skips it. */

#define _GNU_SOURCE
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>

static const long long PERIOD = 2000000LL;

static long long now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1000000000LL + t.tv_nsec;
}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    long long span = atoll(argv[1]) * 1000000LL;
    struct sched_param priority = {.sched_priority = atoi(argv[2])};
    long room = (long)(span / PERIOD) + 16, count = 0;
    long long *late = calloc((size_t)room, sizeof *late);
    if (late == NULL)
        return 3;
    prctl(PR_SET_TIMERSLACK, 1, 0, 0, 0);
    mlockall(MCL_CURRENT | MCL_FUTURE);
    if (priority.sched_priority > 0 && sched_setscheduler(0, SCHED_FIFO, &priority) != 0) {
        perror("SCHED_FIFO");
        return 1;
    }
    long long due = (now() / PERIOD + 1) * PERIOD, until = due + span;
    while (due < until && count < room) {
        struct timespec at = {.tv_sec = due / 1000000000LL, .tv_nsec = due % 1000000000LL};
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, NULL) != 0)
            ;
        long long woken = now();
        late[count++] = woken - due;
        due = (woken / PERIOD + 1) * PERIOD;
    }
    for (long i = 0; i < count; i++)
        printf("%lld\n", late[i]);
    return 0;
}
