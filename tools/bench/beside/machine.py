"""The machine that measured, without a date: processor, cores, kernel, Python, and what the system grants."""

import os
import platform
from pathlib import Path

from beside.punctuality.lateness import is_fifo_granted

CPUINFO = Path("/proc/cpuinfo")


def described() -> str:
    """One line."""
    granted = "SCHED_FIFO granted" if is_fifo_granted() else "SCHED_FIFO not granted"
    parts = (
        _processor(CPUINFO.read_text() if CPUINFO.exists() else ""),
        f"{len(os.sched_getaffinity(0))} cores",
        f"{platform.system()} {platform.release()}",
        f"Python {platform.python_version()}",
        granted,
    )
    return ", ".join(parts)


def _processor(text: str) -> str:
    for line in text.splitlines():
        key, _, value = line.partition(":")
        if key.strip() == "model name":
            return value.strip()
    return platform.machine()
