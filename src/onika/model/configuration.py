"""A configuration: tasks assembled on the canvas to do one job (dissertation §5.3, §A.2)."""

from dataclasses import dataclass

UNKNOWN_RTPU = "unknown"
"""The RTPU of a task that was never spawned (decision 12)."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A task on the canvas; x and y are pixels of its upper left corner."""

    task: str
    x: int = 0
    y: int = 0
    in_left: bool = True
    """Whether the inputs are on the left side of its icon."""
    frequency: float = 0.0
    """Hz, in place of the rate of the task's own file; 0: not given, or the task is aperiodic."""
    rtpu: str = UNKNOWN_RTPU


@dataclass(frozen=True, slots=True)
class Locus:
    """Where the lines of one state variable meet: its corner in pixels and the pins that use it.

    An INBOTH counts in `double_in` only, an OUTBOTH in `outconst` only (decision 7).
    """

    svar: str
    x: int = 0
    y: int = 0
    conns: int = 0
    """How many tasks are connected."""
    inconst: int = 0
    outconst: int = 0
    invar: int = 0
    outvar: int = 0
    double_in: int = 0
    show: bool = True
    """Whether its connections are drawn."""


@dataclass(frozen=True, slots=True)
class Configuration:
    """What a `.conf` file says, in the file's order."""

    name: str
    placed: tuple[Placed, ...] = ()
    loci: tuple[Locus, ...] = ()
