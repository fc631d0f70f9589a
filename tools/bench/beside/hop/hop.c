/* A hop as Onika does it, in C: six doubles in shared memory, a datagram of one byte, the other process in `select`.
   Arguments: hops to warm up, hops to count. Prints half of each round trip in nanoseconds, one a line. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

enum { SIZE = 6 };

static long long now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1000000000LL + t.tv_nsec;
}

/* Publish the values and wake the other; 0 when it is gone. */
static int tell(int post, double *shared, const double *values)
{
    memcpy(shared, values, SIZE * sizeof *values);
    return send(post, "", 1, MSG_NOSIGNAL) == 1;
}

/* Wait until woken and take the values; 0 when the other is gone. */
static int hear(int post, const double *shared, double *values)
{
    char byte;
    fd_set ready;
    FD_ZERO(&ready);
    FD_SET(post, &ready);
    if (select(post + 1, &ready, NULL, NULL, NULL) != 1 || recv(post, &byte, 1, 0) != 1)
        return 0;
    memcpy(values, shared, SIZE * sizeof *values);
    return 1;
}

int main(int argc, char **argv)
{
    int ends[2];
    if (argc != 3 || socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) != 0)
        return 2;
    long warm = atol(argv[1]), count = atol(argv[2]);
    double *there = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    double *back = there + 64, sent[SIZE] = {0}, got[SIZE];
    if (there == MAP_FAILED)
        return 3;
    if (fork() == 0) {
        close(ends[0]);
        while (hear(ends[1], there, got) && tell(ends[1], back, got))
            ;
        return 0;
    }
    close(ends[1]);
    for (long number = 0; number < warm + count; number++) {
        sent[0] = (double)number;
        long long began = now();
        if (!tell(ends[0], there, sent) || !hear(ends[0], back, got) || got[0] != sent[0])
            return 1;
        if (number >= warm)
            printf("%lld\n", (now() - began) / 2);
    }
    return 0;
}
