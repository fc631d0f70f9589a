"""The answer of an outside partner: every field is checked before it is used (F04)."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from onika.runtime.error import ModuleError
from onika.words.reason import Reason

if TYPE_CHECKING:
    from numpy.typing import NDArray

_SHOWN = 60  # characters of a wrong value in a message


class PartnerAnswer:
    """The fields of one answer. Each way to read one raises ModuleError that says what was expected and found."""

    def __init__(self, fields: Mapping[str, Any]) -> None:
        self.fields = fields
        """As they came: of any type and any size up to a line's, and not to be trusted."""

    def numbers(
        self, name: str, shape: tuple[int | None, ...] = (), low: Any = -math.inf, high: Any = math.inf
    ) -> "NDArray[np.float64]":
        """Finite real numbers of this shape (None: any count) within the bounds, which may be vectors too."""
        value = self._field(name)
        array = _array(value, shape)
        if array is None:
            raise ModuleError(_no_numbers(name, shape, value))
        if ((array < low) | (array > high)).any():
            bounds = {"low": str(low), "high": str(high)}
            raise ModuleError(Reason.of("runtime.answer_outside", name=name, value=_short(value), **bounds))
        return array

    def number(self, name: str, low: float = -math.inf, high: float = math.inf) -> float:
        """One finite real number within the bounds."""
        return float(self.numbers(name, (), low, high))

    def text(self, name: str, longest: int = 255) -> str:
        """A text of at most so many characters."""
        value = self._field(name)
        if not isinstance(value, str) or len(value) > longest:
            raise ModuleError(Reason.of("runtime.answer_text", name=name, longest=longest, value=_short(value)))
        return value

    def _field(self, name: str) -> Any:
        if name not in self.fields:
            names = tuple(map(_short, self.fields)) or Reason.of("runtime.nothing")
            raise ModuleError(Reason.of("runtime.answer_field", name=name, names=names))
        return self.fields[name]


def _no_numbers(name: str, shape: tuple[int | None, ...], value: Any) -> Reason:
    if not shape:
        return Reason.of("runtime.answer_number", name=name, value=_short(value))
    counts = "×".join("n" if count is None else str(count) for count in shape)
    return Reason.of("runtime.answer_numbers", name=name, counts=counts, value=_short(value))


def _array(value: Any, shape: tuple[int | None, ...]) -> "NDArray[np.float64] | None":
    """An array of this shape; None where the value is none, or not of finite numbers."""
    if not _is_plain(value, len(shape)):
        return None
    try:
        array = np.array(value, dtype=np.float64)
    except (ValueError, TypeError, OverflowError):
        return None
    if array.size == 0 and None in shape:
        array = array.reshape([count or 0 for count in shape])
    return array if _has_shape(array, shape) and np.isfinite(array).all() else None


def _has_shape(array: "NDArray[np.float64]", shape: tuple[int | None, ...]) -> bool:
    if array.ndim != len(shape):
        return False
    return all(wanted in (None, count) for count, wanted in zip(array.shape, shape, strict=True))


def _is_plain(value: Any, depth: int) -> bool:
    """Whether it is numbers in lists so deep: NumPy alone would take texts and truth values for numbers."""
    if depth == 0:
        return type(value) in (int, float)
    return isinstance(value, list) and all(_is_plain(item, depth - 1) for item in value)


def _short(value: Any) -> str:
    text = str(value)
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "…"
