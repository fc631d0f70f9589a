"""The seat of a class, as its page is shown it (requirement X25)."""

from typing import Literal

from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason

SeatState = Literal["works", "frozen", "taken"]
"""The learner works; nobody does; the teacher does in his place."""


class ClassSeatView(View, frozen=True):
    """A seat, and whose it is."""

    number: int
    learner: str
    state: SeatState = "works"
    note: str = ""
    """What the teacher said last, in his words; empty: nothing, or it was put away."""
    note_number: int = 0
    """Grows with each note."""
    handed_in: int = 0
    """How often its learner has handed in."""
    grade: tuple[int, int] | None = None
    """Of what was handed in last: how many expectations hold, of how many; None: it is not graded."""
    began_anew: Reason = NOTHING
    """Why its former process ended, so that its workcell stands as at first; nothing: there was none."""
