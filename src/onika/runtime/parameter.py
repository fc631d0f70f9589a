"""A parameter of a LOCAL block: its words against the type and shape that the class declares."""

from typing import Any

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
