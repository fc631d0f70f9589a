"""The processes below a program, as the kernel knows them."""

from pathlib import Path


def descendants(pid: int) -> list[int]:
    """Everything that comes from a process and is still below it, nearest first."""
    below = [pid]
    for each in below:
        for children in Path(f"/proc/{each}/task").glob("*/children"):
            try:
                below += map(int, children.read_text().split())
            except OSError:  # it has ended meanwhile
                continue
    return below[1:]


def runtime_of(program: int) -> int:
    """The process id of the runtime that a program has started; between them stands its guard."""
    for pid in descendants(program):
        if b"onika.host\0" in _command(pid):
            return pid
    raise AssertionError("the program has no runtime")


def _command(pid: int) -> bytes:
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:  # it has ended meanwhile
        return b""
