"""The title of a process: what `ps` shows as its command line, for one that began as a copy of another."""

import ctypes
from pathlib import Path

_FIRST = 3
"""Number in proc(5) of the first field behind the name of the program, which may hold anything."""
_BEGINNING, _END = 48, 49
"""Numbers in proc(5) of the addresses between which the command line lies in the process's own memory."""


def entitle(title: str) -> None:
    """Call this process so, as far as there is room where its command line was; on Linux only."""
    try:
        fields = Path("/proc/self/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return
    beginning, end = (int(fields[number - _FIRST]) for number in (_BEGINNING, _END))
    room = end - beginning
    if room <= 0:
        return  # this system does not tell where it lies
    words = title.encode()[: room - 1]
    ctypes.memset(beginning, 0, room)
    ctypes.memmove(beginning, words, len(words))
