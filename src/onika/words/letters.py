"""Texts and characters as they lie in memory: a text as UTF-8 filled up with zeros, a character as one byte (law 7)."""

from collections.abc import Iterable

from onika.words.reason import Reason
from onika.words.value import ValueType


def decode(data: bytes, kind: ValueType, is_vector: bool) -> str | list[str]:
    """The text or character in `data`, or the list of them; bytes that are no UTF-8 are replaced."""
    values = [_decode(data[start : start + kind.size], kind) for start in range(0, len(data), kind.size)]
    return values if is_vector else values[0]


def encode(value: str | Iterable[str], kind: ValueType, size: int) -> bytes:
    """A text or character, or several, as `size` bytes; raises ValueError where they do not fit."""
    values = [value] if isinstance(value, str) and kind.is_text else list(value)
    if len(values) * kind.size != size:
        raise ValueError(Reason.of("words.text_count", size=size // kind.size, value=kind.value, count=len(values)))
    return b"".join(_encode(value, kind) for value in values)


def _decode(data: bytes, kind: ValueType) -> str:
    if kind.is_text:
        return data.partition(b"\0")[0].decode("utf-8", "replace")
    return chr(data[0])


def _encode(character: str, kind: ValueType) -> bytes:
    if not kind.fits(character):
        raise ValueError(Reason.of("words.value_of_type", value=kind.value, name=character))
    if not kind.is_text:
        return bytes([ord(character)])
    data = character.encode()
    if len(data) >= kind.size:
        raise ValueError(Reason.of("words.text_too_long", size=kind.size - 1, count=len(data)))
    return data.ljust(kind.size, b"\0")
