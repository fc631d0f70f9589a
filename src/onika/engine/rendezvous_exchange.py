"""The exchange of one runtime with the others that carry out flows of the same application: reports go and come.

Every report is whole, so that a lost one is made up for by the next; one that was overtaken counts no more, and what is
said by another life of a runtime than the one in which the run was begun never counts.
"""

from collections.abc import Mapping, Sequence

from onika.engine.clock_estimate import ClockEstimate
from onika.engine.rendezvous import Rendezvous
from onika.engine.rendezvous_orders import RendezvousOrder
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.wire.rendezvous import RendezvousReport, TagState

TagOrder = tuple[int, RendezvousOrder]
"""The number of a tag, and what is to be done there."""

_NOT_SHARED = TagState()


class _Peer:
    """What is heard of another runtime."""

    def __init__(self, epoch: int) -> None:
        self.epoch = epoch
        self.count = 0
        self.sent_ns = 0
        self.came_ns = 0
        self.clock = ClockEstimate()


class RendezvousExchange:
    """Of one run. `epochs` are those of all its runtimes by their numbers, `tags` who meets at each tag."""

    def __init__(
        self,
        run: bytes,
        site: int,
        epochs: Mapping[int, int],
        tags: Sequence[Sequence[int]],
        terms: RendezvousTerms,
        rendezvous: type[Rendezvous] = Rendezvous,
    ) -> None:
        self.is_stopped = False
        """Whether everything of the run is to stop, which all others are told."""
        self._run = run
        self._terms = terms
        self._site = site
        self._epoch = epochs[site]
        self._peers = {other: _Peer(epoch) for other, epoch in epochs.items() if other != site}
        self.meetings: dict[int, Rendezvous] = {}
        """By tag, this runtime's part in its meetings."""
        for tag, sites in enumerate(tags):
            if site in sites:
                others = [other for other in sites if other != site]
                self.meetings[tag] = rendezvous(site, others, terms, self._here)
        self._size = len(tags)
        self._sites = tuple(tags)

    def with_terms(self, terms: RendezvousTerms) -> "RendezvousExchange":
        """The same exchange on other terms, before anything was agreed; what was learned of the others stays."""
        epochs = {self._site: self._epoch, **{other: peer.epoch for other, peer in self._peers.items()}}
        made = RendezvousExchange(self._run, self._site, epochs, self._sites, terms)
        made._peers = self._peers
        return made

    @property
    def others(self) -> tuple[int, ...]:
        """The numbers of the other runtimes."""
        return tuple(self._peers)

    def report(self, other: int, now_ns: int) -> RendezvousReport:
        """All that is to be said to another runtime now."""
        peer = self._peers[other]
        meetings = self.meetings
        states = [meetings[tag].state if tag in meetings else _NOT_SHARED for tag in range(self._size)]
        return RendezvousReport(
            self._run, self._epoch, self._site, now_ns, peer.sent_ns, peer.came_ns, tuple(states), self.is_stopped
        )

    def hear(self, count: int, report: RendezvousReport, now_ns: int) -> list[TagOrder]:
        """A report came, the `count`-th that was sent to this runtime."""
        peer = self._peers.get(report.site)
        if peer is None or not self._counts(peer, count, report):
            return []
        peer.count, peer.sent_ns, peer.came_ns = count, report.sent_ns, now_ns
        peer.clock.came(report.sent_ns, now_ns)
        if report.echo_sent_ns:
            peer.clock.went(report.echo_sent_ns, report.echo_ns, now_ns)
        self.is_stopped |= report.is_stopped
        orders: list[TagOrder] = []
        for tag, meeting in self.meetings.items():
            orders += [(tag, order) for order in meeting.hear(report.site, report.tags[tag], now_ns)]
        return orders

    def look(self, now_ns: int) -> list[TagOrder]:
        """What follows from the time."""
        return [(tag, order) for tag, meeting in self.meetings.items() for order in meeting.look(now_ns)]

    def due_ns(self) -> int | None:
        """When time alone changes something."""
        dues = (meeting.due_ns() for meeting in self.meetings.values())
        return min((due for due in dues if due is not None), default=None)

    def clock(self, other: int) -> ClockEstimate:
        """How the clock of another runtime stands."""
        return self._peers[other].clock

    def silent_ns(self, other: int, now_ns: int) -> int | None:
        """How long another runtime has not been heard; None: it never was."""
        came_ns = self._peers[other].came_ns
        return now_ns - came_ns if came_ns else None

    def _counts(self, peer: _Peer, count: int, report: RendezvousReport) -> bool:
        """Whether it is news of the same run and life."""
        is_of_run = report.run == self._run and len(report.tags) == self._size
        return is_of_run and report.epoch == peer.epoch and count > peer.count

    def _here(self, other: int, there_ns: int, now_ns: int) -> int | None:
        """Nothing is known of a clock that may be misjudged by more than the terms say."""
        clock = self._peers[other].clock
        bound_ns = clock.bound_ns(now_ns)
        is_sure = bound_ns is not None and bound_ns <= self._terms.clock_ns
        return clock.here(there_ns, now_ns) if is_sure else None
