"""On which processing unit a task runs that names none of this runtime: one unit is taken, several are asked about.

It is asked once for each such task, before the run; what is chosen holds for that run (reading 12).
"""

from msgspec import structs

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.reconcile.reconciliation import living_units
from onika.desk.environment.state.model import Model
from onika.wire import act
from onika.wire.plan import Plan
from onika.wire.view import Remedy
from onika.words.reason import Reason


def question(model: Model, plan: Plan, name: str, command: act.Run) -> No | None:
    """Where several units live and tasks name none of them: which one; None: nothing is left to ask."""
    units = living_units(model)
    chosen = {task for task, unit in command.units if unit in units}
    tasks = tuple(task for task in _homeless(plan, units) if task not in chosen)
    if len(units) < 2 or not tasks:
        return None
    reason = Reason.of("run.which_unit", name=name, tasks=tasks, units=units)
    return No(reason, (*_of_first(tasks, units, command), *_of_all(tasks, units, command)))


def placed(plan: Plan, command: act.Run) -> Plan:
    """The plan with the tasks that name no unit of this runtime on those that were chosen."""
    chosen = dict(command.units)
    flows = tuple(
        structs.replace(
            flow, tasks=tuple(structs.replace(task, rtpu=chosen.get(task.name, task.rtpu)) for task in flow.tasks)
        )
        for flow in plan.flows
    )
    return structs.replace(plan, flows=flows)


def _homeless(plan: Plan, units: tuple[str, ...]) -> tuple[str, ...]:
    """The tasks that name no unit that lives, each once."""
    return tuple(dict.fromkeys(task.name for flow in plan.flows for task in flow.tasks if task.rtpu not in units))


def _of_first(tasks: tuple[str, ...], units: tuple[str, ...], command: act.Run) -> tuple[Remedy, ...]:
    """A unit for the first task; the others are asked about after it."""
    return tuple(
        Remedy(Reason.of("run.task_on_unit", task=tasks[0], unit=unit), _with(command, tasks[:1], unit))
        for unit in units
    )


def _of_all(tasks: tuple[str, ...], units: tuple[str, ...], command: act.Run) -> tuple[Remedy, ...]:
    """One unit for all that are left."""
    if len(tasks) < 2:
        return ()
    return tuple(Remedy(Reason.of("run.all_on_unit", unit=unit), _with(command, tasks, unit)) for unit in units)


def _with(command: act.Run, tasks: tuple[str, ...], unit: str) -> act.Run:
    former = tuple((task, before) for task, before in command.units if task not in tasks)
    return structs.replace(command, units=(*former, *((task, unit) for task in tasks)))
