"""A parameter of a LOCAL block: its words against the type and shape that the class declares."""

from typing import Any

from onika.words.shape import Shape


def parse(name: str, shape: Shape, words: tuple[str, ...]) -> Any:
    """A number, a str or a list of them; raises ValueError that says what was expected."""
    kind = shape.type
    if kind.value == "line":
        return " ".join(words)
    is_vector = bool(shape.dims)
    if not is_vector and len(words) != 1:
        raise ValueError(f"LOCAL {name}: expected one {kind.value}, found {len(words)} words")
    fixed = all(isinstance(dim, int) for dim in shape.dims)
    if fixed and len(words) != shape.count:
        raise ValueError(f"LOCAL {name}: expected {shape.count} values, found {len(words)}")
    try:
        if is_vector:
            return [kind.parse(word) for word in words]
        return kind.parse(words[0])
    except ValueError as wrong:
        raise ValueError(f"LOCAL {name}: {wrong}") from None
