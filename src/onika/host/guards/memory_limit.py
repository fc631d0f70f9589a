"""A bound on the memory of a process that runs modules: one that allocates without end gets a MemoryError of its own.

The module that asked for too much is in ERROR; the unit, its other tasks and the machine go on.
"""

import resource
from pathlib import Path

ROOM = 1 << 30
"""Bytes that modules may take beyond what the process has when it begins."""


def bound(room: int = ROOM) -> bool:
    """Bound private memory to what there is now and `room` bytes more; False where the system does not tell."""
    try:
        status = Path("/proc/self/status").read_text()
        has = next(int(line.split()[1]) << 10 for line in status.splitlines() if line.startswith("VmData:"))
        _, hard = resource.getrlimit(resource.RLIMIT_DATA)
        limit = has + room
        resource.setrlimit(resource.RLIMIT_DATA, (limit if hard < 0 else min(limit, hard), hard))
    except (OSError, ValueError, StopIteration):
        return False
    return True
