"""What lives already and stands in the way of a run: tasks of its names, its modules, its devices (reading 30)."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.planned import task_of
from onika.model.rules.union import devices
from onika.model.task import Task
from onika.wire.plan import Plan, PlannedTask
from onika.wire.runtime_standing import Standing, SubsystemStanding
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Obstacle:
    """A subsystem with tasks that cannot live beside those of a plan."""

    subsystem: str
    tasks: tuple[str, ...]
    living: tuple[PlannedTask, ...]
    """All that live in it, those too that share nothing with the plan."""
    document: str = ""
    """The name of the configuration that is connected with it; empty: none is open here."""

    @property
    def named(self) -> Reason:
        """Its tasks, and whose they are."""
        if self.document:
            return Reason.of("run.obstacle_of", tasks=self.tasks, name=self.document)
        return Reason.of("run.obstacle_in", tasks=self.tasks, subsystem=self.subsystem)


@dataclass(frozen=True, slots=True)
class _Wanted:
    """What the tasks of a plan need for themselves: their names, modules and devices."""

    names: frozenset[str]
    modules: frozenset[str]
    devices: frozenset[str]

    @classmethod
    def by(cls, plan: Plan) -> "_Wanted":
        """What a plan needs."""
        tasks = [task_of(task) for flow in plan.flows for task in flow.tasks]
        names, modules = (task.name for task in tasks), (task.module for task in tasks)
        return cls(frozenset(names), frozenset(modules), frozenset(_devices(tasks)))

    def is_had_by(self, task: Task) -> bool:
        """Whether a task has something of it."""
        is_same = task.name in self.names or task.module in self.modules
        return is_same or not self.devices.isdisjoint(_devices([task]))


def obstacles(model: Model, standing: Standing, plan: Plan) -> tuple[Obstacle, ...]:
    """All that lives in the way of a plan, by subsystem; what does not share anything with it lives on."""
    wanted = _Wanted.by(plan)
    documents = {document.live.subsystem: document.name for document in model.documents_here.values() if document.live}
    obstacles_met = []
    for subsystem in standing.subsystems:
        living = _living(subsystem)
        shared = tuple(task.name for task in living if wanted.is_had_by(task_of(task)))
        if shared:
            obstacles_met.append(Obstacle(subsystem.name, shared, living, documents.get(subsystem.name, "")))
    return tuple(obstacles_met)


def documents_in_the_way(model: Model, plan: Plan) -> tuple[Document, ...]:
    """The connected documents of which tasks live in the way of a plan, as far as it is known here."""
    wanted = _Wanted.by(plan)
    in_the_way = []
    for document in model.documents_here.values():
        names = document.live.tasks if document.live is not None and document.live.state == "live" else ()
        tasks = [model.libraries.tasks[name] for name in names if name in model.libraries.tasks]
        if any(wanted.is_had_by(task) for task in tasks):
            in_the_way.append(document)
    return tuple(in_the_way)


def _living(subsystem: SubsystemStanding) -> tuple[PlannedTask, ...]:
    """The living tasks of a subsystem; those of an application are not looked at."""
    if subsystem.application:
        return ()
    return tuple(task.task for task in subsystem.tasks if task.state != "KILLED")


def left(model: Model, subsystems: Iterable[str]) -> Model:
    """The model whose documents are connected with none of these subsystems any more; their layouts stay."""
    gone = set(subsystems)
    for document in model.documents_here.values():
        if document.live is not None and document.live.subsystem in gone:
            content = replace(document.content, wanted={})
            model = model.with_document(replace(document, content=content, live=None))
    return model


def _devices(tasks: Iterable[Task]) -> Iterator[str]:
    for task in tasks:
        yield from devices(task)
