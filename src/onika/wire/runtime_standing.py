"""A runtime as it stands: its subsystems with their tasks, its processing units, its worlds."""

from msgspec import Struct

from onika.ring.displacement import Displacement
from onika.wire.plan import PlannedTask
from onika.wire.question import Asked
from onika.words.reason import NOTHING, Reason


class TaskStanding(Struct, frozen=True):
    """A task as it stands: what it is, what it is in, what is wanted of it."""

    task: PlannedTask
    state: str
    is_wanted_on: bool
    rtpu: str
    frequency: float | None
    reason: Reason = NOTHING
    """Why it waits, what it asks for or what failed; else empty."""
    claims: str = ""
    """The device that it has for itself alone, as `WORLD:NAME`; one that only publishes is nobody's alone."""


class SubsystemStanding(Struct, frozen=True):
    """A subsystem as it stands."""

    name: str
    holder: str
    application: str
    """What runs in it; empty: its tasks are held by hand."""
    tasks: tuple[TaskStanding, ...]
    asks: tuple[Asked, ...] = ()
    """What its tasks wait to be told, for whoever comes later or takes it over."""
    on_loss: str = ""
    """Of an application: what becomes of it where its holder is lost, as it was begun (`stop`, `finish`, `run`)."""
    recording: str = ""
    """The file on the runtime's machine into which it is being recorded by hand; empty: it is not."""


class RtpuStanding(Struct, frozen=True):
    """A processing unit: whether it lives, and the share of its time that tasks took at last."""

    name: str
    is_lost: bool
    load: float


class Standing(Struct, frozen=True, tag=True):
    """Everything there is in a runtime."""

    subsystems: tuple[SubsystemStanding, ...]
    rtpus: tuple[RtpuStanding, ...]
    worlds: tuple[str, ...]
    is_virtual: bool
    is_stopped: bool
    now_s: float
    addresses: tuple[str, ...] = ()
    """Where it listens for others; none where it was started for its launcher alone."""
    simulated: tuple[str, ...] = ()
    """Those of `worlds` in which nothing outside the program moves; the others are real."""
    displaced: dict[str, tuple[Displacement, ...]] = {}
    """What does not stand where it stood at the start, by world; nothing is said while an application runs."""
    libraries: tuple[str, ...] = ()
    """The addresses of libraries and dictionaries that it supplies to whoever is connected (requirement C19)."""
