"""Checks what this machine offers a runtime, such as real-time priority, and says what its absence costs (law 31)."""

import os
import platform
import resource
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata

from onika.desk.run.world_picture import DRAWER, NO_OPENGL
from onika.process import confinement, system_calls
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class Feature:
    """One thing: whether it is there, what was found, and what it costs if it is not."""

    name: Reason
    is_there: bool
    actual: Reason
    cost: Reason = NOTHING


def features() -> Iterator[Feature]:
    """Everything that matters, most important first."""
    yield _system()
    yield _python()
    yield _processors()
    yield _fifo()
    yield _memory_lock()
    yield _sandbox()
    yield from (_library(name, Reason.of(cost)) for name, cost in _LIBRARIES)
    yield _graphics()


_LIBRARIES = (
    ("numpy", "desk.cost_nothing_runs"),
    ("msgspec", "desk.cost_nothing_runs"),
    ("mujoco", "desk.cost_mujoco"),
    ("ruckig", "desk.cost_ruckig"),
    ("rich", "desk.cost_rich"),
)


def _system() -> Feature:
    system = Reason.of(
        "desk.machine_system_is", system=platform.system(), release=platform.release(), machine=platform.machine()
    )
    good = sys.platform == "linux" and platform.machine() in ("x86_64", "AMD64")
    return Feature(Reason.of("desk.machine_system"), good, system, Reason.of("desk.cost_system"))


def _python() -> Feature:
    version = platform.python_version()
    return Feature(
        Reason.plain("python"), sys.version_info >= (3, 11), Reason.plain(version), Reason.of("desk.cost_python")
    )


def _processors() -> Feature:
    count = len(os.sched_getaffinity(0))
    return Feature(
        Reason.of("desk.machine_processors"), count >= 2, Reason.plain(str(count)), Reason.of("desk.cost_processors")
    )


def _fifo() -> Feature:
    """Tried in a child, so that this process stays what it is."""
    probe = "import os; os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50))"
    words = [sys.executable, "-c", probe]
    allowed = subprocess.run(words, capture_output=True, check=False).returncode == 0  # noqa: S603 - our own words
    actual = Reason.of("desk.machine_granted") if allowed else Reason.of("desk.machine_refused")
    return Feature(Reason.plain("SCHED_FIFO"), allowed, actual, Reason.of("desk.cost_fifo"))


def _memory_lock() -> Feature:
    soft, _ = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    free = soft == resource.RLIM_INFINITY or os.geteuid() == 0
    limit = Reason.of("desk.machine_unlimited") if free else Reason.plain(f"{soft // 1024} KiB")
    cost = Reason.of("desk.cost_memory_lock")
    return Feature(Reason.of("desk.machine_memory_lock"), free or soft >= 1 << 28, limit, cost)


def _sandbox() -> Feature:
    """Whether code of others can be confined, without which it is not run."""
    level = confinement.level()
    is_there = bool(level) and system_calls.can_be_left_out()
    actual = Reason.plain(f"Landlock {level}") if is_there else Reason.of("desk.machine_not_there")
    return Feature(Reason.of("desk.machine_sandbox"), is_there, actual, Reason.of("desk.cost_sandbox"))


def _library(name: str, cost: Reason) -> Feature:
    try:
        return Feature(Reason.plain(name), True, Reason.plain(metadata.version(name)))
    except metadata.PackageNotFoundError:
        return Feature(Reason.plain(name), False, Reason.of("desk.machine_not_installed"), cost)


def _graphics() -> Feature:
    tried = subprocess.run([*DRAWER, "--probe"], capture_output=True, text=True, check=False)  # noqa: S603 - our own
    name, cost = Reason.of("desk.machine_graphics"), Reason.of("desk.cost_graphics")
    return Feature(name, tried.returncode == 0, _drawn(tried), cost)


def _drawn(tried: "subprocess.CompletedProcess[str]") -> Reason:
    """What the drawing program says of itself: the way in which it draws, or why not."""
    lines = (tried.stdout or tried.stderr).strip().splitlines()
    if tried.returncode == 0 and lines:
        return Reason.of("desk.machine_drawn_with", way=lines[-1])
    if tried.returncode == NO_OPENGL:
        return Reason.of("desk.no_opengl")
    if lines:
        return Reason.plain(lines[-1])
    return Reason.of("desk.machine_no_answer")
