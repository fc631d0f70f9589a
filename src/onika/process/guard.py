"""The guard process above a program that may start others: when the program ends, nothing of it is left (F04, X12).

Run as a script of its own, in one of two ways, with a socket, the lifeline, under a descriptor:

`python -I -S guard.py partner COMMAND…` keeps a program that a task has started; the lifeline is the descriptor 3. The
program runs as long as the other end of the lifeline is open. When that is closed, by the task or because its whole
process is gone, the program has a moment to end by itself, which the end of its input tells it to; then it is ended.
With `listener` in place of `partner` it has no input that could end, and is asked to end at once: its address is free
for the next one.
When the program ends first, the guard says how on the lifeline, and who was left behind lives as long as the task.

`python -I -S guard.py runtime N` keeps a runtime; the lifeline is the descriptor N, and brings the command. When the
runtime ends, or the other end of the lifeline is closed, all that the runtime and its modules have started is ended.

Either way nothing is left in the end: what somebody started, and left behind or gave a session of its own, becomes the
guard's child. It knows nothing of Onika, so that it starts quickly.
"""

import contextlib
import ctypes
import os
import select
import signal
import sys
from collections.abc import Iterable
from time import monotonic

LIFELINE = 3
"""Where the guard of a partner finds it."""
OWN_PID = "{guard}"
"""The word in a runtime's command in whose place the guard puts its own process id."""
GRACE_S = 1.0
"""So long a partner has to end by itself, and as long again after it was asked to by a signal."""
ENDED_S = 2.0
"""So long whoever was ended has to be gone, with the children that it may have had just then."""
LAST_WORDS_S = 0.7
"""So long those whom a runtime leaves behind have to end by themselves: one of them finishes a recording."""
WORK_S = 1.4
"""And so long while one of them is at work: the last half minute of a run is written on a machine that is busy."""
_LOOK_S, _FIRST_LOOK_S = 0.05, 0.003
"""How long it waits before it looks again whether somebody is left; at first, when most just end, less."""
_USUAL = (signal.SIGPIPE, signal.SIGXFSZ)
"""Signals that Python ignores, and no program that it starts does."""
_AT_WORK = frozenset((b"R", b"D"))
"""The letters of those who run, or would if they could, and of those who wait for a disk."""
_LONGEST_ORDER = 1 << 20
_ADOPT_ORPHANS = 36  # PR_SET_CHILD_SUBREAPER of prctl(2)


def keep_partner(command: list[str], lifeline: int, grace_s: float) -> None:
    """Start the program of a task, and see to its end; `grace_s` is how long it has to end by itself."""
    import subprocess  # within: the guard of a runtime starts without it

    try:
        program = subprocess.Popen(command, start_new_session=True)  # noqa: S603 - who may start it was judged before
    except OSError as wrong:
        say(lifeline, f"unstartable {wrong.strerror}")
        return
    os.close(0)  # the program alone holds the conversation: when it ends, so does that
    os.close(1)
    its_end = os.pidfd_open(program.pid)
    if its_end in select.select([its_end, lifeline], [], [])[0]:
        code = program.wait()
        say(lifeline, f"signal {-code}" if code < 0 else f"exit {code}")
        select.select([lifeline], [], [])  # who was left behind may go on as long as the task lives
    end_family(grace_s, GRACE_S)


def keep_runtime(lifeline: int) -> None:
    """Start a runtime, say its process id, wait for its end or for that of who wanted it, and leave nothing of it."""
    own_group, descriptors, *command = os.read(lifeline, _LONGEST_ORDER).decode("utf-8", "surrogateescape").split("\0")
    passed = [int(number) for number in descriptors.split()]
    command = [str(os.getpid()) if word == OWN_PID else word for word in command]
    deaths = note_deaths()
    parent = os.getppid()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the runtime begins so, else a Ctrl-C would tear its start
    try:
        runtime = os.posix_spawnp(command[0], command, os.environ, setsid=bool(own_group), setsigdef=_USUAL)
    except OSError as wrong:
        say(lifeline, f"unstartable {wrong.errno}")
        return
    for number in passed:
        os.close(number)
    mute()
    forward(signal.SIGTERM, runtime)
    signal.signal(signal.SIGINT, lambda _number, _frame: wake(parent))
    say(lifeline, f"pid {runtime}")
    code = runtime_ended(runtime, deaths, lifeline)
    if code is not None:
        say(lifeline, f"signal {-code}" if code < 0 else f"exit {code}")
    else:
        os.kill(runtime, signal.SIGKILL)
    end_family(LAST_WORDS_S, 0.0, WORK_S)


def note_deaths() -> int:
    """The descriptor on which it can be read that a child has ended; signals to the whole group are not the guard's."""
    deaths, noted = os.pipe()
    os.set_blocking(deaths, False)
    os.set_blocking(noted, False)
    signal.set_wakeup_fd(noted, warn_on_full_buffer=False)
    for signum in (signal.SIGCHLD, signal.SIGINT, signal.SIGHUP):
        signal.signal(signum, lambda _number, _frame: None)  # a handler, which the runtime does not inherit
    return deaths


