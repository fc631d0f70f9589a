"""Which data of a target the present value of a state variable can be (requirement C30).

Of the type's data one takes it: where kind, number and, as far as both are known, units agree. A frame of four rows
gives the nine numbers of a pose (reading 44).
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from onika.model import pose_numbers
from onika.model.syntax import DataItem, IconType
from onika.words.reason import Reason
from onika.words.shape import Shape
from onika.words.value import Value, ValueType

_NO_UNIT = ("", "-")
_FRAME = (4, 4)
_FRAME_END = [0.0, 0.0, 0.0, 1.0]
_STAGES = ("rules.fit_kind", "rules.fit_count", "rules.fit_unit", "rules.fit_frame", "rules.fit_value")
"""What is looked at, in order: what fails late comes near."""


@dataclass(frozen=True, slots=True)
class VariableValue:
    """A state variable with what it holds now; `shape` has its dimensions as numbers, as in `double[6]`."""

    name: str
    shape: str
    value: Any
    unit: str = ""

    @property
    def described(self) -> str:
        """Its shape and unit in one word or two."""
        return self.shape if self.unit in _NO_UNIT else f"{self.shape} {self.unit}"


@dataclass(frozen=True, slots=True)
class TargetFit:
    """A type of target and that datum of it whose values a variable gives."""

    type: str
    item: str
    values: tuple[Value, ...]


def fits_in(kind: IconType, variable: VariableValue, units: Mapping[str, str]) -> tuple[TargetFit, ...]:
    """The data of a type that the variable gives; `units` are those of the data, by name, as far as they are known."""
    fits = []
    for item in kind.items:
        values = values_for(item, variable, units.get(item.name, ""))
        if not isinstance(values, Reason):
            fits.append(TargetFit(kind.name, item.name, values))
    return tuple(fits)


def reasons_against(
    kinds: Iterable[tuple[IconType, Mapping[str, str]]], variable: VariableValue
) -> tuple[tuple[IconType, Reason], ...]:
    """Why these types, each with the units of its data, do not take the variable: of those that come nearest."""
    reasons = [
        (kind, reason)
        for kind, units in kinds
        for item in kind.items
        if isinstance(reason := values_for(item, variable, units.get(item.name, "")), Reason)
    ]
    nearest = max((_STAGES.index(reason.key) for _, reason in reasons), default=0)
    return tuple((kind, reason) for kind, reason in reasons if _STAGES.index(reason.key) == nearest)


def values_for(item: DataItem, variable: VariableValue, unit: str = "") -> tuple[Value, ...] | Reason:
    """The values of a datum that a variable gives, else why it gives none."""
    shape = Shape.parse(variable.shape)
    if not _is_of_kind(item.type, shape.type):
        return Reason.of("rules.fit_kind", item=item.name, kind=item.type.value, given=str(shape))
    is_frame = shape.dims == _FRAME and item.count == pose_numbers.COUNT
    if not is_frame and not _takes(item, shape):
        return Reason.of("rules.fit_count", item=item.name, count=item.count, given=str(shape))
    if unit not in _NO_UNIT and variable.unit not in _NO_UNIT and unit != variable.unit:
        return Reason.of("rules.fit_unit", item=item.name, unit=unit, given=variable.unit)
    if is_frame and variable.value[-1] != _FRAME_END:
        return Reason.of("rules.fit_frame", item=item.name)
    values = pose_numbers.nine_of(variable.value) if is_frame else _flat(variable.value)
    return _of_item(item, values)


def _is_of_kind(wanted: ValueType, given: ValueType) -> bool:
    """Whether elements of one kind say without loss of meaning what elements of another do."""
    if wanted.is_text:
        return given.is_text
    if wanted.is_real:
        return given.is_real or given.is_whole
    if wanted.is_whole:
        return given.is_whole
    return wanted is given


def _takes(item: DataItem, shape: Shape) -> bool:
    """Whether there are as many as there can be; a single number is no vector, whatever its length.

    Where several belong to each joint, so few as belong to one are taken for one number of each joint.
    """
    if len(shape.dims) > 1 or (item.dimension and not shape.dims) or 1 < item.each == shape.count:
        return False
    return item.takes(shape.count)


def _of_item(item: DataItem, values: Sequence[Any]) -> tuple[Value, ...] | Reason:
    """The values as the datum has them; one that is out of its range is told."""
    wrong = next((value for value in values if not item.type.fits(value)), None)
    if wrong is not None:
        return Reason.of("rules.fit_value", item=item.name, kind=item.type.value, value=str(wrong))
    return tuple(float(value) if item.type.is_real else value for value in values)


def _flat(value: Any) -> list[Any]:
    if isinstance(value, list):
        return [element for part in value for element in _flat(part)]
    return [value]
