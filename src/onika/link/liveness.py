"""The liveness of a link: its state, the heartbeats of this end, and how long the other end has been silent."""

from onika.link import lost
from onika.link.link_events import LinkNotice, LinkStateChanged
from onika.link.link_terms import LinkTerms
from onika.link.state import LinkEvent, LinkState, follow
from onika.wire.packet import Beat

_NEVER = 2**63
_ALIVE = (LinkState.LINKED, LinkState.SUSPECT)


class Liveness:
    """Judges silence by the clock of this side only; tells every change of state to `notices`."""

    def __init__(self, terms: LinkTerms, notices: list[LinkNotice]) -> None:
        self.state = LinkState.APART
        self._terms = terms
        self._notices = notices
        self.heard_ns = 0
        self._beat_ns = 0
        self._beats = 0

    @property
    def is_linked(self) -> bool:
        """Whether the greeting is complete and the connection not given up."""
        return self.state in _ALIVE

    def turn(self, event: LinkEvent, why: lost.LinkLost | None = None) -> None:
        """Follow the table."""
        old, self.state = self.state, follow(self.state, event)
        if self.state is not old or event is LinkEvent.OPENED:
            self._notices.append(LinkStateChanged(self.state, why))

    def opened(self, now_ns: int) -> None:
        """A new connection; its greeting must be complete in time."""
        self.heard_ns = now_ns
        self.turn(LinkEvent.OPENED)

    def greeted(self, now_ns: int) -> None:
        """The greeting is complete: beats begin."""
        self.heard_ns = now_ns
        self._beat_ns = now_ns
        self._beats = 0
        self.turn(LinkEvent.GREETED)

    def note_arrival(self, now_ns: int) -> None:
        """The other side said something."""
        self.heard_ns = now_ns
        if self.is_linked:
            self.turn(LinkEvent.HEARD)

    def listen(self, now_ns: int) -> lost.LinkLost | None:
        """How the silence is judged now; a link that is lost is reported and left to the caller to end."""
        silence_ns = now_ns - self.heard_ns
        limit_ns = self._terms.greeting_ns if self.state is LinkState.GREETING else self._terms.lost_ns
        if self.state in (*_ALIVE, LinkState.GREETING) and limit_ns and silence_ns >= limit_ns:
            return lost.silent(silence_ns / 1e9)
        if self.state is LinkState.LINKED and self._terms.suspect_ns and silence_ns >= self._terms.suspect_ns:
            self.turn(LinkEvent.QUIET)
        return None

    def beat(self, now_ns: int) -> Beat | None:
        """The beat that is due now; beats that were missed are not made up for."""
        if not self.is_linked or not self._terms.beat_ns or now_ns < self._beat_ns:
            return None
        self._beat_ns = now_ns + self._terms.beat_ns
        self._beats += 1
        return Beat(self._beats, now_ns)

    def due_ns(self, now_ns: int, may_retry: bool) -> int | None:
        """How long until time alone changes something; None: not before something else happens.

        may_retry   whether something is under way that could have to be said again
        """
        terms, state = self._terms, self.state
        if state is LinkState.APART or state is LinkState.ENDED:
            return None
        is_greeting = state is LinkState.GREETING
        first_ns = terms.suspect_ns if state is LinkState.LINKED else 0
        silence_ns = first_ns or (terms.greeting_ns if is_greeting else terms.lost_ns)
        at_ns = self.heard_ns + silence_ns if silence_ns else _NEVER
        if terms.beat_ns and not is_greeting:
            at_ns = min(at_ns, self._beat_ns)
        if terms.retry_ns and (may_retry or is_greeting):
            at_ns = min(at_ns, now_ns + terms.retry_ns)
        return None if at_ns == _NEVER else max(0, at_ns - now_ns)
