"""How far one flow of a running application is: its action, its tasks that live, those that are ON (§5.9.2)."""

from collections.abc import Mapping

from onika.engine.flow import FlowEvent, FlowState, after
from onika.engine.orders import Began, Done, Kill, Note, Order, Spawn, Switch
from onika.engine.step import Step
from onika.model.rules.reconfiguration import difference
from onika.wire.plan import PlannedFlow


class Progress:
    """One flow under execution; what it is told it writes down, what it is bidden it answers with orders."""

    def __init__(self, flow: int, planned: PlannedFlow, steps: tuple[Step, ...], ranks: Mapping[str, int]) -> None:
        self.flow = flow
        self.state = FlowState.READY
        self._steps = steps
        self._ranks = ranks
        self._current = -1
        self._spawn_order = tuple(task.name for task in planned.tasks)
        self._rates = {task.name: task.frequency for task in planned.tasks}
        self._places = {task.name: task.place for task in planned.tasks}
        self._living: set[str] = set()  # spawned or being spawned
        self._unborn: set[str] = set()  # being spawned
        self._broken: set[str] = set()  # left off for the rest of the run
        self._on: dict[str, bool] = {}  # ordered ON → has said that it is ON since

    @property
    def next_step(self) -> Step | None:
        """The action after the current one, if there is one."""
        following = self._current + 1
        return self._steps[following] if following < len(self._steps) else None

    @property
    def is_spawned(self) -> bool:
        """Whether no task is still awaited."""
        return not self._unborn

    def lives(self, task: str) -> bool:
        """Whether the task has been ordered to life and is not gone."""
        return task in self._living

    def is_unborn(self, task: str) -> bool:
        """Whether the task is still being spawned."""
        return task in self._unborn

    def where(self, task: str) -> str:
        """A task and where the run stands, for messages."""
        place = self._steps[self._current].place if self._current >= 0 else self._places[task]
        return f"{place}: {task}"

    def spawn(self) -> list[Order]:
        """Bring all tasks of the flow to life."""
        self.state = after(self.state, FlowEvent.SPAWN)
        self._living = set(self._spawn_order)
        self._unborn = set(self._spawn_order)
        return [Spawn(self.flow, task) for task in self._spawn_order]

    def begin(self) -> list[Order]:
        """Switch to the next action.

        Its triggers come on anew even when they are ON still: a new action is a new activation.
        """
        step = self._steps[self._current + 1]
        self.state = after(self.state, FlowEvent.BEGIN)
        self._current += 1
        again = tuple(task for task in self._on if task in step.triggers)
        wanted = [task for task in step.tasks if task not in self._broken]
        change = difference([task for task in self._on if task not in again], wanted)
        rates = ((task, step.rates[task]) for task in change.keep)
        kept_rates = tuple((task, rate) for task, rate in rates if rate is not None and rate != self._rates[task])
        self._on = {task: self._on[task] if task in change.keep else False for task in wanted}
        self._rates.update(step.rates)
        starts = tuple(step.start(task) for task in change.on)
        orders: list[Order] = [
            Switch(self.flow, again + change.off, starts, kept_rates),
            Began(self.flow, self._current),
        ]
        if not step.triggers:
            orders.append(Note(self.flow, f"{step.place}: {step.name} has no trigger: it goes on until it is aborted"))
        return orders

    def hold(self) -> None:
        """Wait at the synchronisation tag of the next action; what is ON stays ON and holds (law 6)."""
        self.state = after(self.state, FlowEvent.HOLD)

    def complete(self) -> None:
        """All actions are done; what is ON stays ON."""
        self.state = after(self.state, FlowEvent.COMPLETE)

    def kill(self) -> list[Order]:
        """End all tasks, hardware first: its drive goes to hold before the task that commands it vanishes."""
        self.state = after(self.state, FlowEvent.KILL)
        orders: list[Order] = [Kill(self.flow, task) for task in sorted(self._living, key=self._ranks.__getitem__)]
        self._end_if_empty()
        return orders

    def spawned(self, task: str) -> None:
        """The task is initialised."""
        self._unborn.discard(task)

    def turned_on(self, task: str) -> None:
        """The task is ON; late news of a task that is to be off by now says nothing."""
        if task in self._on:
            self._on[task] = True

    def switched_off(self, task: str) -> bool:
        """The task went off by itself; False if that was before it was last turned ON."""
        if not self._on.get(task, False):
            return False
        del self._on[task]
        return True

    def finished(self, task: str) -> list[Order] | None:
        """A task ended its job; none if that does not end the action.

        It must be a trigger of the action and have been ON in it: the second word of a trigger that has
        finished, or one that was long under way, would else end the next action as well.
        """
        was_on = self.switched_off(task)
        if not was_on or self.state is not FlowState.RUNNING or task not in self._steps[self._current].triggers:
            return None
        return [Done(self.flow, self._current)]

    def failed(self, task: str) -> None:
        """The task is in ERROR or will not come on: it is left off for the rest of the run."""
        self._unborn.discard(task)
        self._on.pop(task, None)
        self._broken.add(task)

    def gone(self, task: str) -> None:
        """The task lives no more, or never came to life."""
        self._living.discard(task)
        self._unborn.discard(task)
        self._on.pop(task, None)
        if self.state is FlowState.KILLING:
            self._end_if_empty()

    def _end_if_empty(self) -> None:
        if not self._living:
            self.state = after(self.state, FlowEvent.GONE)
