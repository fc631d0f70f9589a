"""Values of state variables as they stand in a recording: JSON with one key, `value`, a matrix row by row.

Viewers know no lists of lists, so that a matrix is flat there; its shape is told beside it. JSON knows no infinity:
it stands as a number beyond every double, and what is no number as null.
"""

import base64
import json
import math
from collections.abc import Callable
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
    one: dict[str, Any]
    if is_picture(shape):
        one = {"type": "string", "contentEncoding": "base64"}
    else:
        kind = "number" if shape.type.is_real else "integer" if shape.type.is_whole else "string"
        one = {"type": "array", "items": {"type": kind}} if shape.dims else {"type": kind}
    one["description"] = f"{shape}, row by row" if len(shape.dims) > 1 else str(shape)
    if unit:
        one["description"] += f" [{unit}]"
    return _encode({"type": "object", "properties": {"value": one}, "required": ["value"]})


def title(shape: Shape, unit: str = "") -> str:
    """What that schema is called."""
    return f"onika.{shape}" + (f" {unit}" if unit else "")


def encoder(shape: Shape) -> Callable[[bytes], bytes]:
    """A function from the bytes of a variable to what stands in the recording."""
    if is_picture(shape):
        return lambda data: b'{"value":"' + base64.b64encode(data) + b'"}'
    if not (shape.type.is_real or shape.type.is_whole):
        kind, is_vector = shape.type, bool(shape.dims)
        return lambda data: _encode({"value": letters.decode(data, kind, is_vector)})
    code, is_real = shape.type.code, shape.type.is_real
    is_scalar = not shape.dims

    def encode(data: bytes) -> bytes:
        numbers = memoryview(data).cast(code).tolist()  # type: ignore[call-overload]
        body = _encode(numbers[0] if is_scalar else numbers)
        if is_real and b"null" in body:
            body = _with_infinities(numbers, is_scalar)
        return b'{"value":' + body + b"}"

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
        value = [_real(one) for one in value] if shape.dims else _real(value)
    for size in reversed(shape.dims[1:]):
        value = [value[i : i + int(size)] for i in range(0, len(value), int(size))]
    return value


def flat(body: bytes, shape: Shape) -> list[Any]:
    """The same as the list of its elements, row by row."""
    found = decode(body, Shape(shape.type, (shape.count,)) if shape.dims else shape)
    return found if isinstance(found, list) else [found]


def _real(value: float | None) -> float:
    return math.nan if value is None else float(value)


def _with_infinities(numbers: list[float], is_scalar: bool) -> bytes:
    texts = [
        repr(one) if math.isfinite(one) else "null" if math.isnan(one) else "1e999" if one > 0 else "-1e999"
        for one in numbers
    ]
    return (texts[0] if is_scalar else f"[{','.join(texts)}]").encode()
