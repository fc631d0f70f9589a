"""A rendezvous: flows of one application that run on several runtimes meet at a synchronisation tag.

One runtime proposes a time, all commit themselves to it beforehand, each begins then by itself, and whoever has not
heard soon after that all others have begun is held. No protocol over a line that may be cut can promise that nobody
ever begins alone; this one promises that nobody begins before all are there, that who begin together begin within twice
the error of their clocks, that nobody is driven on alone for longer than the terms say, and that nobody goes on to the
step after a tag that another has not begun (decision 56). No I/O, no clock.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from onika.engine.rendezvous_orders import (
    AllMet,
    Alone,
    Appoint,
    Confirm,
    HoldNow,
    MeetAgain,
    Permit,
    RendezvousOrder,
    RepeatStep,
    Revoke,
)
from onika.engine.rendezvous_terms import LATE_NS, RendezvousTerms
from onika.wire.rendezvous import Phase, TagState

_ARMED = frozenset({Phase.ARMED, Phase.COMMITTED})
_COMMITTED = frozenset({Phase.COMMITTED, Phase.GO, Phase.MET})
_RESTS = frozenset({Phase.WAIT, Phase.STOPPED})
_NOT_THERE = TagState()


class Rendezvous:
    """The part of one runtime, `site`, in all meetings at one tag with the runtimes `others`.

    here    the time of another runtime's clock by the own one: its number, its time, now; None where nothing is known

    Every verb takes the time of the own clock in ns and returns what is to be done, in order.
    """

    def __init__(
        self,
        site: int,
        others: Iterable[int],
        terms: RendezvousTerms,
        here: Callable[[int, int, int], int | None],
    ) -> None:
        self.site = site
        self.state = TagState()
        """What the others are told."""
        self.at_ns = 0
        """When it begins, by the own clock."""
        self._others = tuple(sorted(others))
        self._terms = terms
        self._here = here
        self._heard: dict[int, tuple[int, TagState]] = {}
        self._dead = 0
        self._is_permitted = False
        self._is_leaving = False
        self._is_clearing = False

    # What the flows do

    @property
    def is_bound(self) -> bool:
        """Whether the flows are about to begin, or have begun and do not know yet whether all have."""
        return self.state.phase in (Phase.COMMITTED, Phase.GO)

    def come(self, now_ns: int) -> list[RendezvousOrder]:
        """All flows of this runtime that meet at the tag are there, for the next time."""
        self.state = TagState(Phase.WAIT, self.state.visit + 1, self.state.attempt)
        return self.look(now_ns)

    def leave(self, now_ns: int) -> list[RendezvousOrder]:
        """They are not there any more, and have not been; they come again, or go elsewhere."""
        phase = self.state.phase
        self._is_clearing = False
        if phase is Phase.COMMITTED:
            self._is_leaving = True
            return [Revoke(self.state.attempt)]
        if phase in (Phase.WAIT, Phase.ARMED):
            return self._go_away()
        if phase is Phase.STOPPED:  # they had begun: they have been there
            self.state = replace(self.state, phase=Phase.MET, was_passed=True)
        return []

    def let_pass(self, now_ns: int) -> list[RendezvousOrder]:
        """They go on without the others, and count as having been there; not while they are bound."""
        is_armed = self.state.phase is Phase.ARMED
        self._is_clearing = False
        self.state = replace(self.state, phase=Phase.MET, was_passed=True, has_begun=False)
        return [Revoke(self.state.attempt)] if is_armed else []

    def clear(self, now_ns: int) -> list[RendezvousOrder]:
        """The user has seen that they are held, and wants them to begin again."""
        self._is_clearing = self.state.phase is Phase.STOPPED
        return self.look(now_ns)

    # What came of what was armed

    def begun(self, attempt: int, now_ns: int) -> list[RendezvousOrder]:
        """They have begun, at the time or up to `LATE_NS` after it."""
        if self.state.phase is not Phase.COMMITTED or attempt != self.state.attempt:
            return []
        self._is_permitted = False
        self.state = replace(self.state, phase=Phase.GO, has_begun=True)
        if self._is_leaving:
            return self._stop()
        return self.look(now_ns)

    def missed(self, attempt: int, now_ns: int) -> list[RendezvousOrder]:
        """They have not begun, and will not with this attempt."""
        if self.state.phase is not Phase.COMMITTED or attempt != self.state.attempt:
            return []
        if self._is_leaving:
            return self._go_away()
        self._forget_attempt()
        return self.look(now_ns)

    def held(self, attempt: int, now_ns: int) -> list[RendezvousOrder]:
        """What had begun is held: nobody had said in time that all others have begun."""
        if self.state.phase not in (Phase.GO, Phase.MET) or attempt != self.state.attempt:
            return []
        self.state = replace(self.state, phase=Phase.STOPPED)
        return [Alone(self.absent())]

    # What others say, and time

    def hear(self, site: int, state: TagState, now_ns: int) -> list[RendezvousOrder]:
        """The newest of what another runtime says."""
        self._heard[site] = (now_ns, state)
        return self.look(now_ns)

    def look(self, now_ns: int) -> list[RendezvousOrder]:
        """What follows from what is heard and from the time."""
        match self.state.phase:
            case Phase.WAIT:
                return self._look_waiting(now_ns)
            case Phase.ARMED:
                return self._look_armed(now_ns)
            case Phase.COMMITTED:
                return self._look_committed(now_ns)
            case Phase.GO:
                return self._look_begun(now_ns)
            case Phase.STOPPED if self._is_clearing:
                return self._look_cleared(now_ns)
        return []

    def due_ns(self) -> int | None:
        """When time alone changes something."""
        return self.at_ns - self._terms.commit_ns if self.state.phase is Phase.ARMED else None

    def absent(self) -> tuple[int, ...]:
        """The runtimes for which these flows wait, or of which it is not heard that they have begun."""
        if self.state.phase in (Phase.WAIT, Phase.ARMED, Phase.COMMITTED):
            return tuple(site for site in self._needed() if self._of(site).visit < self.state.visit)
        return tuple(site for site in self._needed() if not self._began(self._of(site)))

    # Phase by phase

    def _look_waiting(self, now_ns: int) -> list[RendezvousOrder]:
        needed = self._needed()
        if not needed:
            self.state = replace(self.state, phase=Phase.MET, was_passed=True)
            return [AllMet(is_free=True)]
        convenor = min(needed)
        if self.site < convenor:
            return self._propose(needed, now_ns)
        return self._follow(convenor, now_ns)

    def _propose(self, needed: Sequence[int], now_ns: int) -> list[RendezvousOrder]:
        if not all(self._is_near(site, now_ns) and self._waits(self._of(site)) for site in needed):
            return []
        attempt = max(self.state.attempt, self._dead, *(self._of(site).attempt for site in needed)) + 1
        return self._arm(attempt, self.site, now_ns + self._terms.lead_ns, now_ns + self._terms.lead_ns)

    def _follow(self, convenor: int, now_ns: int) -> list[RendezvousOrder]:
        proposal = self._of(convenor)
        fits = proposal.visit == self.state.visit and proposal.convenor == convenor
        if not fits or proposal.phase is not Phase.ARMED or proposal.attempt <= self._dead:
            return []
        at_ns = self._here(convenor, proposal.at_ns, now_ns)
        if at_ns is None or now_ns >= at_ns - self._terms.commit_ns:
            return []
        return self._arm(proposal.attempt, convenor, proposal.at_ns, at_ns)

    def _arm(self, attempt: int, convenor: int, proposed_ns: int, at_ns: int) -> list[RendezvousOrder]:
        self.state = TagState(Phase.ARMED, self.state.visit, attempt, convenor, proposed_ns)
        self.at_ns = at_ns
        return [Appoint(attempt, at_ns)]

    def _look_armed(self, now_ns: int) -> list[RendezvousOrder]:
        commit_ns = self.at_ns - self._terms.commit_ns
        if now_ns < commit_ns:
            return []
        others = [self._of(site) for site in self._needed()]
        if now_ns <= commit_ns + LATE_NS and all(self._is_same(other) and other.phase in _ARMED for other in others):
            self.state = replace(self.state, phase=Phase.COMMITTED)
            return self._look_committed(now_ns)
        attempt = self.state.attempt
        self._forget_attempt()
        return [Revoke(attempt)]

    def _look_committed(self, now_ns: int) -> list[RendezvousOrder]:
        """Whether it begins is decided where it begins: there alone what is late is late."""
        is_permitted = not self._is_leaving and all(self._is_committed(self._of(site)) for site in self._needed())
        if is_permitted is self._is_permitted:
            return []
        self._is_permitted = is_permitted
        return [Permit(self.state.attempt) if is_permitted else Revoke(self.state.attempt)]

    def _look_begun(self, now_ns: int) -> list[RendezvousOrder]:
        if now_ns >= self.at_ns + self._terms.alone_ns:
            return []  # it is held by itself, and says so
        others = [self._of(site) for site in self._needed()]
        if all(self._began(other) for other in others):
            self.state = replace(self.state, phase=Phase.MET)
            return [Confirm(self.state.attempt), AllMet()]
        return [] if all(self._is_committed(other) for other in others) else self._stop()

    def _stop(self) -> list[RendezvousOrder]:
        self._is_leaving = False
        self.state = replace(self.state, phase=Phase.STOPPED)
        return [HoldNow(self.state.attempt), Alone(self.absent())]

    def _look_cleared(self, now_ns: int) -> list[RendezvousOrder]:
        others = [self._of(site) for site in self._needed()]
        if all(self._began(other) for other in others):
            self._is_clearing = False
            self.state = replace(self.state, phase=Phase.MET)
            return [RepeatStep(), AllMet()]
        if not all(self._rests(other) for other in others):
            return []
        self._is_clearing = False
        self._forget_attempt()
        return [MeetAgain(), *self.look(now_ns)]

    # Of others

    def _of(self, site: int) -> TagState:
        heard = self._heard.get(site)
        return _NOT_THERE if heard is None else heard[1]

    def _needed(self) -> list[int]:
        """The runtimes that have not been at the tag for this visit, by what is heard."""
        visit = self.state.visit
        states = ((site, self._of(site)) for site in self._others)
        return [site for site, other in states if not (other.visit > visit or _has_passed(other, visit))]

    def _is_near(self, site: int, now_ns: int) -> bool:
        heard = self._heard.get(site)
        return heard is not None and now_ns - heard[0] < self._terms.near_ns

    def _waits(self, other: TagState) -> bool:
        return other.visit == self.state.visit and other.phase is Phase.WAIT

    def _is_same(self, other: TagState) -> bool:
        """Whether it speaks of the present attempt."""
        state = self.state
        is_same = other.visit == state.visit and other.attempt == state.attempt
        return is_same and other.convenor == state.convenor and other.at_ns == state.at_ns

    def _began(self, other: TagState) -> bool:
        return self._is_same(other) and other.has_begun

    def _is_committed(self, other: TagState) -> bool:
        return self._is_same(other) and (other.phase in _COMMITTED or other.has_begun)

    def _rests(self, other: TagState) -> bool:
        """Whether it can be met anew: it is at the tag and stands, or has left it without having been there."""
        visit = self.state.visit
        is_there = other.visit == visit and other.phase in _RESTS
        return is_there or (other.visit == visit - 1 and other.phase is Phase.AWAY)

    # Back

    def _forget_attempt(self) -> None:
        """Wait on; nobody can begin with this attempt here any more."""
        self._dead = max(self._dead, self.state.attempt)
        self._is_permitted = False
        self.state = TagState(Phase.WAIT, self.state.visit, self.state.attempt)

    def _go_away(self) -> list[RendezvousOrder]:
        is_armed = self.state.phase is Phase.ARMED
        self._forget_attempt()
        self._is_leaving = False
        self.state = TagState(Phase.AWAY, self.state.visit - 1, self.state.attempt)
        return [Revoke(self.state.attempt)] if is_armed else []


def _has_passed(other: TagState, visit: int) -> bool:
    return other.visit == visit and other.was_passed
