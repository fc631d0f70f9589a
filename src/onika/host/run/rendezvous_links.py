"""The ways of a runtime to those that carry out other flows of an application, from the first pact to after the run."""

import secrets
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import count
from typing import Protocol

from onika.engine.rendezvous_exchange import RendezvousExchange
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.host.run.run_rendezvous import AppointedUnits, RunRendezvous
from onika.link.datagrams.pact import KEY, NAME, Pact
from onika.link.datagrams.rendezvous_channel import Correspondent, RendezvousChannel, RendezvousSocket
from onika.wire.rendezvous import MOST_TAGS
from onika.wire.rendezvous_link import Linked, LinkRuntimes, MeetingTerms, OfferPact, PactOffered, Way
from onika.wire.request import Refused, Response
from onika.words.reason import NOTHING, Reason, reason_of
from onika.words.system_error import system_reason

HEARD_NS = 700_000_000
"""So long all others are listened to before it is said how far they are."""
UNHEARD_NS = 3_000_000_000
"""After so long it is said who was not heard."""
LINGER_NS = 3_000_000_000
"""So long after a run others still hear how it stood."""
_RUN = 16
_NO_TERMS = RendezvousTerms(0, 0)


class LinkedDriver(Protocol):
    """What is asked of a runtime's driver."""

    @property
    def is_virtual(self) -> bool:
        """Whether its clock is no other one's."""
        ...

    @property
    def now(self) -> int:
        """The runtime's own clock in ns."""
        ...


@dataclass(slots=True)
class _Link:
    """What a session has linked for its next run."""

    socket: RendezvousSocket
    epoch: int
    asked: LinkRuntimes | None = None
    channel: RendezvousChannel | None = None
    answer: Callable[[Linked], None] | None = None
    since_ns: int = 0
    titles: dict[int, str] = field(default_factory=dict)


