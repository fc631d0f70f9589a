"""Which variables say of the robot what a target says of a place: those that its task itself goes by (D13)."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import ports_of, uses_of
from onika.model import pose_numbers
from onika.model.port import PortKind
from onika.model.syntax import IconType
from onika.wire.sheet import InputSheet, PortSheet
from onika.words.reason import Reason
from onika.words.value import ValueType


@dataclass(frozen=True, slots=True)
class MeasuredVariable:
    """A datum of a target and a variable that would give it."""

    item: str
    count: int
    type: ValueType
    variable: str
    is_frame: bool = False
    """Whether the variable is a frame and the datum its nine numbers."""
    dimension: str = ""
    """The constant that says how many values there are; empty: it is `count`."""


def measures_of(model: Model, kind: IconType) -> tuple[MeasuredVariable, ...]:
    """What could be read for the data of a type of target, each once; what nothing measures has none."""
    measures: dict[MeasuredVariable, None] = {}
    if model.syntax is None:
        return ()
    uses = uses_of(model.libraries, model.syntax, kind)
    for item in kind.items:
        for use in uses.get(item.name, ()):
            for port in _like(use.input, ports_of(model.libraries, use.task)):
                is_frame = port.shape != use.input.shape
                measures[
                    MeasuredVariable(
                        item.name, item.count, item.type, use.variable(port.name), is_frame, item.dimension
                    )
                ] = None
    return tuple(measures)


def values_of(measure: MeasuredVariable, value: Any) -> tuple[float, ...] | Reason:
    """The values of a variable as those of a datum; else why they are none."""
    if measure.is_frame:
        return pose_numbers.nine_of(value)
    numbers = tuple(_flat(value))
    if len(numbers) != measure.count and not (measure.dimension and numbers):
        return Reason.of(
            "desk.values_unfit", variable=measure.variable, given=len(numbers), item=measure.item, count=measure.count
        )
    if measure.type.is_whole:
        return tuple(round(number) for number in numbers)
    return numbers


def _like(wanted: InputSheet, ports: Iterable[PortSheet]) -> Iterator[PortSheet]:
    """The variables that a task reads while it runs and that say what it takes: of its shape and unit, or a frame."""
    if wanted.shape.startswith(("string", "line", "char")):
        return
    is_told = "[" in wanted.shape or wanted.unit not in ("", "-")  # a bare number may be anything
    for port in ports:
        kind = PortKind(port.kind)
        is_alike = is_told and (port.shape, port.unit) == (wanted.shape, wanted.unit)
        is_frame = (wanted.shape, port.shape) == (f"double[{pose_numbers.COUNT}]", pose_numbers.SHAPE)
        if kind.is_input and kind.at_cycle and (is_alike or is_frame):
            yield port


def _flat(value: object) -> list[float]:
    if isinstance(value, list):
        return [number for part in value for number in _flat(part)]
    return [float(str(value))]
