"""A plan with other numbers: LOCAL values of its tasks and values of its worlds, as a sweep varies them (X23)."""

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass

from msgspec.structs import replace

from onika.desk.plan.flow_worlds import worlds_by_flow
from onika.wire.plan import Plan, PlannedFlow, PlannedTask
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_FORM = re.compile(r"([A-Za-z]\w*)\.([A-Za-z][\w^]*)(?:\[(\d{1,6})\])?", re.ASCII)
_OPTION = Place("--vary")


@dataclass(frozen=True, slots=True)
class LocalAddress:
    """`TASK.NAME` or `TASK.NAME[ELEMENT]`: one number of a LOCAL line."""

    task: str
    name: str
    element: int | None

    @classmethod
    def parse(cls, text: str) -> "LocalAddress":
        """Read one; raises ValueError that says what was expected."""
        match = _FORM.fullmatch(text.strip())
        if match is None:
            raise ValueError(Reason.of("sweep.address", text=text))
        return cls(match[1], match[2], None if match[3] is None else int(match[3]))

    def __str__(self) -> str:
        return f"{self.task}.{self.name}" + ("" if self.element is None else f"[{self.element}]")


def varied(
    plan: Plan, values: Iterable[tuple[str, float]]
) -> tuple[Plan, dict[str, dict[str, float]], tuple[Fault, ...]]:
    """The plan with these numbers in place of its own, in every flow that has the task; what cannot be is a fault.

    A name that begins with a world means that world; these numbers come second, by world and name.
    """
    faults: list[Fault] = []
    worlds = {world for driven in worlds_by_flow(plan).values() for world in driven}
    of_worlds: dict[str, dict[str, float]] = {}
    for text, value in values:
        try:
            address = LocalAddress.parse(text)
            if address.task in worlds and address.element is None:
                of_worlds.setdefault(address.task, {})[address.name] = value
            else:
                plan = _with_value(plan, address, value, worlds)
        except ValueError as wrong:
            (reason,) = wrong.args
            faults.append(Fault(_OPTION, reason, Reason.of("words.nothing_run")))
    return plan, of_worlds, tuple(faults)


def _with_value(plan: Plan, address: LocalAddress, value: float, worlds: Collection[str]) -> Plan:
    tasks = {task.name: task for flow in plan.flows for task in flow.tasks}
    if address.task not in tasks:
        raise ValueError(Reason.of("sweep.no_task", there=(*sorted(tasks), *sorted(worlds)), task=address.task))
    return replace(plan, flows=tuple(_of_flow(flow, address, value) for flow in plan.flows))


def _of_flow(flow: PlannedFlow, address: LocalAddress, value: float) -> PlannedFlow:
    tasks = (_of_task(task, address, value) if task.name == address.task else task for task in flow.tasks)
    return replace(flow, tasks=tuple(tasks))


def _of_task(task: PlannedTask, address: LocalAddress, value: float) -> PlannedTask:
    names = [name for name, _ in task.local]
    if address.name not in names:
        there = tuple(names) or Reason.of("sweep.none")
        raise ValueError(Reason.of("sweep.no_local", task=task.name, there=there, name=address.name))
    return replace(task, local=tuple(_lines(task, address, value)))


def _lines(task: PlannedTask, address: LocalAddress, value: float) -> Iterator[tuple[str, tuple[str, ...]]]:
    for name, words in task.local:
        if name != address.name:
            yield name, words
            continue
        if address.element is None and len(words) != 1:
            raise ValueError(Reason.of("sweep.which_element", address=str(address), count=len(words)))
        element = address.element or 0
        if element >= len(words):
            raise ValueError(Reason.of("sweep.no_element", address=str(address), count=len(words)))
        if not _is_number(words[element]):
            raise ValueError(Reason.of("sweep.no_number", address=str(address), word=words[element]))
        yield name, (*words[:element], f"{value:.15g}", *words[element + 1 :])


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
