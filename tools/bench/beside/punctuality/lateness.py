"""How lateness is judged, and the least that the operating system has to grant for it."""

import os
from collections.abc import Sequence

from beside.contestant import Figures

RATE_HZ = 500
PERIOD_NS = 1_000_000_000 // RATE_HZ


def is_fifo_granted() -> bool:
    """Whether this process may use SCHED_FIFO; its own scheduling stays as it was."""
    policy, parameter = os.sched_getscheduler(0), os.sched_getparam(0)
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
        os.sched_setscheduler(0, policy, parameter)
    except OSError:
        return False
    return True


def figures(late_ns: Sequence[int], missed: int) -> Figures:
    """Median, 99 % (`figure`) and greatest lateness in microseconds, and missed cycles."""
    if not late_ns:
        raise RuntimeError("expected cycles, found none")
    found = sorted(late_ns)
    return {
        "figure": found[int(len(found) * 0.99)] / 1e3,
        "median": found[len(found) // 2] / 1e3,
        "most": found[-1] / 1e3,
        "missed": float(missed),
        "cycles": float(len(found)),
    }
