"""The runner: carries out the engine's orders on RTPUs and tells the engine what came of them (laws 28, 30).

The same in wall and in virtual time: it is told the time, sends commands through units and tells events through a
function. It waits for nothing.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from onika.engine import news as said, orders
from onika.engine.engine import Engine
from onika.host.diagnosis.explainer import Explainer
from onika.host.diagnosis.stop_cause import Cause, Kind
from onika.host.loading.plan_preparation import Preparation
from onika.host.run.condition_evaluator import Judge
from onika.host.run.input_requests import Questions
from onika.host.run.prepared_switch import Outlook
from onika.host.run.run_events import Herald
from onika.host.run.run_statistics import Tally
from onika.host.run.settling import Settling
from onika.host.run.spawner import Births
from onika.host.run.switch_dispatch import Switchboard
from onika.host.run.switches import Switching
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem
from onika.wire import event
from onika.wire.request import Begin
from onika.wire.steer import Position, Steering

Tell = Callable[[event.Event], None]


class Runner:
    """One run of a prepared plan."""

    def __init__(
        self,
        prepared: Preparation,
        begin: Begin,
        subsystems: Mapping[int, RunningSubsystem],
        units: Units,
        tell: Tell,
    ) -> None:
        self._prepared = prepared
        self._begin = begin
        self._subsystems = subsystems
        self._flows = {subsystem.name: number for number, subsystem in subsystems.items()}
        self._units = units
        self._herald = Herald(prepared.plan, subsystems, tell)
        self._engine = self._make_engine(Judge(subsystems))
        self._switchboard = Switchboard(subsystems, units)
        self._outlook = Outlook(self._engine, subsystems, self._switchboard)
        self._switching = Switching(subsystems, self._outlook, self._switchboard, partial(self._refused, "on"))
        self._births = Births(subsystems, prepared.code, units, begin.seed, partial(self._refused, "spawn"))
        self._questions = Questions(begin, tell, self.answer, lambda cause: self._feed(said.Abort(cause)))
        tables = {one.name: one.table for one in subsystems.values()}
        self._explainer = Explainer(prepared, tables, self._engine.positions, tell)
        self._asking: set[tuple[int, str]] = set()
        self._settling = Settling(begin.settle_s, subsystems, units)
        self._now = 0
        self.tally = Tally(begin.watch)
        self.is_over = False
        self._stands_still = False

    def _make_engine(self, judge: Judge) -> Engine:
        flows = self._prepared.flows
        passive = {(number, wired.name) for number, flow in enumerate(flows) for wired in flow if wired.sheet.passive}
        triggers = {(n, wired.name) for n, flow in enumerate(flows) for wired in flow if wired.sheet.trigger}
        ranks = {(n, name): rank for n, one in self._subsystems.items() for name, rank in one.ranks.items()}
        stands_still = self._begin.on_error == "wait"
        plan = self._prepared.plan
        return Engine(plan, self._prepared.triggers, passive, ranks, triggers, judge.holds, stands_still)

    def start(self, now: int) -> None:
        """Begin the run."""
        self._now = self._herald.began = self.tally.began_at = now
        self._explainer.begin(now)
        self._feed(said.Run())
        self._births.go_on()

    def abort(self, cause: str, now: int, kind: Kind = Kind.USER) -> None:
        """End the run: tasks killed, devices in hold; harmless when it is over."""
        self._now = now
        self._settling.give_up()
        with self._explainer.watch(Cause(kind, cause), now):
            self._feed(said.Abort(cause))
        self._outlook.free_all()

    def lost(self, rtpu: str, reason: str, now: int) -> None:
        """A process is gone, and so are the tasks of a unit; the run ends where it needs it."""
        self._now = now
        self._settling.lost(rtpu)
        here = [
            (flow, name)
            for flow, subsystem in self._subsystems.items()
            for name, member in subsystem.members.items()
            if member.rtpu == rtpu
        ]
        if here or not rtpu:
            self.abort(reason, now, Kind.LOST)
        for flow, name in here:
            member = self._subsystems[flow].members[name]
            if member.state is not State.KILLED and member.is_sent:
                self._changed(flow, name, State.KILLED)

    # Steering

    def steer(self, wanted: Steering, now: int, answer: Callable[[str], None]) -> None:
        """Carry out what the user wants of the flow of this subsystem; answered, maybe a little later, with why not."""

        def act() -> None:
            self._now = max(now, self._now)
            refusal = "the run is over" if self.is_over else self._engine.refusal(wanted)
            if not refusal:
                self._feed(wanted)
            answer(refusal)

        if wanted.subsystem in self._flows:
            self._outlook.when_free(self._flows[wanted.subsystem], act)
        else:
            act()

    def positions(self) -> list[Position]:
        """Where every flow is, and who waits for whom."""
        return self._engine.positions()

    def asks(self, subsystem: str) -> tuple[event.Asked, ...]:
        """What tasks of a subsystem wait to be told."""
        told = self._questions.told.items()
        return tuple(
            one for (home, task), one in told if home == subsystem and (self._flows[home], task) in self._asking
        )

    # Time

    @property
    def is_asking(self) -> bool:
        """Whether a task waits for user input: then the virtual clock stands."""
        return bool(self._asking)

    @property
    def is_still(self) -> bool:
        """Whether scaled time stands still."""
        return not self.is_moving

    @property
    def is_hurried(self) -> bool:
        """Whether scaled time goes as fast as it can."""
        return False

    @property
    def is_moving(self) -> bool:
        """Whether the clock goes on: it stands while a task waits for user input, or every flow for its user."""
        return not (self.is_over or self._asking or self._stands_still)

    def run_began(self, device: str) -> int:
        """When it began; 0 where it does not use this device."""
        members = (one for subsystem in self._subsystems.values() for one in subsystem.members.values())
        return self._herald.began if any(one.wired.device == device for one in members) else 0

    def wake_at(self) -> int | None:
        """When `tick` has something to do."""
        wishes = (self._settling.wake_at(), self._explainer.wake_at())
        return min((at for at in wishes if at is not None), default=None)

    def tick(self, now: int) -> None:
        """Let time pass: what has settled is read, then the statuses are asked for."""
        self._now = now
        self._explainer.tick(now)
        if self._settling.is_due(now):
            self.tally.read({one.name: one.table for one in self._subsystems.values()})
            self._settling.ask()

    # News of RTPUs

    def hear(self, rtpu: str, heard: news.News, now: int) -> None:
        """Take in one piece of news."""
        self._now = now
        if isinstance(heard, news.Loads | news.Got):
            return
        if isinstance(heard, news.Statuses):
            self._report(rtpu, heard)
            return
        flow = self._flows.get(heard.subsystem)
        if flow is None:
            return
        if isinstance(heard, news.Unprepared):
            self._outlook.freed(flow)
            self._outlook.look()
            return
        if heard.task not in self._subsystems[flow].members:
            return
        if isinstance(heard, news.Stepped):
            self.tally.strides.note(heard)
            self._herald.stepped(heard)
            return
        if not _is_final(heard) and self._switchboard.is_late(flow, heard.task, getattr(heard, "activation", 0)):
            return  # it has been told to come on again meanwhile; what follows from that is what counts
        self._hear_task(flow, heard)

    def _report(self, rtpu: str, heard: news.Statuses) -> None:
        self.tally.figures(heard, self._flows)
        if self._settling.reported(rtpu):
            self._feed(said.Settled())

    def _hear_task(self, flow: int, heard: Any) -> None:
        task, at = heard.task, getattr(heard, "now_ns", self._now)
        self._explainer.tick(self._now)
        match heard:
            case news.Initialised():
                self._changed(flow, task, State.OFF)
                self._births.go_on()
            case news.Changed():
                self._changed(flow, task, State(heard.state), heard.signal)
            case news.Cycled():
                meeting = self.tally.first_cycle(flow, heard.at_ns)
                if meeting is not None:
                    self._herald.met(meeting, heard.at_ns)
            case news.Finished():
                self.tally.finished(flow, at)
                self._changed(flow, task, State.OFF, quietly=True)
                self._feed(said.Finished(flow, task, heard.flow, heard.loop, heard.switched))
            case news.Failed():
                self._failed(flow, heard)
            case news.Warned():
                self._herald.warned(flow, task, heard.text, at)
            case news.Signalled() if heard.kind in ("ILLEGAL", "SHUTDOWN"):
                with self._explainer.watch(heard, at):
                    self._feed(said.Illegal(flow, task, f"{heard.kind}: {heard.text}"))
            case news.Asked():
                self._asked(flow, heard)
            case news.Refused() if heard.command in ("on", "spawn", "clear"):
                with self._explainer.watch(heard, at):
                    self._feed(said.Refused(flow, task, f"{heard.command}: {heard.reason}"))
                self._switchboard.settled(flow, task)
            case news.Refused():
                self._herald.warned(flow, task, f"{heard.command} is refused: {heard.reason}", at)

    def _changed(self, flow: int, task: str, state: State, signal: str = "", quietly: bool = False) -> None:
        member = self._subsystems[flow].members[task]
        before, member.state = member.state, state
        self._asking.discard((flow, task))
        self._herald.state(flow, task, state, self._now)
        if quietly:
            return
        if state is State.ON:
            self._switchboard.settled(flow, task)
            self._feed(said.TurnedOn(flow, task))
        elif state is State.KILLED:
            self._births.release(member)
            self._feed(said.Killed(flow, task))
        elif before is State.WAITING:
            self._feed(said.Spawned(flow, task))
        elif before is State.ERROR:
            self._feed(said.Cleared(flow, task))
        elif signal == "OFF":
            self._feed(said.SwitchedOff(flow, task))

    def _failed(self, flow: int, heard: news.Failed) -> None:
        self._herald.failed(heard)
        self._subsystems[flow].members[heard.task].state = State.ERROR
        self._asking.discard((flow, heard.task))
        self._herald.state(flow, heard.task, State.ERROR, heard.now_ns)
        line = f" ({heard.path}:{heard.line})" if heard.line else ""
        with self._explainer.watch(heard, heard.now_ns):
            self._feed(said.Failed(flow, heard.task, f"{heard.entry}: {heard.text}{line}"))
        self._switchboard.settled(flow, heard.task)

    def _asked(self, flow: int, heard: news.Asked) -> None:
        self._subsystems[flow].members[heard.task].state = State.ASKING
        self._asking.add((flow, heard.task))
        self._switchboard.settled(flow, heard.task)
        self._herald.state(flow, heard.task, State.ASKING, heard.now_ns)
        self._feed(said.Asked(flow, heard.task, heard.reason))
        with self._explainer.watch(heard, heard.now_ns):
            self._questions.ask(heard, self._herald.seconds(heard.now_ns))

    def answer(self, subsystem: str, task: str, line: str) -> None:
        """The user's answer to an asking task."""
        flow = self._flows.get(subsystem)
        if flow is not None and task in self._subsystems[flow].members:
            self._send(flow, task, command.Answer(subsystem, task, line))

    def _refused(self, entry: str, flow: int, task: str, reason: str) -> None:
        with self._explainer.watch(news.Refused(self._herald.name(flow), task, entry, reason), self._now):
            self._feed(said.Refused(flow, task, f"{entry}: {reason}"))

    # Orders of the engine

    def _feed(self, one: said.News) -> None:
        for order in self._engine.feed(one):
            self._carry_out(order)
        self._stands_still = self._engine.stands_still
        if not self.is_over:
            self._outlook.look()
            self._explainer.look(self._now)

    def _carry_out(self, order: orders.Order) -> None:
        match order:
            case orders.Spawn():
                self._births.expect(order.flow, order.task)
            case orders.Together():
                self._switching.together(len(order.flows))
                if order.tag:
                    self.tally.meets(order.tag, order.flows)
            case orders.Switch():
                self._switching.switch(order)
            case orders.Off():
                self._switchboard.turn_off(order.flow, order.task)
            case orders.Clear():
                self._send(order.flow, order.task, command.Clear(self._herald.name(order.flow), order.task))
            case orders.Kill():
                self._kill(order)
            case orders.Settle():
                self._settling.begin(self._now)
            case orders.End():
                self.is_over = True
                self.tally.end(order.completed, order.cause, self._now)
            case _:
                self._told(order)

    def _told(self, order: orders.Began | orders.Done | orders.Moved | orders.Note) -> None:
        self._herald.order(order, self._now)
        if isinstance(order, orders.Done):
            self.tally.done += 1
        elif isinstance(order, orders.Moved):
            self._explainer.moved()

    def _kill(self, order: orders.Kill) -> None:
        member = self._subsystems[order.flow].members[order.task]
        self._switchboard.drop(order.flow)
        self._births.forget(order.flow, order.task)
        if member.is_sent and member.state is not State.KILLED:
            self._send(order.flow, order.task, command.Kill(self._herald.name(order.flow), order.task))
        else:
            self._changed(order.flow, order.task, State.KILLED)

    def _send(self, flow: int, task: str, order: command.Command) -> None:
        self._units.send(self._subsystems[flow].members[task].rtpu, order)


def _is_final(heard: news.News) -> bool:
    """Whether a task cannot come on after this, whatever it has been told meanwhile: it is in ERROR, or gone."""
    return isinstance(heard, news.Failed) or (isinstance(heard, news.Changed) and heard.state == State.KILLED.value)
