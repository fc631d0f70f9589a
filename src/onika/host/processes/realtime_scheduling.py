"""What the operating system grants a real-time process: each grant is optional and reported (law 31)."""

import ctypes
import gc
import os

_PR_SET_TIMERSLACK = 29
_MCL_CURRENT, _MCL_ONFAULT = 1, 4
PRIORITY = 50
RUNNER_PRIORITY = 40
"""Of the runner between jobs: above everything that is not real time, below whatever cycles."""
SANDBOX_PRIORITY = 45
"""Of code of others: one that computes without end keeps no unit from its cycles but the one that waits for it."""


def fine_timers() -> bool:
    """Timer slack of 1 ns instead of 50 us: worth 50 us of median lateness."""
    return bool(ctypes.CDLL(None).prctl(_PR_SET_TIMERSLACK, 1, 0, 0, 0) == 0)


def lock_memory() -> bool:
    """Keep this process's memory in RAM, pages as they are touched."""
    return bool(ctypes.CDLL(None).mlockall(_MCL_CURRENT | _MCL_ONFAULT) == 0)


def first_in_first_out(priority: int = PRIORITY) -> bool:
    """The scheduling class SCHED_FIFO: what decides punctuality under load. Processes started later do not get it."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(priority))
    except OSError:
        return False
    return True


def still_garbage() -> None:
    """No collection while tasks cycle."""
    gc.collect()
    gc.freeze()
    gc.disable()


def become_real_time(with_fifo: bool) -> dict[str, bool]:
    """Take everything that is granted; what was, by name."""
    granted = {"timer slack": fine_timers(), "memory lock": lock_memory()}
    granted["SCHED_FIFO"] = with_fifo and first_in_first_out()
    still_garbage()
    return granted
