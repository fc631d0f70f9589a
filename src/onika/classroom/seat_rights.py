"""What may be done at a seat of a class, by whom: what reaches beyond the seat, or writes code, is closed (X25).

A learner has a workcell of his own, and may do all that concerns it; also end its runtime and start it anew. The
teacher looks, until he takes the seat. Stop is everybody's, always. An act that stands in no row is nobody's.
"""

from onika.web.access.act_rights import LEAST, WATCHING
from onika.web.access.entrance import Visitor
from onika.wire import act
from onika.wire.view import SeatState
from onika.words.reason import NOTHING, Reason

_ABROAD: frozenset[type] = frozenset(
    (
        *(act.AddStation, act.RemoveStation, act.SetButton, act.Press, act.Halt),
        *(act.TakeLibrary, act.DropLibrary, act.GiveLibraryRights, act.ListRemoteLibraries, act.BrowseLibrary),
        *(act.LookAtNetwork, act.AddPlace, act.DropPlace, act.TrustSite),
    )
)
"""Other machines, and commands of the system."""

_CODE: frozenset[type] = frozenset((act.WriteText, act.NewModule))
"""What brings code that was not there."""

_QUIET: frozenset[type] = frozenset((act.Note,))
"""What a page says by itself, whatever stands."""


class SeatRights:
    """The rights at one seat."""

    def __init__(self, *, may_write_code: bool) -> None:
        self._closed = _ABROAD if may_write_code else _ABROAD | _CODE
        self.state: SeatState = "works"

    @property
    def closed(self) -> Reason:
        """Why its learner may do nothing now; empty: he works."""
        if self.state == "works":
            return NOTHING
        return Reason.of("class.learner_frozen" if self.state == "frozen" else "class.learner_taken")

    def refusal(self, visitor: Visitor, command: act.AnyAct) -> Reason:
        """Why he may not do it; empty: he may."""
        kind = type(command)
        if kind in WATCHING or kind in _QUIET:
            return NOTHING
        if kind not in LEAST or kind in self._closed or (isinstance(command, act.Connect) and command.url):
            return Reason.of("class.code_closed" if kind in _CODE else "class.act_closed")
        if _is_learner(visitor):
            return self.closed
        return NOTHING if self.state == "taken" else Reason.of("class.teacher_watches")


def _is_learner(visitor: Visitor) -> bool:
    return visitor.session == "learner"