class RendezvousLinks:
    """By session. `now` is always the runtime's own clock in ns."""

    def __init__(self) -> None:
        self._links: dict[str, _Link] = {}
        self._lingering: list[tuple[int, RendezvousChannel]] = []
        self._running: list[RendezvousChannel] = []
        self._numbers: Iterator[int] = count(1)

    def ask(
        self, session: str, asked: OfferPact | LinkRuntimes, driver: LinkedDriver, answer: Callable[[Response], None]
    ) -> None:
        """Carry out what a session asks."""
        if driver.is_virtual:
            answer(Refused(Reason.of("host.wall_time_only")))
        elif isinstance(asked, LinkRuntimes):
            self.link(session, asked, driver.now, answer)
        else:
            try:
                answer(self.offer(session, asked))
            except ValueError as wrong:
                answer(Refused(reason_of(wrong)))

    def offer(self, session: str, asked: OfferPact) -> PactOffered:
        """A new pact for the next run of a session; raises ValueError where nothing can be heard at the address."""
        self.forget(session)
        try:
            socket = RendezvousSocket(asked.host)
        except OSError as wrong:
            raise ValueError(Reason.of("host.cannot_meet", host=asked.host, why=system_reason(wrong))) from None
        link = self._links[session] = _Link(socket, secrets.randbits(63))
        return PactOffered(socket.port, socket.pact.name, socket.pact.key, link.epoch)

    def link(self, session: str, asked: LinkRuntimes, now: int, answer: Callable[[Linked], None]) -> None:
        """Listen to these runtimes; answered when all were heard, or somebody was not for too long."""
        link = self._links.get(session)
        refusal = Reason.of("host.no_pact") if link is None else _objection(asked)
        if refusal or link is None:
            answer(Linked((), refusal))
            return
        epochs = {asked.site: link.epoch, **{partner.site: partner.epoch for partner in asked.partners}}
        exchange = RendezvousExchange(asked.run, asked.site, epochs, [tag.sites for tag in asked.tags], _NO_TERMS)
        others = {
            partner.site: Correspondent(partner.host, partner.port, Pact(partner.name, partner.key))
            for partner in asked.partners
        }
        link.asked, link.answer, link.since_ns = asked, answer, now
        link.titles = {partner.site: partner.title for partner in asked.partners}
        link.channel = RendezvousChannel(link.socket, exchange, others)

    def objection(self, session: str, terms: MeetingTerms | None) -> Reason:
        """Why no run can begin on these terms; empty: one can."""
        link = self._links.get(session)
        is_linked = link is not None and link.channel is not None and link.answer is None
        return Reason.of("host.not_linked") if terms is not None and not is_linked else NOTHING

    def begin(self, session: str, terms: MeetingTerms | None, units: AppointedUnits) -> RunRendezvous | None:
        """The rendezvous of the run that the session begins; None: all its flows run here."""
        link = self._links.get(session)
        if terms is None or link is None or link.channel is None or link.asked is None:
            self.forget(session)
            return None
        del self._links[session]
        agreed = RendezvousTerms(terms.one_way_ns, terms.clock_ns)
        link.channel.exchange = link.channel.exchange.with_terms(agreed)
        self._running.append(link.channel)
        tags = [tag.tag for tag in link.asked.tags]
        return RunRendezvous(link.channel, tags, link.titles, agreed, units, self._numbers)

    def forget(self, session: str) -> None:
        """What a session has linked is not run any more."""
        link = self._links.pop(session, None)
        if link is not None:
            link.socket.close()

    def end(self, rendezvous: RunRendezvous | None, now: int) -> None:
        """The run is over; others are still told for a while how it stood."""
        if rendezvous is None:
            return
        for channel in [channel for channel in self._running if rendezvous.speaks_by(channel)]:
            self._running.remove(channel)
            self._lingering.append((now + LINGER_NS, channel))

    def stop(self) -> None:
        """Everything stops, also elsewhere: all others of all runs are told."""
        for channel in self._channels():
            channel.exchange.is_stopped = True

    @property
    def is_stopped(self) -> bool:
        """Whether another runtime of a run has said that everything is to stop."""
        return any(channel.exchange.is_stopped for channel in self._running)

    def readers(self) -> list[RendezvousChannel]:
        """What to wait for."""
        return self._channels()

    def due_ns(self, now: int) -> int | None:
        """In how long there is something to do."""
        dues = [channel.due_ns() - now for channel in self._channels()]
        return max(0, min(dues)) if dues else None

    def serve(self, now: int) -> None:
        """Hear and speak where no run does; answer who waits for others to be heard."""
        for link in self._links.values():
            if link.channel is not None:
                _pass(link.channel, now)
                self._answer(link, link.channel, now)
        for until_ns, channel in list(self._lingering):
            _pass(channel, now)
            if now >= until_ns:
                self._lingering.remove((until_ns, channel))
                channel.close()

    def _answer(self, link: _Link, channel: RendezvousChannel, now: int) -> None:
        ways = tuple(_way(channel.exchange, other, now) for other in channel.exchange.others)
        are_heard = all(way.trip_ns >= 0 for way in ways)
        waited_ns = now - link.since_ns
        if link.answer is not None and waited_ns >= (HEARD_NS if are_heard else UNHEARD_NS):
            silent = tuple(link.titles[way.site] for way in ways if way.trip_ns < 0)
            refusal = Reason.of("host.runtimes_unheard", runtimes=silent) if silent else NOTHING
            answer, link.answer = link.answer, None
            answer(Linked(ways, refusal))

    def _channels(self) -> list[RendezvousChannel]:
        linked = [link.channel for link in self._links.values() if link.channel is not None]
        return [*linked, *self._running, *(channel for _, channel in self._lingering)]


def _pass(channel: RendezvousChannel, now: int) -> None:
    channel.receive(now)
    channel.speak(now)


def _way(exchange: RendezvousExchange, other: int, now: int) -> Way:
    clock = exchange.clock(other)
    trip_ns, bound_ns = clock.trip_ns(now), clock.bound_ns(now)
    if trip_ns is None or bound_ns is None:
        return Way(other, -1, -1)
    return Way(other, trip_ns, bound_ns)


def _objection(asked: LinkRuntimes) -> Reason:
    """Why runtimes cannot be linked so; empty: they can."""
    sites = [asked.site, *(partner.site for partner in asked.partners)]
    is_whole = len(asked.run) == _RUN and len(sites) == len(set(sites)) > 1
    are_pacts = all(len(partner.name) == NAME and len(partner.key) == KEY for partner in asked.partners)
    are_tags = len(asked.tags) <= MOST_TAGS and all(
        len(set(tag.sites)) == len(tag.sites) > 1 and set(tag.sites) <= set(sites) for tag in asked.tags
    )
    return NOTHING if is_whole and are_pacts and are_tags else Reason.of("host.no_runtimes_to_meet", most=MOST_TAGS)
