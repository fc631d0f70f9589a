"""Values of state variables in a recording: JSON with one key, `value`, a matrix row by row.

Viewers know no lists of lists, so that a matrix is flat there; its shape is told beside it. JSON knows no infinity:
it stands as a number beyond every double, and what is no number as null.
"""

import base64
import json
import math
from collections.abc import Callable, Sequence
from typing import Any

import msgspec

from onika.words import letters
from onika.words.shape import Shape
from onika.words.value import ValueType

_PICTURE = 64
"""Vectors of more bytes are pictures: they stand as base64."""
_encode = msgspec.json.Encoder().encode


def is_picture(shape: Shape) -> bool:
    """Whether it stands as base64."""
    return shape.type is ValueType.BYTE and shape.count > _PICTURE


def schema(shape: Shape, unit: str = "") -> bytes:
    """The JSON schema of a variable."""
    field: dict[str, Any]
    if is_picture(shape):
        field = {"type": "string", "contentEncoding": "base64"}
    else:
        field = {"type": _kind(shape.type)}
        if shape.dims:
            field = {"type": "array", "items": field}
    field["description"] = f"{shape}, row by row" if len(shape.dims) > 1 else str(shape)
    if unit:
        field["description"] += f" [{unit}]"
    return _encode({"type": "object", "properties": {"value": field}, "required": ["value"]})


def _kind(type_: ValueType) -> str:
    """The JSON schema's word for one element."""
    if type_.is_real:
        return "number"
    return "integer" if type_.is_whole else "string"


def title(shape: Shape, unit: str = "") -> str:
    """What that schema is called."""
    return f"onika.{shape}" + (f" {unit}" if unit else "")


def encoder(shape: Shape) -> Callable[[Sequence[bytes]], list[bytes]]:
    """A function from values of a variable, in bytes, to what stands in the recording; many at once cost much less."""
    if is_picture(shape):
        return lambda values: [b'{"value":"' + base64.b64encode(data) + b'"}' for data in values]
    if not (shape.type.is_real or shape.type.is_whole):
        kind, is_vector = shape.type, bool(shape.dims)
        return lambda values: [_encode({"value": letters.decode(data, kind, is_vector)}) for data in values]
    code, is_real, width = shape.type.code, shape.type.is_real, shape.count
    first, last = b'{"value":', b"}"
    if shape.dims:
        first, last = b'{"value":[', b"]}"

    def encode(values: Sequence[bytes]) -> list[bytes]:
        flat = memoryview(b"".join(values))
        rows = flat.cast(code, (len(values), width)).tolist()  # type: ignore[call-overload]  # any code, not a literal
        text = _encode(rows)[2:-2]
        texts = text.split(b"],[")
        if is_real and b"null" in text:  # what is no number, or without end
            for place, row in enumerate(rows):
                if b"null" in texts[place]:
                    texts[place] = _with_infinities(row)
        return [first + row_text + last for row_text in texts]

    return encode


def decode(body: bytes, shape: Shape) -> Any:
    """The value as plain data: a number, a text, or lists as deep as the shape; what is no number is nan."""
    try:
        value = msgspec.json.decode(body)["value"]
    except msgspec.DecodeError:  # a number beyond every double
        value = json.loads(body)["value"]
    if is_picture(shape):
        value = list(base64.b64decode(value))
    if shape.type.is_real:
        value = [_real(number) for number in value] if shape.dims else _real(value)
    for size in reversed(shape.dims[1:]):
        value = [value[i : i + int(size)] for i in range(0, len(value), int(size))]
    return value


def flat(body: bytes, shape: Shape) -> list[Any]:
    """The same as the list of its elements, row by row."""
    if not shape.dims:
        return [decode(body, shape)]
    elements: list[Any] = decode(body, Shape(shape.type, (shape.count,)))
    return elements


def _real(value: float | None) -> float:
    return math.nan if value is None else float(value)


def _with_infinities(numbers: list[float]) -> bytes:
    return ",".join(map(number_text, numbers)).encode()


def number_text(number: float) -> str:
    """A number of JSON: what has no end stands beyond every double, what is no number as null."""
    if math.isfinite(number):
        return repr(number)
    if math.isnan(number):
        return "null"
    return "1e999" if number > 0 else "-1e999"
