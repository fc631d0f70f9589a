"""The nine types of values that tasks, targets and user input are made of (dissertation §C.4)."""

import math
import re
import struct
from enum import Enum

from onika.words.reason import Reason

Value = int | float | str
"""One element: whole numbers as int, real numbers as float, texts and characters as str."""

TEXT_CAPACITY = 256
"""Bytes of UTF-8 that a state variable of type string or line holds, unless said otherwise."""


class ValueType(Enum):
    """A type by its name in files; see `parse`, `show` and `fits`."""

    STRING = "string"
    LINE = "line"
    CHAR = "char"
    BYTE = "byte"
    FLOAT = "float"
    DOUBLE = "double"
    LONG = "long"
    INT = "int"
    SHORT = "short"

    @property
    def is_text(self) -> bool:
        """Text of any length: string (one word) or line."""
        return self in (ValueType.STRING, ValueType.LINE)

    @property
    def is_real(self) -> bool:
        """A real number: float or double."""
        return self in (ValueType.FLOAT, ValueType.DOUBLE)

    @property
    def is_whole(self) -> bool:
        """A whole number: byte, short, int or long."""
        return self in _WHOLE

    @property
    def code(self) -> str:
        """The format character of one element in memory, as `struct`, `memoryview` and NumPy write it."""
        return _CODES[self]

    @property
    def size(self) -> int:
        """Bytes of one element in memory."""
        if self.is_text:
            return TEXT_CAPACITY
        return struct.calcsize("=" + self.code)

    @property
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest number of this type (texts: minus and plus infinity)."""
        return _WHOLE.get(self, (-math.inf, math.inf))

    def parse(self, text: str) -> Value:
        """Read one element; raises ValueError whose text says what was expected."""
        if self.is_text:
            return text
        if self is ValueType.CHAR:
            if len(text) != 1 or ord(text) > 255:
                raise ValueError(Reason.of("words.one_character", text=text))
            return text
        if self.is_real:
            return _real(text, self)
        return _whole(text, self)

    def show(self, value: Value) -> str:
        """Write one element so that `parse` reads the same value again."""
        return repr(float(value)) if self.is_real else str(value)

    def fits(self, value: Value) -> bool:
        """Whether the value is of this type and within its range (real numbers: finite)."""
        if self.is_text:
            return isinstance(value, str)
        if self is ValueType.CHAR:
            return isinstance(value, str) and len(value) == 1 and ord(value) < 256
        if self.is_real:
            return isinstance(value, int | float) and math.isfinite(value)
        low, high = self.bounds
        return isinstance(value, int) and low <= value <= high


_WHOLE = {
    ValueType.BYTE: (0, 255),
    ValueType.SHORT: (-(2**15), 2**15 - 1),
    ValueType.INT: (-(2**31), 2**31 - 1),
    ValueType.LONG: (-(2**63), 2**63 - 1),
}

_CODES = {
    ValueType.STRING: "B",
    ValueType.LINE: "B",
    ValueType.CHAR: "B",
    ValueType.BYTE: "B",
    ValueType.FLOAT: "f",
    ValueType.DOUBLE: "d",
    ValueType.LONG: "q",
    ValueType.INT: "i",
    ValueType.SHORT: "h",
}


_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z|[+-]?(inf|infinity|nan)\Z", re.ASCII | re.IGNORECASE)
_DIGITS = re.compile(r"[+-]?\d+\Z", re.ASCII)


def _real(text: str, kind: ValueType) -> float:
    if not _NUMBER.match(text):
        raise ValueError(Reason.of("words.number_expected", value=kind.value, text=text))
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(Reason.of("words.finite_number", value=kind.value, text=text))
    return value


def _whole(text: str, kind: ValueType) -> int:
    if not _DIGITS.match(text):
        raise ValueError(Reason.of("words.whole_number", value=kind.value, text=text))
    value = int(text)
    low, high = _WHOLE[kind]
    if not low <= value <= high:
        raise ValueError(Reason.of("words.number_bounds", value=kind.value, low=low, high=high, text=text))
    return value
