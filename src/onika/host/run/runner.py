"""The runner carries out the engine's orders on subsystems and tells the engine what came of them (laws 28, 30).

It is the same in wall and in virtual time: it is told the time, and acts through one executor for each flow's
subsystem. It waits for nothing.
"""

from collections.abc import Callable, Mapping
from functools import partial
from itertools import count
from typing import cast

from onika.engine import news as engine_news, orders
from onika.engine.engine import Engine
from onika.host.diagnosis.explainer import Explainer
from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.execution import task_events
from onika.host.execution.spawner import Spawner
from onika.host.execution.subsystem_executor import SubsystemExecutor, happened_at
from onika.host.loading.plan_preparation import Preparation
from onika.host.run.condition_evaluator import ConditionEvaluator
from onika.host.run.engine_news import of_task
from onika.host.run.input_requests import InputRequests
from onika.host.run.plan_engine import plan_engine
from onika.host.run.prepared_switch import PreparedSwitches
from onika.host.run.run_events import FlowNote, RunEvents
from onika.host.run.run_rendezvous import RunRendezvous
from onika.host.run.run_statistics import RunStatistics
from onika.host.run.settling import Settling
from onika.host.run.switches import Switches
from onika.host.units.unit_loss import ends_with
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem
from onika.wire import event
from onika.wire.request import Begin
from onika.wire.steer import Position, Steering
from onika.words.reason import Reason

Tell = Callable[[event.Event], None]

_COUNTED = frozenset((news.Stepped, news.Cycled, news.Finished, news.Failed))

_NOTES = (orders.Began, orders.Done, orders.Moved, orders.RunNote)

_MAY_STOP = (news.Failed, news.Signalled, news.Refused)
"""After this news a flow may stand still, which is explained."""


