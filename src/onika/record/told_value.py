"""A value as a runtime tells it over a link, put into the words of recordings; its shape is found by itself (X05)."""

from collections.abc import Iterator
from typing import Any

import msgspec

from onika.record.value import number_text
from onika.words.shape import Shape
from onika.words.value import ValueType

_encode = msgspec.json.Encoder().encode


def shape_of(value: Any) -> Shape | None:
    """The shape of a number, of a text, or of rows of them; None: it is nothing that is told so, such as a picture."""
    dims = []
    first = value
    while isinstance(first, list | tuple):
        if not first:
            return None
        dims.append(str(len(first)))
        first = first[0]
    kind = _kind(value, first)
    if kind is None:
        return None
    return Shape(kind, tuple(dims))


def encoded(value: Any, shape: Shape) -> bytes:
    """What stands in the recording; a matrix row by row."""
    elements = list(_elements(value))
    if shape.type.is_real:
        texts = [number_text(float(element)).encode() for element in elements]
    else:
        texts = [_encode(element) for element in elements]
    inner = b",".join(texts)
    if shape.dims:
        inner = b"[" + inner + b"]"
    return b'{"value":' + inner + b"}"


def _kind(value: Any, first: Any) -> ValueType | None:
    if isinstance(first, str):
        return ValueType.STRING
    if isinstance(first, bool) or not isinstance(first, int | float):
        return None
    if any(isinstance(element, float) for element in _elements(value)):
        return ValueType.DOUBLE
    return ValueType.LONG


def _elements(value: Any) -> Iterator[Any]:
    if isinstance(value, list | tuple):
        for part in value:
            yield from _elements(part)
    else:
        yield value
