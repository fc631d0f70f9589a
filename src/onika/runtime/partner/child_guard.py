"""The guard process of a program that a task has started: it ends the program when the task ends (F04).

Run as a script of its own, `python -I -S child_guard.py COMMAND…`, with a socket, the lifeline, under the descriptor 3.
The program runs as long as the other end of the lifeline is open. When that is closed, by the task or because its whole
process is gone, the program has a moment to end by itself, which the end of its input tells it to; then it is ended.
When the program ends first, the guard says how on the lifeline. Either way nothing of it is left in the end: what the
program started, and left behind or gave a session of its own, becomes the guard's child and ends with the lifeline.
It knows nothing of Onika, so that it starts quickly.
"""

import contextlib
import ctypes
import os
import select
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic

LIFELINE = 3
GRACE_S = 1.0
"""So long a program has to end by itself, and as long again after it was asked to by a signal."""
_LOOK_S = 0.05
_ADOPT_ORPHANS = 36  # PR_SET_CHILD_SUBREAPER of prctl(2)


def keep(command: list[str], lifeline: int) -> None:
    """Start the program, and see to its end."""
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
    end_family()


def end_family() -> None:
    """See to it that nobody is left: each is given a moment, then asked by a signal, then ended."""
    for signum in (0, signal.SIGTERM, signal.SIGKILL, signal.SIGKILL):  # twice: one may have had a child just then
        for pid in family():
            with contextlib.suppress(OSError):
                os.kill(pid, signum)
        until = monotonic() + GRACE_S
        while family():
            if monotonic() > until:
                break
            select.select([], [], [], _LOOK_S)
        else:
            return


def family() -> list[int]:
    """All living processes that come from this one."""
    children: dict[int, list[tuple[int, bytes]]] = {}
    for path in Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if path.name.isdigit():
                state, parent = (path / "stat").read_bytes().rpartition(b")")[2].split()[:2]  # a name may hold anything
                children.setdefault(int(parent), []).append((int(path.name), state))
    family_ids, left = [], [os.getpid()]
    while left:
        for pid, state in children.get(left.pop(), []):
            left.append(pid)
            if state != b"Z":
                family_ids.append(pid)
    return family_ids


def say(lifeline: int, text: str) -> None:
    """Tell the task how the program ended: a word, then what belongs to it; the task may be gone."""
    with contextlib.suppress(OSError):
        os.write(lifeline, text.encode())


def main(command: list[str]) -> None:
    """In a process of its own, which nobody has to wait for."""
    if os.fork():
        os._exit(0)
    os.set_inheritable(LIFELINE, False)
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, range(os.cpu_count() or 1))
    ctypes.CDLL(None).prctl(_ADOPT_ORPHANS, 1)
    keep(command, LIFELINE)


if __name__ == "__main__":
    main(sys.argv[1:])