class Runner:
    """Runs a prepared plan once. `lost` are the units that are gone, each with the reason."""

    def __init__(
        self,
        prepared: Preparation,
        begin: Begin,
        subsystems: Mapping[int, RunningSubsystem],
        units: Units,
        tell: Tell,
        lost: Mapping[str, Reason] | None = None,
        rendezvous: RunRendezvous | None = None,
    ) -> None:
        self._prepared = prepared
        self._begin = begin
        self._tell = tell
        self.rendezvous = rendezvous
        """Where flows of other runtimes are met; None: all flows run here."""
        self._flows = {subsystem.name: flow for flow, subsystem in subsystems.items()}
        self._tables = {subsystem.name: subsystem.table for subsystem in subsystems.values()}
        activations = count(1)
        units_lost = lost if lost is not None else {}  # shared: what is lost later counts, too
        self._executors = {
            flow: SubsystemExecutor(
                subsystem,
                units,
                self._spawner(units, units_lost),
                partial(self._follow, flow),
                tell,
                task_events.in_a_run,
                units_lost,
                activations,
            )
            for flow, subsystem in subsystems.items()
        }
        self._events = RunEvents(prepared.plan, tell)
        self._engine = self._make_engine(subsystems)
        self._prepared_switches = PreparedSwitches(self._engine, self._executors)
        if rendezvous is not None:
            rendezvous.attach(self._executors, self._prepared_switches, self._feed)
        self._switches = Switches(self._executors, self._prepared_switches, units)
        self._input_requests = InputRequests(begin, self.answer, self._ask_user, self._abort_now)
        self._explainer = Explainer(prepared, self._tables, self._engine.positions, tell)
        self._settling = Settling(begin.settle_s, subsystems, units)
        self._now = 0
        self.statistics = RunStatistics(begin.watch)
        self.is_over = False
        self._stands_still = False

    def _spawner(self, units: Units, lost: Mapping[str, Reason]) -> Spawner:
        spawner = Spawner(units, lost, self._begin.seed)
        for code in self._prepared.code.values():
            spawner.add_code(code)
        return spawner

    def _make_engine(self, subsystems: Mapping[int, RunningSubsystem]) -> Engine:
        ranks = {(flow, task): rank for flow, home in subsystems.items() for task, rank in home.ranks.items()}
        stands_still = self._begin.on_error == "wait"
        judge = ConditionEvaluator(subsystems)
        shared = self.rendezvous.shared if self.rendezvous is not None else ()
        return plan_engine(self._prepared, ranks, stands_still, judge.holds, shared)

    @property
    def engine(self) -> Engine:
        """What decides; to be looked at, or copied, by whoever asks what would follow."""
        return self._engine

    def start(self, now: int) -> None:
        """Begin the run."""
        self._now = self._events.began = self.statistics.began_at = now
        for executor in self._executors.values():
            executor.begin(now)
        self._explainer.begin(now)
        self._feed(engine_news.Run())
        for executor in self._executors.values():
            executor.spawn_ready()

    def abort(self, cause: Reason, now: int, kind: CauseKind = CauseKind.USER) -> None:
        """End the run: tasks killed, devices in hold; harmless when it is over."""
        self._now = now
        self._settling.give_up()
        with self._explainer.watch(Cause(kind, cause), now):
            self._feed(engine_news.Abort(cause))
        self._prepared_switches.free_all()

    def lost(self, rtpu: str, reason: Reason, now: int) -> None:
        """A process is gone, and so are the tasks of a unit; the run ends where it needs it."""
        self._now = now
        self._settling.lost(rtpu)
        if ends_with(rtpu, self._homes()):
            self._remark(reason)
            self.abort(reason, now, CauseKind.LOST)
        for executor in self._executors.values():
            executor.lost(rtpu, now)

    def _homes(self) -> set[str]:
        """The units of its tasks."""
        return {member.rtpu for executor in self._executors.values() for member in executor.members.values()}

    def claims(self, subsystem: str) -> dict[str, str]:
        """The devices that tasks of a subsystem have for themselves alone, by task."""
        flow = self._flows.get(subsystem)
        return {} if flow is None else self._executors[flow].spawner.claims

    # Steering

    def steer(self, wanted: Steering, now: int, answer: Callable[[Reason], None]) -> None:
        """Carry out what the user wants of the flow of this subsystem; answered, maybe a little later, with why not."""

        def act() -> None:
            self._now = max(now, self._now)
            refusal: Reason = Reason.of("engine.run_over") if self.is_over else self._engine.refusal(wanted)
            if self.rendezvous is not None:
                refusal = refusal or self.rendezvous.refusal(wanted.subsystem)
            if not refusal:
                self._feed(wanted)
            answer(refusal)

        if wanted.subsystem in self._flows:
            self._prepared_switches.when_free(self._flows[wanted.subsystem], act)
        else:
            act()

    def positions(self) -> list[Position]:
        """Where every flow is, and who waits for whom."""
        return self._engine.positions()

    # Questions of tasks

    def questions(self, subsystem: str) -> tuple[event.Asked, ...]:
        """What tasks of a subsystem have asked users and were not answered yet."""
        flow = self._flows.get(subsystem)
        if flow is not None:
            return self._executors[flow].questions
        return ()

    def answer(self, subsystem: str, task: str, line: str) -> None:
        """The user's answer to an asking task."""
        flow = self._flows.get(subsystem)
        if flow is not None and task in self._executors[flow].members:
            self._executors[flow].send(task, command.Answer(subsystem, task, line))

    def _ask_user(self, question: news.Asked) -> None:
        self._executors[self._flows[question.subsystem]].ask_user(question)

    def _abort_now(self, cause: Reason) -> None:
        self._feed(engine_news.Abort(cause))

    # Time

    @property
    def is_asking(self) -> bool:
        """Whether a task waits for user input: then the virtual clock stands."""
        for executor in self._executors.values():  # noqa: SIM110  at every instant of virtual time: no generator
            if executor.open_questions:
                return True
        return False

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
        return not (self.is_over or self._stands_still or self.is_asking)

    def run_began(self, device: str) -> int:
        """When it began; 0 where it does not use this device."""
        members = (member for executor in self._executors.values() for member in executor.members.values())
        if any(member.wired.device == device for member in members):
            return self._events.began
        return 0

    def wake_at(self) -> int | None:
        """When `tick` has something to do."""
        meeting = self.rendezvous.due_ns() if self.rendezvous is not None else None
        times = (self._settling.wake_at(), self._explainer.wake_at(), meeting)
        return min((at for at in times if at is not None), default=None)

    def tick(self, now: int) -> None:
        """Let time pass: what has settled is read, then the statuses are asked for."""
        self._now = now
        self._explainer.tick(now)
        if self.rendezvous is not None:
            self.rendezvous.serve(now)
        if self._settling.is_due(now):
            self.statistics.read(self._tables)
            if not self._settling.ask():
                self._feed(engine_news.Settled())

    # News of units

    def hear(self, rtpu: str, message: news.News, now: int) -> None:
        """Take in one piece of news."""
        self._now = now
        if type(message) in news.OF_TASKS:
            self._hear_of_task(cast("news.TaskNews", message))
        elif isinstance(message, news.Statuses):
            self._report(rtpu, message)
        elif isinstance(message, news.Appointed | news.HeldAlone):
            if self.rendezvous is not None:
                self.rendezvous.hear(rtpu, message, now)
        elif isinstance(message, news.Unprepared) and message.subsystem in self._flows:
            self._prepared_switches.freed(self._flows[message.subsystem])
            self._prepared_switches.refresh()

    def _report(self, rtpu: str, statuses: news.Statuses) -> None:
        self.statistics.figures(statuses, self._flows)
        if self._settling.reported(rtpu):
            self._feed(engine_news.Settled())

    def _hear_of_task(self, message: news.TaskNews) -> None:
        """What is late is left out: the task was told to come on again meanwhile, and what follows from that counts."""
        flow = self._flows.get(message.subsystem)
        if flow is None:
            return
        executor = self._executors[flow]
        if message.task in executor.members and not executor.is_late(message):
            self._explainer.tick(self._now)
            executor.hear(message, self._now)

    def _follow(self, flow: int, message: news.TaskNews, before: State) -> None:
        """As the executor's client: count what is counted, and tell the engine."""
        if type(message) in _COUNTED:
            self._count(flow, message)
        meaning = of_task(flow, message, before)
        if meaning is None:
            if isinstance(message, news.Refused):
                refusal = Reason.of("host.command_refused", command=message.command, why=message.reason)
                self._executors[flow].warn(message.task, refusal, self._now)
        elif isinstance(message, _MAY_STOP):
            with self._explainer.watch(message, happened_at(message, self._now)):
                self._feed(meaning)
        else:
            self._feed(meaning)
        if isinstance(message, news.Asked):
            with self._explainer.watch(message, message.now_ns):
                self._input_requests.ask(message)

    def _count(self, flow: int, message: news.TaskNews) -> None:
        match message:
            case news.Stepped():
                self.statistics.strides.note(message)
            case news.Cycled():
                meeting = self.statistics.first_cycle(flow, message.at_ns)
                if meeting is not None:
                    self._events.met(meeting, message.at_ns)
            case news.Finished():
                self.statistics.finished(flow, message.now_ns)
            case news.Failed():
                task = f"{message.subsystem}/{message.task}"
                self._remark(Reason.of("host.failed_at_end", task=task, entry=message.entry, why=message.text))

    def _remark(self, wrong: Reason) -> None:
        """Something goes wrong: where all actions are done it ends no run, but its end does not pass it over."""
        if self._engine.is_completing:
            remark = Reason.of("host.wrong_at_end", why=wrong)
            self.statistics.remarks.append(remark)
            self._events.warn(remark, self._now)

    # Orders of the engine

    def _feed(self, message: engine_news.News) -> None:
        for order in self._engine.feed(message):
            if isinstance(order, _NOTES):
                self._note(order)
            else:
                self._carry_out(order)
        self._stands_still = self._engine.stands_still
        if not self.is_over:
            self._prepared_switches.refresh()
            self._explainer.look(self._now)

    def _carry_out(self, order: orders.Order) -> None:
        match order:
            case orders.Spawn():
                self._executors[order.flow].expect(order.task)
            case orders.Together():
                self._switches.together(len(order.flows))
                if order.tag:
                    self.statistics.meets(order.tag, order.flows)
            case orders.Switch():
                self._switches.switch(order)
            case orders.Off():
                self._executors[order.flow].turn_off(order.task)
            case orders.Clear():
                executor = self._executors[order.flow]
                executor.send(order.task, command.Clear(executor.name, order.task))
            case orders.Kill():
                self._kill(order)
            case orders.Settle():
                self._settling.begin(self._now)
            case orders.End():
                self.is_over = True
                self.statistics.end(order.completed, order.cause, self._now)
            case orders.Convene() | orders.Disperse():
                if self.rendezvous is not None:
                    self.rendezvous.order(order)

    def _note(self, note: FlowNote) -> None:
        self._events.note(note, self._now)
        if isinstance(note, orders.Done):
            self.statistics.done += 1
        elif isinstance(note, orders.Moved):
            self._explainer.moved()

    def _kill(self, order: orders.Kill) -> None:
        executor = self._executors[order.flow]
        executor.drop_switches()
        if not executor.kill(order.task):
            executor.end(order.task, self._now)
