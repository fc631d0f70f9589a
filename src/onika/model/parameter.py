"""A parameter of a LOCAL block: its words against what the class of the module declares of it."""

from math import inf, isfinite
from typing import Any

from onika.wire.sheet import LocalSheet
from onika.words.reason import Reason, reason_of
from onika.words.shape import Shape


def parse(name: str, shape: Shape, words: tuple[str, ...]) -> Any:
    """A number, a str or a list of them; raises ValueError that says what was expected."""
    kind = shape.type
    if kind.value == "line":
        return " ".join(words)
    is_vector = bool(shape.dims)
    if not is_vector and len(words) != 1:
        raise ValueError(Reason.of("runtime.local_one", name=name, kind=kind.value, count=len(words)))
    fixed = all(isinstance(dim, int) for dim in shape.dims)
    if fixed and len(words) != shape.count:
        raise ValueError(Reason.of("runtime.local_count", name=name, expected=shape.count, count=len(words)))
    try:
        if is_vector:
            return [kind.parse(word) for word in words]
        return kind.parse(words[0])
    except ValueError as wrong:
        raise ValueError(Reason.of("runtime.local_wrong", name=name, why=reason_of(wrong))) from None


def check(local: LocalSheet, words: tuple[str, ...]) -> Any:
    """The value of these words where the parameter may have it; raises ValueError, also beyond its bounds."""
    value = parse(local.name, Shape.parse(local.shape), words)
    low, high = -inf if local.low is None else local.low, inf if local.high is None else local.high
    for number in value if isinstance(value, list) else [value]:
        if not isinstance(number, str) and not low <= number <= high:
            figures = {"low": _bound(low), "high": _bound(high), "number": float(f"{number:.12g}")}
            raise ValueError(Reason.of("runtime.local_outside", name=local.name, unit=local.unit, **figures))
    return value


def _bound(bound: float) -> float | str:
    """A bound as it is said; where there is none, as Python writes it, which no message carries as a number."""
    return float(f"{bound:g}") if isfinite(bound) else str(bound)


def default_words(local: LocalSheet) -> tuple[str, ...]:
    """The words that the default of a parameter would have in a file; none where it has no default."""
    if local.default is None:
        return ()
    if isinstance(local.default, list | tuple):
        return tuple(str(element) for element in local.default)
    return tuple(str(local.default).split())
