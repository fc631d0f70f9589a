"""A step of a flow ready for switching: its tasks in the order of their ranks, their rates, its triggers."""

from collections.abc import Mapping, Set

from msgspec import Struct

from onika.engine.orders import Launch
from onika.wire.plan import PlannedAction, PlannedFlow
from onika.words.reason import Reason


class ActionStep(Struct, frozen=True):
    """What a flow switches to."""

    name: str
    place: Reason
    """The file, its line and the name of the action there."""
    tasks: tuple[str, ...]
    """To be ON, in the order in which they come on."""
    rates: Mapping[str, float | None]
    """Of every task, in hertz; none for a task without a rate."""
    triggers: tuple[str, ...]
    """Whoever finishes first ends the action (reading 16); the first one takes the argument line."""
    arguments: str

    def start(self, task: str) -> Launch:
        """The order to turn one of its tasks ON."""
        takes_target = self.triggers[:1] == (task,)
        return Launch(task, self.arguments if takes_target else "", self.rates[task])


def steps(
    planned: PlannedFlow,
    triggers: Mapping[int, str | None],
    other_triggers: Set[str],
    ranks: Mapping[str, int],
) -> tuple[ActionStep, ...]:
    """The actions of a flow; raises KeyError where a trigger, rank or task that an action needs is not given."""
    usual = {task.name: task.frequency for task in planned.tasks}
    return tuple(
        _step(action, triggers[index], other_triggers, ranks, usual) for index, action in enumerate(planned.actions)
    )


def _step(
    action: PlannedAction,
    trigger: str | None,
    other_triggers: Set[str],
    ranks: Mapping[str, int],
    usual: Mapping[str, float | None],
) -> ActionStep:
    if trigger is not None and trigger not in action.tasks:
        place = str(action.place)
        raise ValueError(Reason.of("engine.form_trigger", place=place, tasks=tuple(action.tasks), trigger=trigger))
    others = (task for task in action.tasks if task in other_triggers and task != trigger)
    return ActionStep(
        name=action.name,
        place=_place(action),
        tasks=tuple(sorted(action.tasks, key=ranks.__getitem__)),
        rates={task: usual[task] for task in action.tasks} | dict(action.rates),
        triggers=() if trigger is None else (trigger, *others),
        arguments=action.arguments,
    )


def _place(action: PlannedAction) -> Reason:
    if not action.line:
        return Reason.plain(action.place)
    return Reason.of("engine.action_at", file=action.place, line=str(action.line), action=action.name)
