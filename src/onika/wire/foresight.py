"""What if? A fault that could come now, and what would follow from it (requirement X24); asking changes nothing."""

from msgspec import Struct

from onika.words.reason import Reason


class WhatIf(Struct, frozen=True, tag=True):
    """Ask what follows from a fault now, or at the first step of the plan that was prepared; replied by Foreseen.

    With an empty fault the questions are replied with that can be asked. The subject may be left out where there is
    one only.
    """

    fault: str = ""
    subject: str = ""
    """Whom it concerns: `SUBSYSTEM/TASK`, `WORLD:DEVICE`, a unit, a session, `SUBSYSTEM/VARIABLE`."""
    is_planned: bool = False
    on_loss: str = "stop"
    """How the plan would be begun; see `request.Begin`."""
    on_error: str = "abort"


class Effect(Struct, frozen=True):
    """One thing that changes."""

    within_ms: float
    """At the latest so long after the fault."""
    kind: str
    """`task`, `drive`, `flow`, `run`, `subsystem`, `unit`, `runtime` or `recording`."""
    subject: str
    before: str
    after: str
    text: Reason
    told: str = ""
    """The event by which all hear of it who attend; empty: nobody is told."""


class Foresight(Struct, frozen=True):
    """One fault and what follows; without an answer it was only asked what can be asked."""

    fault: str
    subject: str
    question: Reason
    answer: Reason | None = None
    effects: tuple[Effect, ...] = ()
    """In the order in which they come."""
    to_do: tuple[Reason, ...] = ()
    """What a person has to do then; nothing else comes back by itself."""
    notes: tuple[Reason, ...] = ()
    """What is worth knowing besides."""


class Foreseen(Struct, frozen=True, tag=True):
    """What can be asked, or what was asked with its answers."""

    foresights: tuple[Foresight, ...]
