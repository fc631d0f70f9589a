"""The runner: carries out the engine's orders on RTPUs and tells the engine what came of them (laws 28, 30).

The same in wall and in virtual time: it is told the time, sends commands through units and tells events through a
function. It waits for nothing.
"""

from collections.abc import Callable, Mapping
from typing import Any

from onika.engine import news as said
from onika.engine import orders
from onika.engine.engine import Engine
from onika.host.preparation import Preparation
from onika.host.switchboard import Switchboard
from onika.host.tally import Tally
from onika.host.units import Units
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.subsystem import Member, Subsystem
from onika.wire import event
from onika.wire.request import Begin

Tell = Callable[[event.Event], None]


class Runner:
    """One run of a prepared plan."""

    def __init__(
        self,
        prepared: Preparation,
        begin: Begin,
        subsystems: Mapping[int, Subsystem],
        units: Units,
        tell: Tell,
    ) -> None:
        self._prepared = prepared
        self._begin = begin
        self._subsystems = subsystems
        self._flows = {subsystem.name: number for number, subsystem in subsystems.items()}
        self._units = units
        self._tell = tell
        passive = {
            (number, wired.name) for number, flow in enumerate(prepared.flows) for wired in flow if wired.sheet.passive
        }
        triggers = {(n, wired.name) for n, flow in enumerate(prepared.flows) for wired in flow if wired.sheet.trigger}
        ranks = {(n, name): rank for n, one in subsystems.items() for name, rank in one.ranks.items()}
        self._engine = Engine(prepared.plan, prepared.triggers, passive, ranks, triggers)
        self._waiting_spawns: list[tuple[int, str]] = []
        self._switchboard = Switchboard(subsystems, units)
        self._claims: list[str] = []
        self._asking: set[tuple[int, str]] = set()
        self._settle_at: int | None = None
        self._reports_open: set[str] = set()
        self._now = 0
        self._began = 0
        self.tally = Tally(begin.watch)
        self.is_over = False
        self._is_aborting = False

    def start(self, now: int) -> None:
        """Begin the run."""
        self._now = self._began = now
        self.tally.began_at = now
        self._feed(said.Run())
        self._spawn_ready()

    def abort(self, cause: str, now: int) -> None:
        """End the run: tasks killed, devices in hold; harmless when it is over."""
        self._now = now
        self._is_aborting = True
        self._settle_at = None
        self._feed(said.Abort(cause))

    def lost(self, rtpu: str, reason: str, now: int) -> None:
        """A process is gone, and so are the tasks of a unit; the run ends where it needs it."""
        self._now = now
        self._reports_open.discard(rtpu)
        here = [
            (flow, name)
            for flow, subsystem in self._subsystems.items()
            for name, member in subsystem.members.items()
            if member.rtpu == rtpu
        ]
        if here or not rtpu:
            self.abort(reason, now)
        for flow, name in here:
            member = self._subsystems[flow].members[name]
            if member.state is not State.KILLED and member.is_sent:
                self._changed(flow, name, State.KILLED)

    @property
    def is_asking(self) -> bool:
        """Whether a task waits for user input: then the virtual clock stands."""
        return bool(self._asking)

    @property
    def is_still(self) -> bool:
        """Whether scaled time stands still."""
        return not self.is_moving

    @property
    def is_moving(self) -> bool:
        """Whether the clock goes on: it stands while a task waits for user input."""
        return not (self.is_over or self._asking)

    def wake_at(self) -> int | None:
        """When `tick` has something to do."""
        return self._settle_at

    def tick(self, now: int) -> None:
        """Let time pass: what has settled is read, then the statuses are asked for."""
        self._now = now
        if self._settle_at is None or now < self._settle_at:
            return
        self._settle_at = None
        self.tally.read({one.name: one.table for one in self._subsystems.values()})
        self._reports_open = {member.rtpu for one in self._subsystems.values() for member in one.members.values()}
        for rtpu in sorted(self._reports_open):
            self._units.send(rtpu, command.Report())

    # News of RTPUs

    def hear(self, rtpu: str, heard: news.News, now: int) -> None:
        """Take in one piece of news."""
        self._now = now
        if isinstance(heard, news.Loads | news.Got):
            return
        if isinstance(heard, news.Statuses):
            self.tally.figures(heard, self._flows)
            was_open = rtpu in self._reports_open
            self._reports_open.discard(rtpu)
            if was_open and not self._reports_open and not self._is_aborting:
                self._feed(said.Settled())
            return
        flow = self._flows.get(heard.subsystem)
        if flow is None or heard.task not in self._subsystems[flow].members:
            return
        if self._switchboard.is_late(flow, heard.task, getattr(heard, "activation", 0)):
            return  # it has been told to come on again meanwhile; what follows from that is what counts
        self._hear_task(flow, heard)

    def _hear_task(self, flow: int, heard: Any) -> None:
        task, at = heard.task, getattr(heard, "now_ns", self._now)
        match heard:
            case news.Initialised():
                self._changed(flow, task, State.OFF)
                self._spawn_ready()
            case news.Changed():
                self._changed(flow, task, State(heard.state), heard.signal)
            case news.Cycled():
                self.tally.first_cycle(flow, heard.at_ns)
            case news.Finished():
                self.tally.finished(flow, at)
                self._changed(flow, task, State.OFF, quietly=True)
                self._feed(said.Finished(flow, task, heard.flow, heard.loop))
            case news.Failed():
                self._failed(flow, heard)
            case news.Warned():
                self._tell(event.Warned(heard.subsystem, task, heard.text, self._seconds(at)))
            case news.Signalled() if heard.kind in ("ILLEGAL", "SHUTDOWN"):
                self._feed(said.Illegal(flow, task, f"{heard.kind}: {heard.text}"))
            case news.Asked():
                self._asked(flow, heard)
            case news.Refused():
                self._feed(said.Refused(flow, task, f"{heard.command}: {heard.reason}"))
                self._switchboard.settled(flow, task)

    def _changed(self, flow: int, task: str, state: State, signal: str = "", quietly: bool = False) -> None:
        member = self._subsystems[flow].members[task]
        before, member.state = member.state, state
        self._asking.discard((flow, task))
        self._tell(event.TaskState(self._subsystems[flow].name, task, state.value, self._seconds(self._now)))
        if quietly:
            return
        if state is State.ON:
            self._switchboard.settled(flow, task)
            self._feed(said.TurnedOn(flow, task))
        elif state is State.KILLED:
            self._release(member)
            self._feed(said.Killed(flow, task))
        elif before is State.WAITING:
            self._feed(said.Spawned(flow, task))
        elif signal == "OFF":
            self._feed(said.SwitchedOff(flow, task))

    def _failed(self, flow: int, heard: news.Failed) -> None:
        at = self._seconds(heard.now_ns)
        text = f"{heard.entry}: {heard.text}"
        where = (heard.path, heard.line, heard.traceback, at, heard.entry, heard.values)
        self._tell(event.Failed(heard.subsystem, heard.task, text, *where))
        self._subsystems[flow].members[heard.task].state = State.ERROR
        self._asking.discard((flow, heard.task))
        self._tell(event.TaskState(heard.subsystem, heard.task, State.ERROR.value, at))
        line = f" ({heard.path}:{heard.line})" if heard.line else ""
        self._feed(said.Failed(flow, heard.task, f"{text}{line}"))
        self._switchboard.settled(flow, heard.task)

    def _asked(self, flow: int, heard: news.Asked) -> None:
        """Answer by what the run was given, else by whoever is there, else the run ends (law 25)."""
        self._subsystems[flow].members[heard.task].state = State.ASKING
        self._asking.add((flow, heard.task))
        self._switchboard.settled(flow, heard.task)
        given = {name: values for task, name, values in self._begin.answers if task == heard.task}
        at = self._seconds(heard.now_ns)
        self._tell(event.TaskState(heard.subsystem, heard.task, State.ASKING.value, at))
        reason = heard.reason
        self._feed(said.Asked(flow, heard.task, reason))
        names = [one.name for one in heard.items]
        strangers = sorted(given.keys() - set(names))
        if strangers:
            what = f"task {heard.task} asks for {', '.join(names)}, and an answer is given for {', '.join(strangers)}"
            self._feed(said.Abort(what))
        elif given and set(names) == given.keys() and heard.task not in self.tally.answered:
            self.tally.answered.add(heard.task)
            self.answer(heard.subsystem, heard.task, " ".join(given[name] for name in names))
        elif self._begin.may_ask:
            items = tuple(event.Item(*(getattr(one, name) for name in one.__struct_fields__)) for one in heard.items)
            self._tell(event.Asked(heard.subsystem, heard.task, reason, items, at))
        else:
            wanted = ", ".join(f"{heard.task}.{one.name}" for one in heard.items)
            said_wrong = f" ({reason})" if reason else ""
            self._feed(said.Abort(f"task {heard.task} asks for {wanted}{said_wrong} and nobody is there to answer"))

    def answer(self, subsystem: str, task: str, line: str) -> None:
        """The user's answer to an asking task."""
        flow = self._flows.get(subsystem)
        if flow is not None and task in self._subsystems[flow].members:
            member = self._subsystems[flow].members[task]
            self._units.send(member.rtpu, command.Answer(subsystem, task, line))

    # Orders of the engine

    def _feed(self, one: said.News) -> None:
        for order in self._engine.feed(one):
            self._carry_out(order)

    def _carry_out(self, order: orders.Order) -> None:
        match order:
            case orders.Spawn():
                self._waiting_spawns.append((order.flow, order.task))
            case orders.Switch():
                self._switch(order)
            case orders.Off():
                self._send(order.flow, order.task, command.Switch(self._name(order.flow), (order.task,), (), ()))
            case orders.Kill():
                self._kill(order)
            case orders.Began():
                flow = self._prepared.plan.flows[order.flow]
                action = flow.actions[order.index]
                at = self._seconds(self._now)
                self._tell(event.Began(order.flow, order.index, len(flow.actions), action.name, at))
            case orders.Done():
                self.tally.done += 1
                self._tell(event.Done(order.flow, order.index, self._seconds(self._now)))
            case orders.Note():
                self._tell(event.Warned(self._name(order.flow), "", order.text, self._seconds(self._now)))
            case orders.Settle():
                self._settle_at = self._now + round(self._begin.settle_s * 1e9)
            case orders.End():
                self.is_over = True
                self.tally.end(order.completed, order.cause, self._now)

    def _spawn_ready(self) -> None:
        """Spawn, in order, every task whose constants are there; the others wait for their suppliers (law 10)."""
        for flow, task in list(self._waiting_spawns):
            subsystem = self._subsystems[flow]
            if (flow, task) in self._waiting_spawns and subsystem.is_ready(task):
                self._waiting_spawns.remove((flow, task))
                self._spawn(flow, task)

    def _spawn(self, flow: int, task: str) -> None:
        subsystem = self._subsystems[flow]
        member = subsystem.members[task]
        code = self._prepared.code[member.wired.task.digest]
        try:
            device = self._claim(member)
            order = subsystem.spawn(task, code.source, code.path, self._begin.seed, device)
            self._units.send(member.rtpu, order)
        except (KeyError, ValueError) as wrong:
            self._feed(said.Refused(flow, task, f"spawn: {wrong}"))
            return
        member.is_sent = True

    def _claim(self, member: Member) -> command.DeviceGrant | None:
        device = member.wired.device
        if device is None:
            return None
        grant = self._units.grant(member.rtpu, device)
        if grant.command_offset is not None:
            self._claims.append(device)
        return grant

    def _release(self, member: Member) -> None:
        device = member.wired.device
        if device in self._claims:
            self._claims.remove(device)
            self._units.release(device)

    def _switch(self, order: orders.Switch) -> None:
        """Send a switch out, unless it would give a variable a second writer."""
        subsystem = self._subsystems[order.flow]
        for task, reason in subsystem.clashes(order.off, [start.task for start in order.on]):
            self._feed(said.Refused(order.flow, task, f"on: {reason}"))
            return
        forget = subsystem.forgotten(order.off, [start.task for start in order.on])
        subsystem.forget(forget)
        self._switchboard.put(order, forget)

    def _kill(self, order: orders.Kill) -> None:
        member = self._subsystems[order.flow].members[order.task]
        self._switchboard.drop(order.flow)
        if (order.flow, order.task) in self._waiting_spawns:
            self._waiting_spawns.remove((order.flow, order.task))
        if member.is_sent and member.state is not State.KILLED:
            self._send(order.flow, order.task, command.Kill(self._name(order.flow), order.task))
        else:
            self._changed(order.flow, order.task, State.KILLED)

    def _send(self, flow: int, task: str, order: command.Command) -> None:
        self._units.send(self._subsystems[flow].members[task].rtpu, order)

    def _name(self, flow: int) -> str:
        return self._subsystems[flow].name

    def _seconds(self, now: int) -> float:
        return round((now - self._began) * 1e-9, 9)