def mute() -> None:
    """Give the outputs back: the runtime's end is the end of its output."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(nowhere, number)
    os.close(nowhere)


def forward(signum: int, pid: int) -> None:
    """Pass a signal on to the runtime."""

    def pass_on(number: int, _frame: object) -> None:
        with contextlib.suppress(OSError):
            os.kill(pid, number)

    signal.signal(signum, pass_on)


def wake(pid: int) -> None:
    """Have a process go on that the system holds: a Ctrl-C is for it to answer, and it could not."""
    if is_stopped(pid):
        with contextlib.suppress(OSError):
            os.kill(pid, signal.SIGCONT)


def is_stopped(pid: int) -> bool:
    """Whether the operating system holds a process (SIGSTOP, a debugger), so that it does nothing."""
    try:
        return status(pid)[0] in (b"T", b"t")
    except (OSError, ValueError):
        return False


def runtime_ended(pid: int, deaths: int, lifeline: int) -> int | None:
    """The exit code of the runtime, negative for the signal that ended it; None where nobody wants it any more."""
    while True:
        ready = select.select([deaths, lifeline], [], [])[0]
        with contextlib.suppress(BlockingIOError):
            os.read(deaths, 4096)
        codes = reap()
        if pid in codes:
            return codes[pid]
        if lifeline in ready:
            return None


def reap() -> dict[int, int]:
    """The children that have ended, orphans too, with their codes; none is a zombie any more."""
    codes = {}
    with contextlib.suppress(ChildProcessError):
        while True:
            pid, status = os.waitpid(-1, os.WNOHANG)
            if not pid:
                break
            codes[pid] = os.waitstatus_to_exitcode(status)
    return codes


def end_family(grace_s: float, asked_s: float, work_s: float = 0.0) -> None:
    """See to it that nobody is left: each is given a moment, then asked by a signal, then ended.

    The moment is `grace_s`, but `work_s` where somebody does not only wait, or stand.
    """
    for signum, patience_s in ((0, grace_s), (signal.SIGTERM, asked_s), (signal.SIGKILL, ENDED_S)):
        dead: set[int] | None = None
        told: set[int] = set()
        look_s, begin = _FIRST_LOOK_S, monotonic()
        while True:
            states = family()
            living = {pid: state for pid, state in states.items() if state != b"Z"}
            if not living and dead == states.keys():
                return
            dead = None if living else set(states)
            if not living:
                continue  # one that was dead when it was looked at may have had a child after the list was made
            tell(living.keys() - told, signum)
            told |= living.keys()
            is_at_work = not signum and not _AT_WORK.isdisjoint(living.values())
            if monotonic() - begin > (max(patience_s, work_s) if is_at_work else patience_s):
                break
            select.select([], [], [], look_s)
            look_s = min(2 * look_s, _LOOK_S)


def tell(processes: Iterable[int], signum: int) -> None:
    """Send them a signal; some may be gone."""
    for pid in processes:
        with contextlib.suppress(OSError):
            os.kill(pid, signum)


def family() -> dict[int, bytes]:
    """All processes that come from this one, with the letters of their states; also the dead, whom nobody reaps."""
    children: dict[int, list[tuple[int, bytes]]] = {}
    for name in os.listdir("/proc"):  # noqa: PTH208 - whoever knows no paths starts quickly, and looks in half the time
        with contextlib.suppress(OSError):
            if name.isdigit():
                state, parent = status(name)
                children.setdefault(int(parent), []).append((int(name), state))
    states, left = {}, [os.getpid()]
    while left:
        for pid, state in children.get(left.pop(), []):
            left.append(pid)
            states[pid] = state
    return states


def status(pid: int | str) -> tuple[bytes, bytes]:
    """The letter of a process's state, and the number of its parent; raises OSError."""
    with open(f"/proc/{pid}/stat", "rb") as file:  # noqa: PTH123 - as above
        state, parent = file.read().rpartition(b")")[2].split()[:2]  # a name may hold anything
    return state, parent


def say(lifeline: int, text: str) -> None:
    """Say on the lifeline how the program does: a word, then what belongs to it; nobody may be there any more."""
    with contextlib.suppress(OSError):
        os.write(lifeline, text.encode())


def adopt_orphans() -> None:
    """Become the parent of all that those below this process leave behind; Linux only."""
    with contextlib.suppress(AttributeError, OSError):
        ctypes.CDLL(None).prctl(_ADOPT_ORPHANS, 1)


def main(words: list[str]) -> None:
    """Nobody has to wait for the guard of a partner; whoever launched a runtime waits for that of the runtime."""
    if words[0] == "runtime":
        lifeline = int(words[1])
        os.set_inheritable(lifeline, False)
        adopt_orphans()
        keep_runtime(lifeline)
        return
    if os.fork():
        os._exit(0)
    os.set_inheritable(LIFELINE, False)
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, range(os.cpu_count() or 1))
    adopt_orphans()
    keep_partner(words[1:], LIFELINE, 0.0 if words[0] == "listener" else GRACE_S)


if __name__ == "__main__":
    main(sys.argv[1:])
