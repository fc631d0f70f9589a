"""How a running application is steered, flow by flow (requirements E07, E08, E13); each is replied by Done or Refused.

A flow is named by its subsystem; an empty name means every flow of the one application that runs.
"""

from msgspec import Struct

from onika.wire.plan import Index


class Pause(Struct, frozen=True, tag=True):
    """Pause after the current action; a flow that waits at a tag pauses at once, and is waited for."""

    subsystem: str = ""


class Resume(Struct, frozen=True, tag=True):
    """Go on after a pause, or take a pause back that has not come yet."""

    subsystem: str = ""


class Step(Struct, frozen=True, tag=True):
    """Carry out one action and pause after it."""

    subsystem: str = ""


class Skip(Struct, frozen=True, tag=True):
    """Leave the current action at once and go to this one; none: to the next. Nothing else is carried out between."""

    subsystem: str
    action: Index | None = None


class Pass(Struct, frozen=True, tag=True):
    """Let a flow that waits at a tag, or for nested flows, go on alone."""

    subsystem: str


class Leave(Struct, frozen=True, tag=True):
    """Leave the innermost loop at its next test, whatever that says."""

    subsystem: str


class Mark(Struct, frozen=True, tag=True):
    """Set or remove the breakpoint after an action, for this run; with a condition it pauses only where that holds."""

    subsystem: str
    action: Index
    is_set: bool = True
    condition: str = ""


class Recover(Struct, frozen=True, tag=True):
    """Clear the tasks in error and repeat the step: the trigger comes on anew with the same target (E08)."""

    subsystem: str = ""


class Onward(Struct, frozen=True, tag=True):
    """Let the clock of a held run go on, to the next thing that happens or to this time; then the event Stood comes."""

    until_s: float | None = None
    """Seconds since the run's start."""


class Who(Struct, frozen=True, tag=True):
    """Ask where every flow is and who waits for whom (X03); replied by Positions."""


class Position(Struct, frozen=True):
    """Where a flow is."""

    subsystem: str
    state: str
    """One of the words of `engine.flow.FlowState`."""
    action: int
    """The current action, or the last one; -1 before the first."""
    tag: str = ""
    """Where it waits."""
    waits_for: tuple[str, ...] = ()
    """The subsystems of the flows it waits for."""
    is_pausing: bool = False
    """Whether it will pause after its current action."""
    loops: tuple[str, ...] = ()
    """The loops it is in, outermost first."""
    failed: tuple[str, ...] = ()
    """The tasks in error that it stands still for."""
    breakpoints: tuple[int, ...] = ()
    """The actions after which it would pause."""


class Positions(Struct, frozen=True, tag=True):
    """Every flow of every application that runs, or of the asker's."""

    flows: tuple[Position, ...]


Steering = Pause | Resume | Step | Skip | Pass | Leave | Mark | Recover
SteerRequest = Steering | Onward | Who
