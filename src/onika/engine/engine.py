"""The engine: executes the flows of a plan by superset dynamic reconfiguration (§5.9.2, Table 9).

It has neither clock nor link. It is fed news, one at a time and in the order in which each task spoke, and
answers with orders, to be carried out in their order. All tasks are spawned first; then each action of each flow
is one switch, begun by the trigger that finished the one before; at the end, or at an abort, all tasks are killed.
Whoever carries the orders out counts the activations of each task and keeps from it what is said of an earlier one.
"""

from collections.abc import Callable, Collection, Mapping, Set

from onika.engine.flow import FlowEvent, FlowState
from onika.engine.flow_control import FlowControl
from onika.engine.flow_router import FlowRouter
from onika.engine.news import (
    Abort,
    Agreed,
    Asked,
    BegunAlone,
    Cleared,
    Closed,
    Failed,
    Finished,
    Illegal,
    Killed,
    News,
    Refused,
    Run,
    Settled,
    Spawned,
    SwitchedOff,
    TaskNews,
    TurnedOn,
)
from onika.engine.orders import Case, End, Order, RunNote
from onika.engine.program import FlowProgram
from onika.engine.progress import Progress
from onika.engine.recovery import ErrorRecovery
from onika.engine.shared_tags import SharedTags
from onika.engine.step import steps
from onika.engine.walk import FinishValue
from onika.wire.plan import Plan
from onika.wire.steer import Position, Steering
from onika.words.reason import NOTHING, Reason

_OVER = (FlowState.KILLING, FlowState.ENDED)
_AT_REST = {FlowState.WAITING, FlowState.JOINING, FlowState.PAUSED, FlowState.STOPPED, FlowState.DONE}


