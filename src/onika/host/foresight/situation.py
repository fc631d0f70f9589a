"""A situation: everything that decides what follows from a fault, as it stands at one instant (requirement X24).

It is a value: whoever asks what would follow changes nothing of the runtime.
"""

import ast
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache

from onika.engine.engine import Engine
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.ring.drive import DriveMode
from onika.runtime.wiring import WiredTask
from onika.wire.plan import PlannedFlow

Address = tuple[str, str]
"""Subsystem and task."""

_OUTSIDE = ("PARTNER", "STARTS")
_LOOKS = {
    "check_drive": frozenset((DriveState.TRIPPED, DriveState.PRESSED)),
    "is_tripped": frozenset((DriveState.TRIPPED,)),
    "is_pressed": frozenset((DriveState.PRESSED,)),
}
"""What a module reads of its device's drive, and the states in which it then gives up."""


@dataclass(frozen=True, slots=True)
class ForeseenTask:
    """A task: its state, its unit, its ports, and the states of its drive at which its module looks."""

    subsystem: str
    wired: WiredTask
    state: State
    unit: str
    frequency: float | None
    looks_at: frozenset[DriveState] = frozenset()

    @property
    def address(self) -> Address:
        """Subsystem and name."""
        return self.subsystem, self.wired.name

    @property
    def device(self) -> str:
        """The device that it commands; empty: none."""
        is_hardware = self.wired.sheet.hardware
        return (self.wired.device or "") if is_hardware else ""

    @property
    def has_partner(self) -> bool:
        """Whether it talks with a program outside Onika."""
        return any(key in _OUTSIDE for key, _ in self.wired.task.local)

    def at(self, frequency: float) -> "ForeseenTask":
        """The same at another rate."""
        return replace(self, frequency=frequency)

    @property
    def period_ms(self) -> float:
        """How long one cycle of it lasts; 0 where it has no rate."""
        return 1000.0 / self.frequency if self.frequency else 0.0


@dataclass(frozen=True, slots=True)
class RunFacts:
    """An application that runs, or is planned: who began it, its flows, and its engine as it stands."""

    application: str
    session: str
    on_loss: str
    flows: tuple[PlannedFlow, ...]
    engine: Engine

    @property
    def subsystems(self) -> tuple[str, ...]:
        """One for each flow."""
        return tuple(flow.subsystem for flow in self.flows)


@dataclass(frozen=True, slots=True)
class SessionFacts:
    """A session: for how long it may be silent (0: for ever), and whether it launched the runtime."""

    lease_ms: float = 0.0
    is_launcher: bool = False


@dataclass(frozen=True, slots=True)
class Situation:
    """The runtime at an instant, or what it would be at the first step of a plan."""

    tasks: Mapping[Address, ForeseenTask]
    modes: Mapping[str, DriveMode]
    """How each drive stands, by `world:device`."""
    runs: tuple[RunFacts, ...] = ()
    holders: Mapping[str, str] = field(default_factory=dict)
    """Who holds each subsystem that is held by hand."""
    sessions: Mapping[str, SessionFacts] = field(default_factory=dict)
    records: str = ""
    """The application that is recorded."""
    is_stopped: bool = False

    def run_of(self, subsystem: str) -> int | None:
        """The number of the run in a subsystem."""
        return next((number for number, run in enumerate(self.runs) if subsystem in run.subsystems), None)


@cache
def looked_at(source: str) -> frozenset[DriveState]:
    """The states of a drive at which the code of a module looks, to give up then."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError):
        return frozenset()
    names = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    return frozenset(state for name, states in _LOOKS.items() if name in names for state in states)
