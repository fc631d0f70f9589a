"""A run takes over what lives in its way: what happens to each task is told before, Equation (1) (C18, reading 30).

A run begins on empty tables (law 4): a task that both sides have is ended, and begins anew with the run.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.runs.obstacles import Obstacle, left
from onika.desk.environment.runs.unsaved import Changed
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TakenOver
from onika.desk.environment.state.model import Model
from onika.model.planned import task_of
from onika.model.rules.union import devices
from onika.wire import act
from onika.wire.plan import Plan, PlannedTask
from onika.wire.view import Remedy
from onika.words.reason import NOTHING, Reason


def unsaved(documents: Iterable[Document]) -> tuple[Changed, ...]:
    """Those of them that have a file and differ from it."""
    return tuple((document.id, document.name) for document in documents if document.opened and document.is_dirty)


def question(
    model: Model, obstacles: Sequence[Obstacle], name: str, plan: Plan, command: act.Run, changed: Sequence[Changed]
) -> No:
    """What happens to each task, what is put back afterwards, and what is not saved; asked once."""
    taken = _documents(model, obstacles)
    strangers = tuple(obstacle.subsystem for obstacle in obstacles if not obstacle.document)
    fates = Fates.between([task for obstacle in obstacles for task in obstacle.living], plan)
    reason = Reason.of(
        "run.takes_over",
        obstacles=tuple(obstacle.named for obstacle in obstacles),
        name=name,
        fates=fates.parts,
        afterwards=_afterwards(model, taken, strangers, changed),
    )
    return No(reason, _remedies(command, changed))


def in_a_switch(model: Model, obstacles: Sequence[Obstacle], command: act.Run) -> No | None:
    """Why nothing is taken over yet: a change of it is on its way, and nobody knows yet what there will be."""
    for document in _documents(model, obstacles):
        if document.live is not None and document.live.is_changing:
            again = Remedy(Reason.of("run.try_again"), command)
            return No(Reason.of("run.in_a_switch", name=document.name), (again,))
    return None


def taken_over(model: Model, subsystem: str, run: int, application: str) -> Model:
    """The model whose document of a subsystem is taken over by a run; its layout stays."""
    documents = [
        document for document in model.documents_here.values() if document.live and document.live.subsystem == subsystem
    ]
    after = left(model, (subsystem,))
    for document in documents:
        taken = TakenOver(run, application, subsystem, frozenset(returning(model, document)))
        after = after.with_document(replace(after.documents[document.id], taken=taken))
    return after


def returning(model: Model, document: Document) -> tuple[str, ...]:
    """The tasks that come ON again afterwards: those that are ON, but no trigger, which would move once more."""
    libraries, wanted = model.libraries, document.content.wanted
    on = (name for name in document.content.names if wanted.get(name, False) and name in libraries.tasks)
    sheets = {name: libraries.sheets.get(libraries.tasks[name].module) for name in on}
    return tuple(name for name, sheet in sheets.items() if sheet is not None and not sheet.trigger)


@dataclass(frozen=True, slots=True)
class Fates:
    """What happens to each task where a run takes over what lives."""

    again: tuple[str, ...]
    """On both sides, as it is: it ends, and begins anew with the run."""
    exchanged: tuple[str, ...]
    """On both sides by its name; its file or its code differs."""
    gives_way: tuple[tuple[str, str], ...]
    """Each to a task of another name that needs its module or its device."""
    ends: tuple[str, ...]
    comes: tuple[str, ...]

    @classmethod
    def between(cls, living: Sequence[PlannedTask], plan: Plan) -> "Fates":
        """From what lives to a plan."""
        new = {task.name: task for flow in plan.flows for task in flow.tasks}
        both = [task for task in living if task.name in new]
        again = tuple(task.name for task in both if _is_same(task, new[task.name]))
        others = [task for task in living if task.name not in new]
        rivals = {task.name: _rival(task, plan) for task in others}
        gives_way = tuple((name, rival) for name, rival in rivals.items() if rival)
        there = {*(task.name for task in living), *rivals.values()}
        return cls(
            again=again,
            exchanged=tuple(task.name for task in both if task.name not in again),
            gives_way=gives_way,
            ends=tuple(name for name, rival in rivals.items() if not rival),
            comes=tuple(name for name in new if name not in there),
        )

    @property
    def parts(self) -> tuple[Reason, ...]:
        """In words."""
        parts = (
            _part("run.fate_again", self.again),
            _part("run.fate_exchanged", self.exchanged),
            *(Reason.of("run.fate_gives_way", task=task, rival=rival) for task, rival in self.gives_way),
            _part("run.fate_ends", self.ends),
            _part("run.fate_comes", self.comes),
        )
        return tuple(part for part in parts if part)


def _documents(model: Model, obstacles: Sequence[Obstacle]) -> list[Document]:
    subsystems = {obstacle.subsystem for obstacle in obstacles}
    documents = model.documents_here.values()
    return [document for document in documents if document.live and document.live.subsystem in subsystems]


def _rival(task: PlannedTask, plan: Plan) -> str:
    """The first task of a plan that needs the module or the device of this one; empty: none does."""
    claims = set(devices(task_of(task)))
    for flow in plan.flows:
        for other in flow.tasks:
            if other.module == task.module or not claims.isdisjoint(devices(task_of(other))):
                return other.name
    return ""


def _is_same(living: PlannedTask, planned: PlannedTask) -> bool:
    """Whether it is one task on both sides; its rate and its unit are those of the plan in any case."""
    return structs.replace(living, **_ELSEWHERE) == structs.replace(planned, **_ELSEWHERE)


_ELSEWHERE = {"rtpu": "", "frequency": None, "place": ""}
"""What may differ in a task that is the same."""


def _part(key: str, names: Sequence[str]) -> Reason:
    if names:
        return Reason.of(key, tasks=tuple(names))
    return NOTHING


def _afterwards(
    model: Model, taken: Sequence[Document], strangers: Sequence[str], changed: Sequence[Changed]
) -> tuple[Reason, ...]:
    """What is put back, what is not, and what is not saved."""
    names = tuple(document.name for document in taken)
    on = tuple(task for document in taken for task in returning(model, document))
    parts = []
    if names and on:
        parts.append(Reason.of("run.puts_back_on", names=names, tasks=on))
    elif names:
        parts.append(Reason.of("run.puts_back", names=names))
    if strangers:
        parts.append(Reason.of("run.puts_not_back", names=tuple(strangers)))
    if changed:
        parts.append(Reason.of("run.taken_unsaved", names=tuple(name for _, name in changed)))
    return tuple(parts)


def _remedies(command: act.Run, changed: Sequence[Changed]) -> tuple[Remedy, ...]:
    sure = structs.replace(command, confirmed=True)
    if not changed:
        return (Remedy(Reason.of("run.take_over_and_run"), sure),)
    return (
        Remedy(Reason.of("run.save_take_over_and_run"), structs.replace(sure, saves_unsaved=True)),
        Remedy(Reason.of("run.take_over_and_run_unsaved"), structs.replace(sure, ignores_unsaved=True)),
    )
