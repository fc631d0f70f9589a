"""Checks what this machine offers a runtime, such as real-time priority, and says what its absence costs (law 31)."""

import os
import platform
import resource
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata

from onika.desk.run.world_picture import DRAWER


@dataclass(frozen=True, slots=True)
class Feature:
    """One thing: whether it is there, what was found, and what it costs if it is not."""

    name: str
    is_there: bool
    actual: str
    cost: str = ""


def features() -> Iterator[Feature]:
    """Everything that matters, most important first."""
    yield _system()
    yield _python()
    yield _processors()
    yield _fifo()
    yield _memory_lock()
    yield from (_library(name, cost) for name, cost in _LIBRARIES)
    yield _graphics()


_LIBRARIES = (
    ("numpy", "nothing runs"),
    ("msgspec", "nothing runs"),
    ("mujoco", "no simulated worlds; modules that use laws of arms do not load"),
    ("ruckig", "modules that use it do not load"),
    ("rich", "no live progress"),
)


def _system() -> Feature:
    system = f"{platform.system()} {platform.release()} on {platform.machine()}"
    good = sys.platform == "linux" and platform.machine() in ("x86_64", "AMD64")
    return Feature("system", good, system, "the tables need memfd and the order of stores of x86-64: not a runtime")


def _python() -> Feature:
    version = platform.python_version()
    return Feature("python", sys.version_info >= (3, 11), version, "Onika needs 3.11 or newer")


def _processors() -> Feature:
    count = len(os.sched_getaffinity(0))
    return Feature("processors", count >= 2, str(count), "device server and RTPU share one: more missed cycles")


def _fifo() -> Feature:
    """Tried in a child, so that this process stays what it is."""
    probe = "import os; os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50))"
    words = [sys.executable, "-c", probe]
    allowed = subprocess.run(words, capture_output=True, check=False).returncode == 0  # noqa: S603 - our own words
    cost = "under load late cycles are a hundred times more frequent; grant it with 'rtprio 50' in limits.conf"
    return Feature("SCHED_FIFO", allowed, "granted" if allowed else "refused", cost)


def _memory_lock() -> Feature:
    soft, _ = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    free = soft == resource.RLIM_INFINITY or os.geteuid() == 0
    limit = "unlimited" if free else f"{soft // 1024} KiB"
    return Feature("memory lock", free or soft >= 1 << 28, limit, "a swapped page costs milliseconds in a cycle")


def _library(name: str, cost: str) -> Feature:
    try:
        return Feature(name, True, metadata.version(name))
    except metadata.PackageNotFoundError:
        return Feature(name, False, "not installed", cost)


def _graphics() -> Feature:
    tried = subprocess.run([*DRAWER, "--probe"], capture_output=True, text=True, check=False)  # noqa: S603 - our own
    lines = (tried.stdout or tried.stderr).strip().splitlines()
    answer = lines[-1] if lines else "no answer"
    return Feature("graphics", tried.returncode == 0, answer, "no pictures of the workcell (--picture); nothing else")
