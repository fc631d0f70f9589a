"""What would follow from a fault, as the page shows it (requirement X24)."""

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
