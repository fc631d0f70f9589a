"""A simulated runtime whose flows meet others at a tag: its program, which may freeze, and its executive."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from kit.engine.rendezvous_net import SimClock
from onika.engine.rendezvous import Rendezvous
from onika.engine.rendezvous_exchange import RendezvousExchange
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
from onika.engine.rendezvous_terms import EVERY_NS
from onika.runtime.execution.appointments import LATE_NS, SHARED_LATE_NS
from onika.wire.rendezvous import Phase, RendezvousReport

if TYPE_CHECKING:
    from kit.engine.rendezvous_sim import RendezvousHistory

VISITS = 4
_RUN = bytes(16)
_TURN_NS = 6_000_000


class SimExecutive:
    """Begins by itself at the agreed time, and holds by itself; a frozen program does not keep it from that.

    Where its machine grants no real time (`is_shared`) it gets its turn some milliseconds late, and may.
    """

    holds = True

    def __init__(self, runtime: SimRuntime, *, is_shared: bool) -> None:
        self.runtime = runtime
        self.is_shared = is_shared
        self.late_ns = SHARED_LATE_NS if is_shared else LATE_NS
        self.attempt = 0
        self.permit = 0
        self.closed = 0
        self.moving = 0
        self.at_ns = 0

    def arm(self, attempt: int, at_ns: int) -> None:
        """Be ready for this attempt."""
        self.attempt, self.at_ns = attempt, at_ns
        turn_ns = int(self.runtime.history.time.random.expovariate(1 / _TURN_NS)) if self.is_shared else 0
        self.runtime.clock.at(at_ns + turn_ns, partial(self._begin, attempt))

    def disarm(self, attempt: int) -> None:
        """Forget the permit, and what was to begin if that is long before."""
        self.permit = 0

    def hold(self, attempt: int) -> None:
        """Everything of this attempt stands."""
        if self.moving == attempt:
            self.moving = 0
            self.runtime.history.oracle.holds(self.runtime.site, self.runtime.history.now_ns)

    def _begin(self, attempt: int) -> None:
        runtime, history = self.runtime, self.runtime.history
        if runtime.is_gone or self.attempt != attempt:
            return
        if runtime.machine_frozen_ns > history.now_ns:
            history.time.at(runtime.machine_frozen_ns, partial(self._begin, attempt))
            return
        is_late = runtime.clock.now_ns > self.at_ns + self.late_ns
        if is_late or self.permit != attempt:
            runtime.soon(partial(runtime.missed, attempt))
            return
        self.moving = attempt
        history.oracle.begins_at(runtime.site, runtime.visit, attempt, history.now_ns)
        if self.holds:
            runtime.clock.at(self.at_ns + history.terms.alone_ns, partial(self._hold_alone, attempt))
        runtime.soon(partial(runtime.begun, attempt))

    def _hold_alone(self, attempt: int) -> None:
        if self.moving == attempt and self.closed != attempt and not self.runtime.is_gone:
            self.hold(attempt)
            self.runtime.soon(partial(self.runtime.held, attempt))


@dataclass(frozen=True, slots=True)
class Parts:
    """What a runtime is made of; tests exchange a part for one with a mistake."""

    rendezvous: type[Rendezvous] = Rendezvous
    exchange: type[RendezvousExchange] = RendezvousExchange
    executive: type[SimExecutive] = SimExecutive


HONEST = Parts()


class SimRuntime:
    """One runtime: its program may freeze, its machine too, and it may crash and come back with another epoch."""

    def __init__(self, history: RendezvousHistory, site: int, epochs: dict[int, int], parts: Parts) -> None:
        self.history = history
        self.site = site
        self.epochs = epochs
        self.clock = SimClock(history.time)
        self.exchange = parts.exchange(_RUN, site, epochs, [tuple(epochs)], history.terms, parts.rendezvous)
        self.meeting = self.exchange.meetings[0]
        random = history.time.random
        self.drives = random.random() < 0.5
        """Whether its flows move anything; where they do not, they meet again by themselves."""
        self.executive = parts.executive(self, is_shared=random.random() < 0.3)
        self.visit = 0
        self.frozen_ns = 0
        self.machine_frozen_ns = 0
        self.is_done = False
        self.is_gone = False
        self._steps = 0
        self._counts = dict.fromkeys(self.exchange.others, 0)

    # The program, which does nothing while it is frozen

    def soon(self, act: Callable[[], None]) -> None:
        """Have the program do this as soon as it can, in order."""
        if self.frozen_ns > self.history.now_ns:
            self.history.time.at(self.frozen_ns, act)
        else:
            act()

    def speak(self) -> None:
        """Say how everything stands, every 20 ms."""
        if not self.is_gone:
            self._do(self.meeting.look(self.clock.now_ns))
            self._say()
            self.history.time.after(EVERY_NS, partial(self.soon, self.speak))

    def hear(self, count: int, report: RendezvousReport) -> None:
        """A datagram came."""
        if not self.is_gone:
            before = self.meeting.state
            self._do([order for _, order in self.exchange.hear(count, report, self.clock.now_ns)])
            if self.meeting.state is not before:
                self._say()

    def begun(self, attempt: int) -> None:
        """The executive has begun."""
        self._tell(self.meeting.begun, attempt)

    def missed(self, attempt: int) -> None:
        """The executive has not begun."""
        self._tell(self.meeting.missed, attempt)

    def held(self, attempt: int) -> None:
        """The executive has held."""
        self._tell(self.meeting.held, attempt)

    # Its flows and users

    def come(self) -> None:
        """The flows come to the tag."""
        if not self.is_gone:
            self.visit += 1
            self.history.oracle.comes(self.site, self.visit)
            self._do(self.meeting.come(self.clock.now_ns))

    def let_pass(self) -> None:
        """The user lets the flows go on alone, where they wait."""
        if not self.is_gone and self.meeting.state.phase in (Phase.WAIT, Phase.ARMED):
            self.history.oracle.passes(self.site, self.visit)
            self._do(self.meeting.let_pass(self.clock.now_ns))
            self._go_on(self.visit)

    def clear(self, visit: int) -> None:
        """The user clears what was held, or it has moved nothing."""
        if not self.is_gone and self.visit == visit and self.meeting.state.phase is Phase.STOPPED:
            self.history.oracle.clears(self.site)
            self._do(self.meeting.clear(self.clock.now_ns))

    def _tell(self, news: Callable[[int, int], list[RendezvousOrder]], attempt: int) -> None:
        if not self.is_gone:
            self._do(news(attempt, self.clock.now_ns))
            self._say()

    def _say(self) -> None:
        for other in self.exchange.others:
            self._counts[other] += 1
            report = self.exchange.report(other, self.clock.now_ns)
            to = self.history.runtimes[other]
            arrive = partial(to.soon, partial(to.hear, self._counts[other], report))
            self.history.net.send(self.site, other, arrive)

    def _do(self, orders: list[RendezvousOrder]) -> None:
        history, executive = self.history, self.executive
        for order in orders:
            match order:
                case Appoint():
                    executive.arm(order.attempt, order.at_ns)
                    self.clock.at(order.at_ns - history.terms.commit_ns, partial(self.soon, self._look))
                case Permit():
                    executive.permit = order.attempt
                case Revoke():
                    executive.disarm(order.attempt)
                case Confirm():
                    executive.closed = order.attempt
                case HoldNow():
                    executive.hold(order.attempt)
                case AllMet():
                    if order.is_free:
                        history.oracle.passes(self.site, self.visit)
                    self._go_on(self.visit)
                case Alone():
                    self._steps += 1
                    history.oracle.is_alone(self.site)
                    if not self.drives:
                        history.time.after(0, partial(self.soon, partial(self.clear, self.visit)))
                    else:
                        history.time.after(history.time.uniform(200, 2_000), partial(self._see, self.visit))
                case RepeatStep() | MeetAgain():
                    pass

    def _look(self) -> None:
        if not self.is_gone:
            before = self.meeting.state
            self._do(self.meeting.look(self.clock.now_ns))
            if self.meeting.state is not before:
                self._say()

    def _see(self, visit: int) -> None:
        """Users clear at their leisure, again and again."""
        if not self.is_gone and self.visit == visit and self.meeting.state.phase is Phase.STOPPED:
            self.clear(visit)
            self.history.time.after(self.history.time.uniform(200, 2_000), partial(self._see, visit))

    def _go_on(self, visit: int) -> None:
        self._steps += 1
        finish = partial(self._finish, visit, self._steps)
        self.history.time.after(self.history.time.uniform(50, 1_000), partial(self.soon, finish))

    def _finish(self, visit: int, step: int) -> None:
        if self.is_gone or self._steps != step:
            return
        self.executive.moving = 0
        self.history.oracle.goes_on(self.site, visit)
        if visit == VISITS:
            self.is_done = True
            return
        self.history.time.after(self.history.time.uniform(50, 1_000), partial(self.soon, self.come))


class Stranger(SimRuntime):
    """A runtime that begins another run of the same application, where one of the first run is no more."""

    def start(self, visits: int) -> None:
        """Its flows wait at the tag for this time, and its program speaks."""
        self.is_done = True
        for _ in range(visits):
            self.meeting.come(self.clock.now_ns)
        self.speak()

    def _do(self, orders: list[RendezvousOrder]) -> None:
        """What it does is no part of the history."""
