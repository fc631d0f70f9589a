"""Which tasks may stand in one configuration, Equations (2) and (3) (dissertation §5.3.3, §4.2.2)."""

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from onika.model.task import Task
from onika.words.fault import Refusal
from onika.words.reason import Reason

_KEPT = 4096
"""Refusals that are made once: a library of a thousand tasks is judged anew at every click, with the same few words."""


def refusals(task: Task, placed: Iterable[Task]) -> tuple[Refusal, ...]:
    """Every reason why `task` may not join the tasks `placed`, Equation (2); empty: it may.

    The reasons are its name, its module, each output shared and each pure OUTVAR that meets a pure INCONST, by
    aliased names.
    """
    return tuple(refusal for other in placed if _meet(task, other) for refusal in _between(task, other))


def greyed(library: Iterable[Task], placed: Iterable[Task]) -> dict[str, tuple[Refusal, ...]]:
    """The set G of Equation (2): the tasks of a library that may not be placed, each with all its reasons."""
    standing = PlacedNeighbours(placed)
    reasons = {task.name: tuple(standing.against(task)) for task in library}
    return {name: reason for name, reason in reasons.items() if reason}


class PlacedNeighbours:
    """Tasks by what may speak between them and another one, so that few need be looked at."""

    def __init__(self, tasks: Iterable[Task]) -> None:
        self._tasks = tuple(tasks)
        self._names: dict[str, list[int]] = {}
        self._modules: dict[str, list[int]] = {}
        self._outputs: dict[str, list[int]] = {}
        self._given: dict[str, list[int]] = {}
        self._needed: dict[str, list[int]] = {}
        for at, task in enumerate(self._tasks):
            self._names.setdefault(task.name, []).append(at)
            self._modules.setdefault(task.module, []).append(at)
            _note(self._outputs, task.outputs, at)
            _note(self._given, task.given_while_running, at)
            _note(self._needed, task.needed_at_start, at)

    def against(self, task: Task) -> Iterator[Refusal]:
        """Every reason why `task` may not join them, in their order."""
        for other in self._near(task):
            yield from _between(task, other)

    def kept_out_by(self, task: Task) -> Iterator[tuple[Task, tuple[Refusal, ...]]]:
        """Those of them that may not join `task`, each with all its reasons."""
        for other in self._near(task):
            yield other, tuple(_between(other, task))

    def _near(self, task: Task) -> list[Task]:
        """Those with which there is something, in order; it is so both ways or not at all."""
        near = {*self._names.get(task.name, ()), *self._modules.get(task.module, ())}
        _gather(near, self._outputs, task.outputs)
        _gather(near, self._needed, task.given_while_running)
        _gather(near, self._given, task.needed_at_start)
        return [self._tasks[at] for at in sorted(near)]


def alias_refusals(changed: Task, others: Iterable[Task]) -> tuple[Refusal, ...]:
    """Why the aliases of `changed` may not be taken over beside the `others` of its configuration (reading 9)."""
    twice = tuple(
        Refusal(
            Reason.of("rules.outputs_alike", pins=tuple(names), task=changed.name, svar=svar),
            (Reason.of("rules.alias_anew", pin=names[-1]),),
        )
        for svar, names in _writers(changed).items()
        if len(names) > 1
    )
    return twice + refusals(changed, (task for task in others if task.name != changed.name))


def meets_constant(writer: Task, reader: Task) -> frozenset[str]:
    """O_V(writer) ∩ I_C(reader) of Equation (3): given only while it runs, needed at initialisation."""
    return writer.given_while_running & reader.needed_at_start


def given_while_running(task: Task) -> frozenset[str]:
    """O_V of a task: the variables of its pure OUTVARs."""
    return task.given_while_running


def needed_at_start(task: Task) -> frozenset[str]:
    """I_C of a task: the variables of its pure INCONSTs."""
    return task.needed_at_start


def _note(index: dict[str, list[int]], svars: Iterable[str], at: int) -> None:
    for svar in svars:
        index.setdefault(svar, []).append(at)


def _gather(near: set[int], index: Mapping[str, list[int]], svars: Iterable[str]) -> None:
    for svar in svars:
        if svar in index:
            near.update(index[svar])


def _meet(task: Task, other: Task) -> bool:
    """Whether there is any reason between two tasks."""
    return (
        task.name == other.name
        or task.module == other.module
        or not task.outputs.isdisjoint(other.outputs)
        or not task.given_while_running.isdisjoint(other.needed_at_start)
        or not task.needed_at_start.isdisjoint(other.given_while_running)
    )


def _between(task: Task, other: Task) -> list[Refusal]:
    if task.name == other.name:
        return [_task_placed(task.name)]
    refusals = []
    if task.module == other.module:
        refusals.append(_module_used(task.module, other.name))
    refusals += [_output_written(svar, other.name) for svar in sorted(task.outputs & other.outputs)]
    for writer, reader in ((task, other), (other, task)):
        constants = sorted(meets_constant(writer, reader))
        refusals += [_constant_while_running(svar, writer.name, reader.name, other.name) for svar in constants]
    return refusals


@lru_cache(_KEPT)
def _task_placed(task: str) -> Refusal:
    return Refusal(Reason.of("rules.task_placed", task=task), (_show(task),))


@lru_cache(_KEPT)
def _module_used(module: str, other: str) -> Refusal:
    reason = Reason.of("rules.module_used", module=module, other=other)
    return Refusal(reason, (_replace(other), _show(other)))


@lru_cache(_KEPT)
def _output_written(svar: str, other: str) -> Refusal:
    reason = Reason.of("rules.output_written", svar=svar, other=other)
    return Refusal(reason, (_replace(other), _alias(svar), _show(other)))


@lru_cache(_KEPT)
def _constant_while_running(svar: str, writer: str, reader: str, other: str) -> Refusal:
    reason = Reason.of("rules.constant_while_running", reader=reader, svar=svar, writer=writer)
    return Refusal(reason, (_replace(other), _alias(svar), _show(other)))


@lru_cache(_KEPT)
def _show(task: str) -> Reason:
    return Reason.of("rules.show", task=task)


@lru_cache(_KEPT)
def _replace(task: str) -> Reason:
    return Reason.of("rules.replace", task=task)


@lru_cache(_KEPT)
def _alias(svar: str) -> Reason:
    return Reason.of("rules.alias", svar=svar)


def _writers(task: Task) -> dict[str, list[str]]:
    """The coded names of the outputs behind every variable a task writes."""
    writers: dict[str, list[str]] = {}
    names = tuple(dict.fromkeys(task.outconst + task.outvar))
    for name, svar in zip(names, task.svars(names), strict=True):
        writers.setdefault(svar, []).append(name)
    return writers
