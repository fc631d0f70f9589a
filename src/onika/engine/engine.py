"""The engine: executes the flows of a plan by superset dynamic reconfiguration (§5.9.2, Table 9).

It has neither clock nor link. It is fed news, one at a time and in the order in which each task spoke, and
answers with orders, to be carried out in their order. All tasks are spawned first; then each action of each flow
is one switch, begun by the trigger that finished the one before; at the end, or at an abort, all tasks are killed.
"""

from collections.abc import Mapping, Set

from onika.engine.flow import FlowState
from onika.engine.meeting import Meetings
from onika.engine.news import (
    Abort,
    Asked,
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
    TurnedOn,
)
from onika.engine.orders import End, Note, Order, Settle
from onika.engine.progress import Progress
from onika.engine.step import steps
from onika.wire.plan import Plan

TaskNews = Spawned | Refused | TurnedOn | Finished | SwitchedOff | Failed | Asked | Illegal | Killed

_OVER = (FlowState.KILLING, FlowState.ENDED)


class Engine:
    """Executes one plan once.

    `triggers` names, for every (flow, action), the task that takes the target and ends the action; none for a
    job without one. `other_triggers` are (flow, task) of further trigger tasks, which end an action too when
    they finish first (decision 16). `passive` are the (flow, task) that may fall silent. `ranks` gives the order
    in which the tasks of a flow come on. Raises ValueError or KeyError for a plan that these do not describe.
    """

    def __init__(
        self,
        plan: Plan,
        triggers: Mapping[tuple[int, int], str | None],
        passive: Set[tuple[int, str]],
        ranks: Mapping[tuple[int, str], int],
        other_triggers: Set[tuple[int, str]] = frozenset(),
    ) -> None:
        if not plan.flows:
            raise ValueError(f"expected a plan with at least one flow, found none in {plan.application}")
        self._passive = frozenset(passive)
        self._meetings = Meetings(plan.flows)
        self._cause: str | None = None
        self._flows: list[Progress] = []
        for flow, planned in enumerate(plan.flows):
            own_ranks = {task.name: ranks[flow, task.name] for task in planned.tasks}
            own_triggers = {index: triggers[flow, index] for index in range(len(planned.actions))}
            others = {task for number, task in other_triggers if number == flow}
            ready = steps(planned, own_triggers, others, own_ranks)
            self._flows.append(Progress(flow, planned, ready, own_ranks))

    def feed(self, news: News) -> list[Order]:
        """Hear one piece of news; the orders that follow from it. What comes too late changes nothing."""
        match news:
            case Run():
                return self._run()
            case Settled():
                is_done = all(flow.state is FlowState.DONE for flow in self._flows)
                return self._kill_all() if is_done else []
            case Abort():
                return self._abort(news.cause)
            case _:
                return self._hear(self._flows[news.flow], news)

    def _run(self) -> list[Order]:
        if any(flow.state is not FlowState.READY for flow in self._flows):
            return []
        orders = [order for flow in self._flows for order in flow.spawn()]
        return orders + self._begin_when_spawned()

    def _hear(self, flow: Progress, news: TaskNews) -> list[Order]:
        if not flow.lives(news.task):
            is_late = flow.state in (FlowState.READY, *_OVER)
            return [] if is_late else [Note(flow.flow, f"{news.task} is no task of this flow: ignored")]
        if flow.state in _OVER:
            return self._hear_while_killing(flow, news)
        match news:
            case Spawned():
                flow.spawned(news.task)
                return self._begin_when_spawned()
            case TurnedOn():
                flow.turned_on(news.task)
                return []
            case Finished():
                return self._finished(flow, news.task)
            case SwitchedOff():
                return self._switched_off(flow, news.task)
            case Asked():
                return [Note(flow.flow, f"{flow.where(news.task)} asks" + (f": {news.reason}" if news.reason else ""))]
            case Failed():
                return self._failed(flow, news)
            case Illegal():
                return self._abort(f"{flow.where(news.task)} may not go on: {news.text}")
            case Refused():
                return self._refused(flow, news)
            case Killed():
                cause = f"{flow.where(news.task)} is gone"
                flow.gone(news.task)
                return self._abort(cause)

    def _hear_while_killing(self, flow: Progress, news: TaskNews) -> list[Order]:
        match news:
            case Spawned():
                flow.spawned(news.task)
            case Killed():
                flow.gone(news.task)
                return self._end_if_over()
            case Refused() if flow.is_unborn(news.task):
                flow.gone(news.task)
                return self._end_if_over()
            case _:
                pass
        return []

    def _begin_when_spawned(self) -> list[Order]:
        """No robot moves before every task of every flow has come to life."""
        if not all(flow.state is FlowState.SPAWNING and flow.is_spawned for flow in self._flows):
            return []
        return [order for flow in self._flows for order in self._go_on(flow)]

    def _go_on(self, flow: Progress) -> list[Order]:
        step = flow.next_step
        if step is None:
            return self._complete(flow)
        if step.synch_tag is None:
            return flow.begin()
        flow.hold()
        return self._meet(flow, step.synch_tag)

    def _meet(self, flow: Progress, tag: str) -> list[Order]:
        absent = self._meetings.absent(tag, self._flows)
        if not absent:
            return [order for number in self._meetings.parties(tag) for order in self._flows[number].begin()]
        return [self._waits(flow, tag, number) for number in absent]

    def _waits(self, flow: Progress, tag: str, number: int) -> Note:
        has_ended = self._flows[number].state is FlowState.DONE
        return Note(flow.flow, f"waits at {tag} for flow {number}" + (", which has ended" if has_ended else ""))

    def _complete(self, flow: Progress) -> list[Order]:
        flow.complete()
        if all(other.state is FlowState.DONE for other in self._flows):
            return [Settle()]
        deserted = self._meetings.deserted(flow.flow, self._flows)
        return [self._waits(other, tag, flow.flow) for other, tag in deserted]

    def _finished(self, flow: Progress, task: str) -> list[Order]:
        done = flow.finished(task)
        if done is None:
            return [Note(flow.flow, f"{flow.where(task)} has finished, which ends no action now: ignored")]
        return done + self._go_on(flow)

    def _switched_off(self, flow: Progress, task: str) -> list[Order]:
        flow.switched_off(task)
        harm = "the job goes on" if (flow.flow, task) in self._passive else "ignored, though it is not passive"
        return [Note(flow.flow, f"{flow.where(task)} has switched itself off: {harm}")]

    def _failed(self, flow: Progress, news: Failed) -> list[Order]:
        if (flow.flow, news.task) not in self._passive:
            return self._abort(f"{flow.where(news.task)} is in error: {news.text}")
        flow.failed(news.task)
        note = Note(flow.flow, f"{flow.where(news.task)} is in error and stays off, the job goes on: {news.text}")
        return [note, *self._begin_when_spawned()]

    def _refused(self, flow: Progress, news: Refused) -> list[Order]:
        """A passive task that cannot come on is as harmless as one in error; one that cannot be spawned is not."""
        if flow.is_unborn(news.task):
            cause = f"{flow.where(news.task)} cannot be spawned: {news.reason}"
            flow.gone(news.task)
            return self._abort(cause)
        if (flow.flow, news.task) not in self._passive:
            return self._abort(f"{flow.where(news.task)} cannot be turned on: {news.reason}")
        flow.failed(news.task)
        return [Note(flow.flow, f"{flow.where(news.task)} stays off, the job goes on: {news.reason}")]

    def _abort(self, cause: str) -> list[Order]:
        if any(flow.state in _OVER for flow in self._flows):
            return []
        self._cause = cause
        return self._kill_all()

    def _kill_all(self) -> list[Order]:
        orders = [order for flow in self._flows for order in flow.kill()]
        return orders + self._end_if_over()

    def _end_if_over(self) -> list[Order]:
        if not all(flow.state is FlowState.ENDED for flow in self._flows):
            return []
        return [End(completed=self._cause is None, cause=self._cause or "")]
