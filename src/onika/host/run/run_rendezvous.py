"""The rendezvous of one run: what its engine, its units and the other runtimes of the application have to do there.

The engine convenes its flows at a tag; the runtimes agree on a time; the units begin then by themselves, and the engine
learns of it. What a unit may do by itself it is told through shared memory, so that nothing has to arrive in time.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

from onika.engine import news as engine_news
from onika.engine.orders import Convene, Disperse
from onika.engine.rendezvous import Rendezvous
from onika.engine.rendezvous_orders import (
    AllMet,
    Alone,
    Appoint,
    Confirm,
    HoldNow,
    Permit,
    RendezvousOrder,
    RepeatStep,
    Revoke,
)
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.host.execution.subsystem_executor import SubsystemExecutor
from onika.host.run.prepared_switch import PreparedSwitches
from onika.host.units.unit_registry import Units
from onika.link.datagrams.rendezvous_channel import RendezvousChannel
from onika.ring.begin_words import BeginWords
from onika.runtime import command, news
from onika.wire.rendezvous import Phase
from onika.words.reason import NOTHING, Reason


class AppointedUnits(Units, Protocol):
    """Units that begin by themselves."""

    def begin_words(self, rtpu: str) -> BeginWords:
        """By which a unit is let begin."""
        ...


@dataclass(slots=True)
class _Attempt:
    """What units were told to begin, once."""

    number: int
    tag: int
    attempt: int
    switches: Mapping[int, command.Switch]
    awaited: set[str]
    units: tuple[str, ...]
    begun: set[str] = field(default_factory=set)
    drives: bool = False


class RunRendezvous:
    """Of one run. `tags` are the names of shared tags in the order of the exchange, `titles` the runtimes' names."""

    def __init__(
        self,
        channel: RendezvousChannel,
        tags: Sequence[str],
        titles: Mapping[int, str],
        terms: RendezvousTerms,
        units: AppointedUnits,
        numbers: Iterator[int],
    ) -> None:
        self.terms = terms
        self._channel = channel
        self._tags = tags
        self._titles = titles
        self._units = units
        self._numbers = numbers
        self._wanted: list[Convene | Disperse] = []
        self._convened: dict[int, Convene] = {}
        self._attempts: dict[int, _Attempt] = {}
        self._last: dict[int, _Attempt] = {}
        self._executors: Mapping[int, SubsystemExecutor] = {}
        self._prepared: PreparedSwitches | None = None
        self._feed: Callable[[engine_news.News], None] = lambda _news: None

    def attach(
        self,
        executors: Mapping[int, SubsystemExecutor],
        prepared: PreparedSwitches,
        feed: Callable[[engine_news.News], None],
    ) -> None:
        """From now on it serves this run; `feed` tells its engine news."""
        self._executors, self._prepared, self._feed = executors, prepared, feed

    @property
    def shared(self) -> frozenset[str]:
        """The tags at which flows of this runtime meet those of others."""
        return frozenset(self._tags[number] for number in self._meetings)

    @property
    def _meetings(self) -> Mapping[int, Rendezvous]:
        return self._channel.exchange.meetings

    def speaks_by(self, channel: RendezvousChannel) -> bool:
        """Whether it speaks by this channel."""
        return channel is self._channel

    def refusal(self, subsystem: str) -> Reason:
        """Why this flow cannot be steered now; empty: it can. It is bound for less than a second."""
        for tag, convened in self._convened.items():
            is_there = any(self._executors[number].name == subsystem for number in convened.flows)
            if is_there and self._meetings[tag].is_bound:
                return Reason.of("host.begins_now", tag=self._name(tag))
        return NOTHING

    # The engine

    def order(self, order: Convene | Disperse) -> None:
        """Carry this order of the engine out, as soon as it has said all."""
        self._wanted.append(order)

    def _carry_out_wanted(self, now: int) -> None:
        wanted, self._wanted = self._wanted, []
        for order in wanted:
            tag = self._tags.index(order.tag)
            meeting = self._meetings[tag]
            if isinstance(order, Convene):
                self._convened[tag] = order
                self._follow(tag, self._gather(meeting, order, now), now)
            else:
                self._follow(tag, meeting.let_pass(now) if order.was_there else meeting.leave(now), now)

    def _gather(self, meeting: Rendezvous, order: Convene, now: int) -> list[RendezvousOrder]:
        if not order.anew:
            return meeting.come(now)
        if meeting.state.phase is Phase.MET:  # all have begun meanwhile
            return [RepeatStep(), AllMet()]
        return meeting.clear(now)

    # Time, and other runtimes

    def fileno(self) -> int:
        """To wait for what others say."""
        return self._channel.fileno()

    def due_ns(self) -> int:
        """When it has something to do."""
        return 0 if self._wanted else self._channel.due_ns()

    def serve(self, now: int) -> None:
        """Hear the others, let time pass, say what is new."""
        self._carry_out_wanted(now)
        for tag, order in (*self._channel.receive(now), *self._channel.look(now)):
            self._carry_out(tag, order, now)
        self._carry_out_wanted(now)
        self._channel.speak(now)

    # The units

    def hear(self, rtpu: str, message: news.Appointed | news.HeldAlone, now: int) -> None:
        """What came of what a unit was to begin."""
        attempt = self._attempts.get(message.number)
        if attempt is None:
            return
        meeting = self._meetings[attempt.tag]
        if isinstance(message, news.HeldAlone):
            del self._attempts[message.number]
            self._follow(attempt.tag, meeting.held(attempt.attempt, now), now)
        else:
            self._note(rtpu, message, attempt)
            if not attempt.awaited:
                self._all_appointed(attempt, meeting, now)
        self._channel.speak(now)

    def _note(self, rtpu: str, message: news.Appointed, attempt: _Attempt) -> None:
        attempt.awaited.discard(rtpu)
        if message.has_begun:
            attempt.begun.add(rtpu)
            attempt.drives |= message.drives

    def _all_appointed(self, attempt: _Attempt, meeting: Rendezvous, now: int) -> None:
        """Every unit has said whether it has begun."""
        if len(attempt.begun) == len(attempt.units):
            number = attempt.number if attempt.switches else 0
            if self._prepared is not None:
                self._prepared.appointed(number, attempt.switches)
            self._feed(engine_news.Agreed(self._tags[attempt.tag], number))
            self._follow(attempt.tag, meeting.begun(attempt.attempt, now), now)
            return
        del self._attempts[attempt.number]
        for unit in attempt.begun:
            self._units.send(unit, command.CallOff(attempt.number, holds=True))
        self._follow(attempt.tag, meeting.missed(attempt.attempt, now), now)

    # What the rendezvous orders

    def _follow(self, tag: int, orders: Sequence[RendezvousOrder], now: int) -> None:
        for order in orders:
            self._carry_out(tag, order, now)

    def _carry_out(self, tag: int, order: RendezvousOrder, now: int) -> None:
        name = self._tags[tag]
        match order:
            case Appoint():
                self._appoint(tag, order)
            case Permit() | Revoke() | Confirm() | HoldNow():
                self._tell_units(tag, order)
            case AllMet():
                if order.is_free:
                    self._feed(engine_news.Agreed(name))
                self._feed(engine_news.Closed(name))
            case RepeatStep():
                self._feed(engine_news.Agreed(name))
            case Alone():
                self._tell_alone(tag, order)

    def _appoint(self, tag: int, order: Appoint) -> None:
        convened = self._convened[tag]
        executors = [self._executors[flow] for flow in convened.flows]
        units = sorted({member.rtpu for executor in executors for member in executor.members.values()})
        groups = {switch.flow: self._executors[switch.flow].appoint(switch) for switch in convened.switches}
        ready = {flow: group for flow, group in groups.items() if group is not None}
        if len(ready) < len(convened.flows):
            ready = {}  # the program switches, as soon as it hears that it has begun
        number = next(self._numbers)
        switches = {flow: switch for flow, (_, switch) in ready.items()}
        attempt = _Attempt(number, tag, order.attempt, switches, set(units), tuple(units))
        self._attempts[number] = self._last[tag] = attempt
        subsystems = tuple(executor.name for executor in executors)
        for unit in units:
            own = tuple(switch for rtpu, switch in ready.values() if rtpu == unit)
            appointment = command.Appointment(number, order.at_ns, self.terms.alone_ns, subsystems, own)
            self._units.send(unit, appointment)

    def _tell_units(self, tag: int, order: Permit | Revoke | Confirm | HoldNow) -> None:
        attempt = self._last.get(tag)
        if attempt is None or attempt.attempt != order.attempt:
            return
        for unit in attempt.units:
            words = self._units.begin_words(unit)
            match order:
                case Permit():
                    words.permit(attempt.number)
                case Revoke():
                    words.revoke(attempt.number)
                case Confirm():
                    words.confirm(attempt.number)
                case HoldNow():
                    self._units.send(unit, command.CallOff(attempt.number, holds=True))

    def _tell_alone(self, tag: int, order: Alone) -> None:
        attempt = self._last.get(tag)
        drives = attempt is None or attempt.drives
        absent = tuple(self._titles[site] for site in order.absent)
        self._feed(engine_news.BegunAlone(self._tags[tag], self._why_alone(tag, absent, drives), drives))

    def _why_alone(self, tag: int, absent: tuple[str, ...], drives: bool) -> Reason:
        if not drives:
            return Reason.of("host.meets_again", tag=self._name(tag))
        if absent:
            return Reason.of("host.began_alone", tag=self._name(tag), runtimes=absent)
        return Reason.of("host.heard_too_late", tag=self._name(tag))

    def _name(self, tag: int) -> str:
        """As it stands in the file."""
        return self._tags[tag].split(" ")[-1]
