"""The requests that wait until the loader has answered, and those that wait behind them, in the order they came."""

from collections.abc import Callable
from typing import get_args

from onika.host.sessions.request_server import SessionRequest
from onika.wire import holding, live, request
from onika.wire.samples import Sample

_AT_ONCE = (
    *(request.Stop, live.Reset, request.Abort, request.Quit, live.Survey, live.Read, live.Attend),
    *(live.Touch, live.Push, Sample),
    *get_args(holding.HoldingRequest),
)
"""What never waits behind another request."""
_ASIDE = (live.Describe, live.Solve)
"""What nobody waits behind: it asks what code says of itself."""

Answer = Callable[[request.Response], None]


class Backlog:
    """What was asked and is not carried out yet, each with who is to be told."""

    def __init__(self) -> None:
        self._waiting: list[tuple[SessionRequest, Answer]] = []

    @property
    def is_waiting(self) -> bool:
        """Whether anything waits."""
        return bool(self._waiting)

    def is_before(self, call: SessionRequest) -> bool:
        """Whether something waits that this session asked earlier, but of what code says: then this waits too."""
        if isinstance(call.asked, _AT_ONCE):
            return False
        return any(
            waiting_call.session == call.session and not isinstance(waiting_call.asked, _ASIDE)
            for waiting_call, _ in self._waiting
        )

    def keep(self, call: SessionRequest, answer: Answer) -> None:
        """It waits, behind all others."""
        self._waiting.append((call, answer))

    def take(self) -> list[tuple[SessionRequest, Answer]]:
        """All that waits, to be tried again; what still cannot be carried out is kept anew."""
        waiting, self._waiting = self._waiting, []
        return waiting