class Engine:
    """Executes one plan once.

    `triggers` names, for every (flow, action), the task that takes the target and ends the action; none for a
    job without one. `other_triggers` are (flow, task) of further trigger tasks, which end an action too when
    they finish first (reading 16). `passive` are the (flow, task) that may fall silent. `ranks` gives the order
    in which the tasks of a flow come on. `judge` says whether a condition on variables of a flow holds now. With
    `stands_still` a flow in which a task has failed waits for its user, else the application is aborted.
    At the tags `shared` flows of other runtimes are met.
    Raises ValueError or KeyError for a plan that these do not describe.
    """

    def __init__(
        self,
        plan: Plan,
        triggers: Mapping[tuple[int, int], str | None],
        passive: Set[tuple[int, str]],
        ranks: Mapping[tuple[int, str], int],
        other_triggers: Set[tuple[int, str]] = frozenset(),
        judge: Callable[[int, str], bool] = lambda _flow, _condition: False,
        stands_still: bool = False,
        shared: Collection[str] = (),
    ) -> None:
        if not plan.flows:
            raise ValueError(Reason.of("engine.form_flow", application=plan.application))
        self._passive = frozenset(passive)
        self._cause: Reason | None = None
        self._flows: list[Progress] = []
        for flow, planned in enumerate(plan.flows):
            own_ranks = {task.name: ranks[flow, task.name] for task in planned.tasks}
            own_triggers = {index: triggers[flow, index] for index in range(len(planned.actions))}
            others = {task for number, task in other_triggers if number == flow}
            ready = steps(planned, own_triggers, others, own_ranks)
            judged = _judge_of(judge, flow)
            self._flows.append(Progress(flow, planned, FlowProgram(planned), ready, own_ranks, judged))
        names = [planned.subsystem for planned in plan.flows]
        self._router = FlowRouter(self._flows, names, shared)
        self._recovery = ErrorRecovery(self._router, stands_still)
        self._numbers = {name: flow for flow, name in enumerate(names)}
        self._control = FlowControl(self._router, self._recovery)
        self._shared = SharedTags(self._flows, self._router, self._recovery, self._finished, self._abort)

    # What can be asked

    def refusal(self, command: Steering) -> Reason:
        """Why this cannot be done now with the flow that it names by its subsystem; empty: it can."""
        if command.subsystem not in self._numbers:
            names = tuple(self._numbers)
            if not command.subsystem:
                return Reason.of("engine.no_flow_named", names=names)
            return Reason.of("engine.no_such_flow", names=names, name=command.subsystem)
        return self._control.refusal(self._steered(command), command)

    def positions(self) -> list[Position]:
        """Where every flow is, and who waits for whom."""
        return [self._router.position(flow) for flow in self._flows]

    @property
    def stands_still(self) -> bool:
        """Whether nothing goes on before somebody outside says something: every flow waits, rests or is done."""
        states = {flow.state for flow in self._flows}
        return states <= _AT_REST and states != {FlowState.DONE}

    @property
    def is_completing(self) -> bool:
        """Whether every action is done, and only the tasks are being ended."""
        return self._cause is None and any(flow.state is FlowState.KILLING for flow in self._flows)

    def cases(self, flow: int) -> list[Case]:
        """What may follow the current action of a flow, each with its switch."""
        return self._flows[flow].cases()

    def revision(self, flow: int) -> tuple[int, bool]:
        """Changes whenever the cases of the flow may have."""
        return self._flows[flow].revision, self._flows[flow].flow_tasks.is_settled

    # What is told

    def feed(self, news: News) -> list[Order]:
        """Hear one piece of news; the orders that follow from it. What comes too late changes nothing."""
        if isinstance(news, TaskNews):
            return self._guarded(self._hear(self._flows[news.flow], news))
        match news:
            case Run():
                return self._run()
            case Settled():
                is_done = all(flow.state is FlowState.DONE for flow in self._flows)
                return self._kill_all() if is_done else []
            case Abort():
                return self._abort(news.cause)
            case Agreed() | Closed() | BegunAlone():
                return self._guarded(self._shared.hear(news))
        if self.refusal(news):
            return []
        return self._guarded(self._control.steer(self._steered(news), news))

    def _steered(self, command: Steering) -> Progress:
        return self._flows[self._numbers[command.subsystem]]

    def _guarded(self, orders: list[Order]) -> list[Order]:
        """Orders, and the end of the application where a flow has gone astray."""
        return orders + (self._abort(self._router.astray) if self._router.astray else [])

    def _run(self) -> list[Order]:
        if any(flow.state is not FlowState.READY for flow in self._flows):
            return []
        orders: list[Order] = []
        for flow in self._flows:
            flow.enter(FlowEvent.SPAWN)
            orders += flow.flow_tasks.spawn()
        return orders + self._guarded(self._begin_when_spawned())

    def _hear(self, flow: Progress, news: TaskNews) -> list[Order]:
        if not flow.flow_tasks.lives(news.task):
            is_late = flow.state in (FlowState.READY, *_OVER)
            if is_late:
                return []
            return [RunNote(flow.flow, Reason.of("engine.strange_task", task=news.task))]
        if flow.state in _OVER:
            return self._hear_while_killing(flow, news)
        return self._hear_under_way(flow, news)

    def _hear_under_way(self, flow: Progress, news: TaskNews) -> list[Order]:
        match news:
            case TurnedOn():
                flow.flow_tasks.turned_on(news.task)
                return []
            case Finished():
                return self._finished(flow, news)
            case Spawned():
                flow.flow_tasks.spawned(news.task)
                return self._begin_when_spawned()
            case SwitchedOff():
                return self._switched_off(flow, news.task)
            case Asked():
                return [RunNote(flow.flow, _question(flow, news))]
            case Failed():
                return self._failed(flow, news)
            case Cleared():
                return self._recovery.cleared(flow, news.task)
            case Illegal():
                return self._abort(Reason.of("engine.may_not_go_on", where=flow.where(news.task), why=news.text))
            case Refused():
                return self._refused(flow, news)
            case Killed():
                cause = Reason.of("engine.task_gone", where=flow.where(news.task))
                flow.flow_tasks.gone(news.task)
                return self._abort(cause)

    def _hear_while_killing(self, flow: Progress, news: TaskNews) -> list[Order]:
        match news:
            case Spawned():
                flow.flow_tasks.spawned(news.task)
            case Killed():
                return self._gone(flow, news.task)
            case Refused() if flow.flow_tasks.is_unborn(news.task):
                return self._gone(flow, news.task)
            case _:
                pass
        return []

    def _begin_when_spawned(self) -> list[Order]:
        """No robot moves before every task of every flow has come to life."""
        if not all(flow.state is FlowState.SPAWNING and flow.flow_tasks.is_spawned for flow in self._flows):
            return []
        orders: list[Order] = []
        for flow in self._flows:
            if flow.parent is not None:
                flow.enter(FlowEvent.COMPLETE)
            elif flow.is_pausing:
                orders += self._router.rest(flow)
        first = [flow.flow for flow in self._flows if flow.state is FlowState.SPAWNING]
        return orders + self._router.go_on(first)

    def _finished(self, flow: Progress, news: Finished) -> list[Order]:
        if self._shared.keeps(flow, news):
            return []
        if not flow.finished(news.task):
            return [RunNote(flow.flow, Reason.of("engine.ends_no_action", where=flow.where(news.task)))]
        done = flow.ends_with(FinishValue(news.choice, news.loop))
        if not news.switched and flow.rests_after(flow.current):
            return [done, *self._router.rest(flow)]
        return [done, *self._router.go_on([flow.flow], number=news.switched)]

    def _switched_off(self, flow: Progress, task: str) -> list[Order]:
        flow.flow_tasks.switched_off(task)
        flow.revision += 1
        where = flow.where(task)
        if (flow.flow, task) in self._passive:
            return [RunNote(flow.flow, Reason.of("engine.switched_itself_off", where=where))]
        return [RunNote(flow.flow, Reason.of("engine.switched_off_not_passive", where=where))]

    def _failed(self, flow: Progress, news: Failed) -> list[Order]:
        where = flow.where(news.task)
        if (flow.flow, news.task) not in self._passive:
            cause = Reason.of("engine.in_error", where=where, why=news.text)
            if flow.state is FlowState.SPAWNING or not self._recovery.stands_still:
                return self._abort(cause)
            return self._recovery.failed(flow, news.task, cause)
        flow.flow_tasks.given_up(news.task)
        flow.revision += 1
        note = RunNote(flow.flow, Reason.of("engine.passive_in_error", where=where, why=news.text))
        return [note, *self._begin_when_spawned()]

    def _refused(self, flow: Progress, news: Refused) -> list[Order]:
        """A passive task that cannot come on is as harmless as one in error; one that cannot be spawned is not."""
        where = flow.where(news.task)
        if flow.flow_tasks.is_unborn(news.task):
            flow.flow_tasks.gone(news.task)
            return self._abort(Reason.of("engine.not_spawned", where=where, why=news.reason))
        if news.task in flow.flow_tasks.failed:
            return self._not_cleared(flow, news)
        if (flow.flow, news.task) not in self._passive:
            cause = Reason.of("engine.not_turned_on", where=where, why=news.reason)
            if flow.state is FlowState.SPAWNING or not self._recovery.stands_still:
                return self._abort(cause)
            return self._recovery.refused(flow, news.task, cause)
        flow.flow_tasks.given_up(news.task)
        flow.revision += 1
        return [RunNote(flow.flow, Reason.of("engine.passive_stays_off", where=where, why=news.reason))]

    def _not_cleared(self, flow: Progress, news: Refused) -> list[Order]:
        """A task that was cleared twice is refused the second time, which is no harm."""
        if news.task not in flow.flow_tasks.in_error:
            return []
        reason = Reason.of("engine.not_cleared", where=flow.where(news.task), why=news.reason)
        is_clearing = flow.state is FlowState.CLEARING
        if is_clearing:
            return self._recovery.not_cleared(flow, reason)
        return [RunNote(flow.flow, reason)]

    def _abort(self, cause: Reason) -> list[Order]:
        if any(flow.state in _OVER for flow in self._flows):
            return []
        self._cause = cause
        return self._kill_all()

    def _kill_all(self) -> list[Order]:
        orders: list[Order] = []
        for flow in self._flows:
            flow.enter(FlowEvent.KILL)
            orders += flow.flow_tasks.kill()
            if flow.flow_tasks.is_gone:
                flow.enter(FlowEvent.GONE)
        return orders + self._end_if_over()

    def _gone(self, flow: Progress, task: str) -> list[Order]:
        flow.flow_tasks.gone(task)
        if flow.state is FlowState.KILLING and flow.flow_tasks.is_gone:
            flow.enter(FlowEvent.GONE)
        return self._end_if_over()

    def _end_if_over(self) -> list[Order]:
        if not all(flow.state is FlowState.ENDED for flow in self._flows):
            return []
        return [End(completed=self._cause is None, cause=self._cause or NOTHING)]


def _question(flow: Progress, news: Asked) -> Reason:
    where = flow.where(news.task)
    if news.reason:
        return Reason.of("engine.asks_again", where=where, why=news.reason)
    return Reason.of("engine.asks", where=where)


def _judge_of(judge: Callable[[int, str], bool], flow: int) -> Callable[[str], bool]:
    return lambda condition: judge(flow, condition)
