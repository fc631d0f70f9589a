"""The tasks of one flow of a running application: who lives, who is ON, who has failed (§5.3.4)."""

from collections.abc import Mapping

from onika.engine.orders import Kill, Off, Order, Spawn, Switch
from onika.engine.step import ActionStep
from onika.model.rules.reconfiguration import difference
from onika.wire.plan import PlannedFlow


class FlowTasks:
    """What it is told it writes down, what it is bidden it answers with orders."""

    def __init__(self, flow: int, planned: PlannedFlow, ranks: Mapping[str, int]) -> None:
        self._flow = flow
        self._ranks = ranks
        self._spawn_order = tuple(task.name for task in planned.tasks)
        self._rates = {task.name: task.frequency for task in planned.tasks}
        self._places = {task.name: task.place for task in planned.tasks}
        self._living: set[str] = set()  # spawned or being spawned
        self._unborn: set[str] = set()  # being spawned
        self._broken: set[str] = set()  # passive, left off for the rest of the run
        self._on: dict[str, bool] = {}  # ordered ON → has said that it is ON since
        self.failed: dict[str, bool] = {}
        """Tasks that the flow stands still for, and whether they were to be ON."""
        self.in_error: set[str] = set()
        """Those of them that are in ERROR still."""

    @property
    def is_spawned(self) -> bool:
        """Whether no task is still awaited."""
        return not self._unborn

    @property
    def is_settled(self) -> bool:
        """Whether everybody who is to be ON has said so."""
        return all(self._on.values())

    @property
    def is_gone(self) -> bool:
        """Whether nobody lives."""
        return not self._living

    def place(self, task: str) -> str:
        """The file of a task."""
        return self._places[task]

    def lives(self, task: str) -> bool:
        """Whether the task has been ordered to life and is not gone."""
        return task in self._living

    def is_unborn(self, task: str) -> bool:
        """Whether the task is still being spawned."""
        return task in self._unborn

    def spawn(self) -> list[Order]:
        """Bring all tasks to life."""
        self._living = set(self._spawn_order)
        self._unborn = set(self._spawn_order)
        return [Spawn(self._flow, task) for task in self._spawn_order]

    def kill(self) -> list[Order]:
        """End all tasks, hardware first: its drive goes to hold before the task that commands it vanishes."""
        return [Kill(self._flow, task) for task in sorted(self._living, key=self._ranks.__getitem__)]

    # Switches

    def change(self, step: ActionStep, number: int = 0, finished: str = "") -> Switch:
        """What has to be switched for a step, as if `finished` had gone off; nothing is written down yet.

        Its triggers come on anew even when they are ON still: a new action is a new activation.
        """
        present = [task for task in self._on if task != finished]
        again = tuple([task for task in present if task in step.triggers])
        wanted = [task for task in step.tasks if task not in self._broken]
        change = difference([task for task in present if task not in again], wanted)
        kept_rates = tuple([(task, rate) for task in change.keep if (rate := self._new_rate(step, task)) is not None])
        starts = tuple([step.start(task) for task in change.on])
        return Switch(self._flow, again + change.off, starts, kept_rates, number)

    def _new_rate(self, step: ActionStep, task: str) -> float | None:
        """The rate of a task that stays ON, if it is another one now."""
        rate = step.rates[task]
        return rate if rate != self._rates[task] else None

    def carry_out(self, step: ActionStep, switch: Switch) -> None:
        """The switch is ordered: from now on who is to be ON is what the step says."""
        started = {start.task for start in switch.on}
        wanted = [task for task in step.tasks if task not in self._broken]
        self._on = {task: task not in started and self._on.get(task, False) for task in wanted}
        self._rates.update(step.rates)

    def bring_back(self, step: ActionStep | None) -> list[Order]:
        """The tasks that had failed come on again where the flow does not repeat a step; a trigger does not:

        its action is over, and nothing moves while the flow waits.
        """
        held = set(step.tasks).difference(step.triggers) if step is not None else set()
        back = sorted((task for task in held if self.failed.get(task)), key=self._ranks.__getitem__)
        self.failed.clear()
        self._on |= dict.fromkeys(back, False)
        if step is not None and back:
            return [Switch(self._flow, (), tuple(step.start(task) for task in back))]
        return []

    def rest(self, triggers: tuple[str, ...]) -> list[Off]:
        """These go off: the action is over before they have finished."""
        on = [task for task in triggers if task in self._on]
        for task in on:
            del self._on[task]
        return [Off(self._flow, task) for task in on]

    # What is said of tasks

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

    def given_up(self, task: str) -> None:
        """A passive task is in ERROR or will not come on: it is left off for the rest of the run."""
        self._unborn.discard(task)
        self._on.pop(task, None)
        self._broken.add(task)

    def has_failed(self, task: str) -> None:
        """A task is in ERROR, and the flow cannot go on without it."""
        self.failed[task] = task in self._on or self.failed.get(task, False)
        self.in_error.add(task)
        self._on.pop(task, None)

    def would_not(self, task: str) -> None:
        """A task was refused to come on; it is OFF."""
        self._on.pop(task, None)

    def gone(self, task: str) -> None:
        """The task lives no more, or never came to life."""
        self._living.discard(task)
        self._unborn.discard(task)
        self._on.pop(task, None)
