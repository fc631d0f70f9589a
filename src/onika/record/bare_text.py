"""Recordings of version 0.1.0 hold bare texts where reasons stand today: they are read as reasons without a key."""

from collections.abc import Callable
from typing import Any, TypeVar

import msgspec
from msgspec import inspect

from onika.words.reason import Reason

Kind = TypeVar("Kind")


def decoder(kind: type[Kind]) -> Callable[[bytes], Kind]:
    """Reads a struct from JSON, also one that was written with bare texts; raises `msgspec.MsgspecError`."""
    decode = msgspec.json.Decoder(kind).decode
    type_info = inspect.type_info(kind)

    def read(body: bytes) -> Kind:
        try:
            return decode(body)
        except msgspec.ValidationError:
            return msgspec.convert(_with_reasons(msgspec.json.decode(body), type_info), kind)

    return read


def _with_reasons(value: Any, kind: inspect.Type) -> Any:
    """The same value with a reason for every text that stands in the place of one."""
    match kind:
        case inspect.StructType() if kind.cls is Reason and isinstance(value, str):
            return msgspec.to_builtins(Reason.plain(value))
        case inspect.StructType() if isinstance(value, dict) and kind.cls is not Reason:
            types = {field.encode_name: field.type for field in kind.fields}
            return {name: _with_reasons(held, types[name]) if name in types else held for name, held in value.items()}
        case inspect.UnionType():
            return _with_reasons(value, _member(value, kind))
        case inspect.VarTupleType() | inspect.ListType() if isinstance(value, list):
            return [_with_reasons(held, kind.item_type) for held in value]
        case inspect.DictType() if isinstance(value, dict):
            return {name: _with_reasons(held, kind.value_type) for name, held in value.items()}
    return value


def _member(value: Any, union: inspect.UnionType) -> inspect.Type:
    """Which type of a union a value is of: a map by its tag, a text is a reason where no texts are meant."""
    structs = [kind for kind in union.types if isinstance(kind, inspect.StructType)]
    if isinstance(value, dict):
        tagged = (kind for kind in structs if kind.tag_field and value.get(kind.tag_field) == kind.tag)
        return next(tagged, inspect.AnyType())
    if isinstance(value, str) and not any(isinstance(kind, inspect.StrType) for kind in union.types):
        return next((kind for kind in structs if kind.cls is Reason), inspect.AnyType())
    return inspect.AnyType()
