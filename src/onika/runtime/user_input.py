"""User input: a task's argument line against what its class declares, or a request to the user (requirement A10)."""

from collections.abc import Iterable, Mapping
from contextlib import suppress
from types import SimpleNamespace
from typing import Any

import numpy as np
from msgspec import Struct

from onika.wire.sheet import InputSheet
from onika.words import argument
from onika.words.reason import Reason, reason_of
from onika.words.shape import Shape
from onika.words.value import Value, ValueType


class AskedItem(Struct, frozen=True):
    """One value, or vector of values, that the user is asked for; bounds are one number for each element."""

    name: str
    type: str
    count: int
    unit: str
    meaning: str
    default: tuple[Value, ...] | None
    low: tuple[float, ...] | None
    high: tuple[float, ...] | None


class UserInput:
    """The input of one task, its shapes and bounds resolved by the task's constants."""

    def __init__(self, sheets: tuple[InputSheet, ...], constants: Mapping[str, Any]) -> None:
        self.items = tuple(_item(sheet, constants) for sheet in sheets)
        self._scalar = {sheet.name: not Shape.parse(sheet.shape).dims for sheet in sheets}
        self._foreseen: dict[str, SimpleNamespace] = {}

    def takes(self, line: str) -> bool:
        """Whether a line has as many words as there are values; raises ValueError for one that is no line of words."""
        return len(argument.split(line)) == sum(item.count for item in self.items)

    def foresee(self, lines: Iterable[str]) -> None:
        """These may come next, and no others are expected any more: read them now, as far as they can be read."""
        self._foreseen = {}
        for line in lines:
            with suppress(ValueError):  # said when the line comes
                self._foreseen[line] = self._read(line)

    def parse(self, line: str) -> SimpleNamespace:
        """The values of an argument line by their names; raises ValueError that says all that is wrong with it."""
        return self._foreseen.pop(line, None) or self._read(line)  # handed out once: a module may change what it gets

    def _read(self, line: str) -> SimpleNamespace:
        try:
            words = argument.split(line)
        except ValueError as wrong:
            raise ValueError(reason_of(wrong)) from None
        expected = sum(item.count for item in self.items)
        if len(words) != expected:
            names = tuple(f"{item.name}[{item.count}]" for item in self.items)
            raise ValueError(Reason.of("runtime.input_count", expected=expected, names=names, count=len(words)))
        values, wrong_ones = SimpleNamespace(), []
        for item in self.items:
            try:
                parsed = _parse(item, words[: item.count])
                setattr(values, item.name, parsed[0] if self._scalar[item.name] else _vector(item, parsed))
            except ValueError as wrong:
                wrong_ones.append(reason_of(wrong))
            words = words[item.count :]
        if wrong_ones:
            raise ValueError(Reason.of("runtime.several", reasons=tuple(wrong_ones)))
        return values


def _item(sheet: InputSheet, constants: Mapping[str, Any]) -> AskedItem:
    shape = Shape.parse(sheet.shape).resolve(constants)
    default = None if sheet.default is None else _spread(sheet.name, sheet.default, shape.count)
    low, high = (_bound(sheet.name, bound, constants, shape.count) for bound in (sheet.low, sheet.high))
    return AskedItem(sheet.name, shape.type.value, shape.count, sheet.unit, sheet.meaning, default, low, high)


def _bound(name: str, bound: float | str | None, constants: Mapping[str, Any], count: int) -> tuple[float, ...] | None:
    if bound is None:
        return None
    value = constants[bound] if isinstance(bound, str) else bound
    return tuple(float(number) for number in _spread(name, value, count))


def _spread(name: str, value: Any, count: int) -> tuple[Any, ...]:
    """One value for each element: a single one for all, or as many as there are."""
    if isinstance(value, str) or np.ndim(value) == 0:
        return (value,) * count
    values = tuple(np.asarray(value).ravel().tolist())
    if len(values) != count:
        raise ValueError(Reason.of("runtime.input_bounds", name=name, expected=count, count=len(values)))
    return values


def _parse(item: AskedItem, words: list[str]) -> list[Value]:
    kind = ValueType(item.type)
    values = []
    for index, word in enumerate(words):
        where = item.name if item.count == 1 else f"{item.name}[{index}]"
        try:
            value = kind.parse(word)
        except ValueError as wrong:
            raise ValueError(Reason.of("runtime.input_wrong", where=where, why=reason_of(wrong))) from None
        _within(where, value, item, index)
        values.append(value)
    return values


def _within(where: str, value: Value, item: AskedItem, index: int) -> None:
    if isinstance(value, str):
        return
    low = -np.inf if item.low is None else item.low[index]
    high = np.inf if item.high is None else item.high[index]
    if not low <= value <= high:
        shown = float(value if f"{value:g}" in (f"{low:g}", f"{high:g}") else f"{value:g}")
        raise ValueError(
            Reason.of(
                "runtime.input_outside", where=where, low=float(low), high=float(high), unit=item.unit, value=shown
            )
        )


def _vector(item: AskedItem, values: list[Value]) -> Any:
    kind = ValueType(item.type)
    if kind.is_text or kind.value == "char":
        return values
    return np.array(values, dtype=kind.code)
