"""The inputs of tasks that take the data of a target, and the units that follow for these (requirements B10, D08)."""

from collections.abc import Iterable, Iterator, Sequence

from onika.model.syntax import DataItem, IconType, Syntax, same_type
from onika.model.task import Task
from onika.wire.sheet import InputSheet, PortSheet

NO_UNIT = ("", "-")


def takes(task: Task, kind: IconType, syntax: Syntax) -> bool:
    """Whether a task's first target is of this type."""
    job = syntax.find(task.object_type) if task.object_type else None
    return job is not None and job.needs_target and same_type(syntax.object_of(job), kind.name)


def paired(items: Sequence[DataItem], inputs: Sequence[InputSheet]) -> Iterator[tuple[DataItem, InputSheet]]:
    """Each datum with the input that takes it: in order, as long as they are of one type, as an argument line is."""
    for item, taken in zip(items, inputs, strict=False):
        if taken.shape.partition("[")[0].strip() != item.type.value:
            return
        yield item, taken


def measured_kinds(
    syntax: Syntax | None, inputs: Sequence[tuple[Task, Sequence[InputSheet]]]
) -> list[tuple[IconType, dict[str, str]]]:
    """The types of targets that have data, each with the units of these, by name, as tasks say them that take it."""
    kinds = syntax.types if syntax else ()
    return [(kind, _units(kind, syntax, inputs)) for kind in kinds if syntax and kind.is_target and kind.items]


def unit_of_variable(name: str, ports: Iterable[tuple[Task, Sequence[PortSheet]]]) -> str:
    """The unit that these tasks give a state variable; empty where none does or they disagree."""
    units = {
        port.unit
        for task, sheets in ports
        for port in sheets
        if dict(task.aliases).get(port.name, port.name) == name and port.unit not in NO_UNIT
    }
    return units.pop() if len(units) == 1 else ""


def _units(kind: IconType, syntax: Syntax, inputs: Iterable[tuple[Task, Sequence[InputSheet]]]) -> dict[str, str]:
    """The first that is said of each; unknown ones lack."""
    units: dict[str, str] = {}
    for task, sheets in inputs:
        if takes(task, kind, syntax):
            for item, sheet in paired(kind.items, sheets):
                if sheet.unit not in NO_UNIT:
                    units.setdefault(item.name, sheet.unit)
    return units
