"""What would follow from a fault, and what a program would come to, as the page shows it (requirements X24, E16)."""

from typing import Any

from onika.wire.view.view import View
from onika.words.reason import Reason


class EffectView(View, frozen=True):
    """One thing that changes, at the latest so long after the fault."""

    within_ms: float
    kind: str
    """`task`, `drive`, `flow`, `run`, `subsystem`, `unit`, `runtime` or `recording`."""
    subject: str
    before: str
    after: str
    text: Reason
    is_told: bool = False
    """Whether all hear of it who attend."""


class ForesightView(View, frozen=True):
    """A fault that could come; what follows, where that was asked."""

    fault: str
    subject: str
    question: Reason
    answer: Reason | None = None
    effects: tuple[EffectView, ...] = ()
    """In the order in which they come."""
    to_do: tuple[Reason, ...] = ()
    notes: tuple[Reason, ...] = ()


class ForesightsView(View, frozen=True):
    """The faults that can be asked about, or the one that was asked."""

    foresights: tuple[ForesightView, ...] = ()


class ForeseenInstantView(View, frozen=True):
    """How a workcell stands when something happens that is foreseen (E16)."""

    world: str
    at_s: float
    text: Reason
    scene: dict[str, Any]
    """As the value of `act.Scene`."""
    poses: str
    """The rows of its bodies as `page.Frame` has them: float32 numbers in base64."""
    lit: tuple[str, ...] = ()
