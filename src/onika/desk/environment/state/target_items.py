"""The data of a type of target, with the units and bounds of the tasks that take it (requirements D08, B10)."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, NamedTuple

from msgspec import structs

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.plan.declarations import declared_inputs, declared_ports
from onika.desk.plan.target_inputs import paired, takes
from onika.model import pose_numbers
from onika.model.port import PortKind
from onika.model.syntax import DataItem, IconType, Syntax
from onika.model.task import Task
from onika.wire.sheet import InputSheet, PortSheet
from onika.wire.view import ItemView

Limits = Mapping[str, tuple[float, ...]]
"""Constants that bound inputs, as far as a runtime has told them, by the names of their variables."""


class InputUse(NamedTuple):
    """An input of a task that takes a datum of a target."""

    task: Task
    input: InputSheet

    def variable(self, name: str) -> str:
        """The state variable behind a coded name of the task."""
        return dict(self.task.aliases).get(name, name)


def items_of(model: Model, type_: str) -> tuple[ItemView, ...]:
    """The data of a type of target, in order; none for another type. Units and bounds where a task is known."""
    kind = model.syntax.find(type_) if model.syntax else None
    if kind is None or model.syntax is None:
        return ()
    uses = uses_of(model.libraries, model.syntax, kind)
    views = (_view(item, uses.get(item.name, ()), model.limits) for item in kind.items)
    return tuple(structs.replace(view, place=_place(view, uses.get(view.name, ()), model.libraries)) for view in views)


def uses_of(libraries: OpenLibraries, syntax: Syntax, kind: IconType) -> dict[str, tuple[InputUse, ...]]:
    """The inputs of tasks that take the data of a type of target, by the names of these."""
    uses_by_type: dict[str, tuple[InputUse, ...]] = {}
    for task in libraries.tasks.values() if kind.is_target else ():
        if takes(task, kind, syntax):
            for item, taken in paired(kind.items, inputs_of(libraries, task)):
                uses_by_type[item.name] = (*uses_by_type.get(item.name, ()), InputUse(task, taken))
    return uses_by_type


def inputs_of(libraries: OpenLibraries, task: Task) -> tuple[InputSheet, ...]:
    """What a task takes, as a runtime says, else as its code does."""
    sheet = libraries.sheets.get(task.module)
    if sheet is not None:
        return sheet.inputs
    code = libraries.code_file(task.name)
    return declared_inputs(code) if code else ()


def ports_of(libraries: OpenLibraries, task: Task) -> tuple[PortSheet, ...]:
    """The ports of a task's module, as a runtime says, else as its code does."""
    sheet = libraries.sheets.get(task.module)
    if sheet is not None:
        return sheet.ports
    code = libraries.code_file(task.name)
    return declared_ports(code) if code else ()


def _view(item: DataItem, uses: Sequence[InputUse], limits: Limits) -> ItemView:
    units = [use.input.unit for use in uses if use.input.unit not in ("", "-")]
    meanings = Counter(use.input.meaning for use in uses if use.input.meaning)
    defaults = [use.input.default for use in uses if use.input.default is not None]
    return ItemView(
        name=item.name,
        type=item.type.value,
        count=item.count,
        unit=units[0] if units else "",
        meaning=max(meanings, key=lambda meaning: meanings[meaning], default=""),  # the one that most tasks give it
        low=_widest([_bound(use, use.input.low, item.count, limits) for use in uses], min),
        high=_widest([_bound(use, use.input.high, item.count, limits) for use in uses], max),
        default=_spread(defaults[0], item.count) if defaults else None,
        dimension=item.dimension,
        each=item.each,
    )


def _place(item: ItemView, uses: Sequence[InputUse], libraries: OpenLibraries) -> Literal["", "pose", "joints"]:
    """Whether it says where an arm goes: the angles of its joints, or a frame, which its task also measures."""
    if item.dimension and item.each == 1 and item.unit == "rad":
        return "joints"
    if item.count == pose_numbers.COUNT and any(_measures_frame(use, libraries) for use in uses):
        return "pose"
    return ""


def _measures_frame(use: InputUse, libraries: OpenLibraries) -> bool:
    return any(
        port.shape == pose_numbers.SHAPE and PortKind(port.kind).is_input for port in ports_of(libraries, use.task)
    )


def _bound(use: InputUse, bound: float | str | None, count: int, limits: Limits) -> tuple[float, ...] | None:
    value: Any = limits.get(use.variable(bound)) if isinstance(bound, str) else bound
    spread = None if value is None else _spread(value, count)
    if spread is None:
        return None
    return tuple(map(float, spread))


def _widest(bounds: Sequence[tuple[float, ...] | None], choose: Any) -> tuple[float, ...] | None:
    """What some task would take; none where one takes anything, or nothing is known."""
    stated = [bound for bound in bounds if bound is not None]
    if not stated or len(stated) < len(bounds):
        return None
    return tuple(choose(each) for each in zip(*stated, strict=True))


def _spread(value: Any, count: int) -> tuple[Any, ...] | None:
    """One value for each element; None where there are others than that."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        return (value,) * count
    values = tuple(value)
    if len(values) == count:
        return values
    if len(values) == 1:
        return values * count
    return None
