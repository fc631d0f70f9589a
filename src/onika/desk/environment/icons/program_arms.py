"""The arms of an open application, and the tasks that would measure where each stands (D13, D23)."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from onika.desk.environment.icons.alteration import flow_at
from onika.desk.environment.reconcile.task_plan import SpawnPlan, birth, is_hardware
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.state.target_items import ports_of
from onika.model.application import Application, Icon
from onika.model.configuration import Placed
from onika.model.flow_path import flows_by_path
from onika.model.planned import task_of
from onika.model.rules.union import devices
from onika.model.task import Task
from onika.wire.plan import Code, Plan, PlannedTask

IsHardware = Callable[[PlannedTask], bool]


@dataclass(frozen=True, slots=True)
class MeasuringTasks:
    """The driver of an arm, and the tasks that make of its measurement what is wanted; nothing commands the arm."""

    driver: PlannedTask
    others: tuple[PlannedTask, ...]
    code: tuple[Code, ...] = field(repr=False)
    stands_for: str = ""
    """The arm's task as the application names it, where the driver stands for it in a redirected flow."""

    @property
    def arm(self) -> str:
        """The name of the arm's task."""
        return self.driver.name

    @property
    def made_for(self) -> str:
        """The name of the arm's task in the files: a target of this arm keeps it."""
        return self.stands_for or self.arm

    @property
    def tasks(self) -> tuple[PlannedTask, ...]:
        """All of them, the driver first."""
        return (self.driver, *self.others)

    @property
    def devices(self) -> frozenset[str]:
        """What the driver claims, as `WORLD:NAME`."""
        return frozenset(devices(task_of(self.driver)))


def jobs_near(application: Application, path: str, after: int) -> tuple[str, ...]:
    """The icons of an application from a place of it backwards, then those behind it, then those of other flows."""
    here = flow_at(application, path)
    numbers = [step.number for step in here.steps] if here is not None else []
    at = numbers.index(after) + 1 if after in numbers else 0
    steps = [*reversed(here.steps[:at]), *here.steps[at:]] if here is not None else []
    steps += [step for other, flow in flows_by_path(application) if other != path for step in flow.steps]
    return tuple(dict.fromkeys(step.onikon.name for step in steps if isinstance(step, Icon)))


def arms_of(
    plan: Plan, jobs: Sequence[str], wanted: frozenset[str], libraries: OpenLibraries
) -> tuple[MeasuringTasks, ...]:
    """The arms that an application moves, those of the first jobs first, each with what measures the variables."""

    def drives(task: PlannedTask) -> bool:
        return is_hardware(task_of(task), libraries)

    arms: dict[str, MeasuringTasks] = {}
    stood_for = {name: former.name for flow in plan.flows for name, former in flow.replaced}
    for tasks in _crews(plan, jobs):
        measuring = _measuring(tasks, wanted, drives) or _with_library(tasks, wanted, drives, libraries)
        if measuring is None:
            continue
        driver, others, births = measuring
        digests = {task.digest for task in (driver, *others)}
        code = {code.digest: code for code in (*plan.code, *births) if code.digest in digests}
        stands_for = stood_for.get(driver.name, "")
        arms.setdefault(driver.name, MeasuringTasks(driver, others, tuple(code.values()), stands_for))
    return tuple(arms.values())


_Measuring = tuple[PlannedTask, tuple[PlannedTask, ...], tuple[Code, ...]]


def _crews(plan: Plan, jobs: Iterable[str]) -> Iterator[tuple[PlannedTask, ...]]:
    """The tasks of each job, in the order in which the jobs are named; redirected ones as they stand for others."""
    for job in jobs:
        for flow in plan.flows:
            action = next((action for action in flow.actions if action.job == job), None)
            if action is not None:
                yield tuple(task for task in flow.tasks if task.name in action.tasks)


def _measuring(tasks: Sequence[PlannedTask], wanted: frozenset[str], drives: IsHardware) -> _Measuring | None:
    """A driver and all that leads from its measurement to a wanted variable; None: they do not measure it."""
    needed = _needed(tasks, wanted, drives)
    drivers = [task for task in needed if drives(task)]
    if len(drivers) != 1:
        return None
    others = tuple(task for task in needed if task not in drivers)
    given = {variable for task in others for variable in task_of(task).outputs}
    if given & task_of(drivers[0]).inputs:
        return None  # it would be commanded
    return drivers[0], others, ()


def _needed(tasks: Sequence[PlannedTask], wanted: frozenset[str], drives: IsHardware) -> list[PlannedTask]:
    """What writes the wanted variables, and all that supplies that; nothing where a supplier is missing."""
    read = {task.name: task_of(task) for task in tasks}
    needed = [task for task in tasks if read[task.name].given_while_running & wanted]
    for task in needed:  # grows while it is gone through
        for variable in () if drives(task) else sorted(read[task.name].inputs):
            supplier = next((other for other in tasks if variable in read[other.name].outputs), None)
            if supplier is None:
                return []
            if supplier not in needed:
                needed.append(supplier)
    return needed


def _acts(task: Task, libraries: OpenLibraries) -> bool:
    """Whether a task does more than compute: it moves a device, or ends an action."""
    sheet = libraries.sheets.get(task.module)
    is_trigger = sheet.trigger if sheet is not None else task.object_type is not None
    return is_trigger or is_hardware(task, libraries)


def _agrees(task: Task, tasks: Sequence[PlannedTask], libraries: OpenLibraries) -> bool:
    """Whether a task has the same shapes and units for the variables that it shares with others."""
    mine = _shapes(task, libraries)
    return all(
        mine.get(name, shape) == shape for other in tasks for name, shape in _shapes(task_of(other), libraries).items()
    )


def _shapes(task: Task, libraries: OpenLibraries) -> dict[str, tuple[str, str]]:
    """Shape and unit of each of its variables, as far as its module is known."""
    names = dict(task.aliases)
    return {names.get(port.name, port.name): (port.shape, port.unit) for port in ports_of(libraries, task)}


def _with_library(
    tasks: Sequence[PlannedTask], wanted: frozenset[str], drives: IsHardware, libraries: OpenLibraries
) -> _Measuring | None:
    """The same with one more task of the libraries, that makes the wanted variable of what the driver gives."""
    for name, task in libraries.tasks.items():
        if not task.given_while_running & wanted or _acts(task, libraries) or not _agrees(task, tasks, libraries):
            continue
        born = birth(Placed(name), libraries, ())
        if not isinstance(born, SpawnPlan):
            continue
        measuring = _measuring((*tasks, born.task), wanted, drives)
        if measuring is not None:
            driver, others, _ = measuring
            return driver, others, (born.code,)
    return None
