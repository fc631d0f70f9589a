"""The keeper of a program that a task has started: sees to it that the program ends with its task (F04).

Run as a script of its own, `python -I -S keeper.py COMMAND…`, with a socket, the lifeline, under the descriptor 3. The
program runs as long as the other end of the lifeline is open. When that is closed, by the task or because its whole
process is gone, the program has a moment to end by itself, which the end of its input tells it to; then it is ended.
When the program ends first, the keeper says how on the lifeline. It knows nothing of Onika, so that it starts quickly.
"""

import contextlib
import os
import select
import signal
import subprocess
import sys

LIFELINE = 3
GRACE_S = 1.0
"""So long a program has to end by itself, and as long again after it was asked to by a signal."""


def keep(command: list[str], lifeline: int) -> None:
    """Start the program, and see to its end."""
    try:
        program = subprocess.Popen(command, start_new_session=True)  # noqa: S603 - who may start it was judged before
    except OSError as wrong:
        say(lifeline, f"cannot be started: {wrong.strerror}")
        return
    os.close(0)  # the program alone holds the conversation: when it ends, so does that
    os.close(1)
    its_end = os.pidfd_open(program.pid)
    ready, _, _ = select.select([its_end, lifeline], [], [])
    if its_end in ready:
        code = program.wait()
        say(lifeline, f"ended by signal {-code}" if code < 0 else f"ended with exit code {code}")
        return
    for signum in (signal.SIGTERM, signal.SIGKILL):
        if select.select([its_end], [], [], GRACE_S)[0]:
            break
        with contextlib.suppress(ProcessLookupError):
            os.killpg(program.pid, signum)
    program.wait()


def say(lifeline: int, text: str) -> None:
    """Tell the task; it may be gone."""
    with contextlib.suppress(OSError):
        os.write(lifeline, text.encode())


def main(command: list[str]) -> None:
    """In a process of its own, which nobody has to wait for."""
    if os.fork():
        os._exit(0)
    os.set_inheritable(LIFELINE, False)
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, range(os.cpu_count() or 1))
    keep(command, LIFELINE)


if __name__ == "__main__":
    main(sys.argv[1:])
