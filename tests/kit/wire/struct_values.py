"""Strategies for values of any message struct, made from what its fields are said to be."""

from functools import cache
from typing import Any

import msgspec
from hypothesis import strategies as st
from msgspec import inspect

_INT64 = 2**63
_SCALARS = st.none() | st.booleans() | st.integers(-9, 9) | st.text(max_size=3)
_ANYTHING = _SCALARS | st.lists(_SCALARS, max_size=2)


@cache
def values_of(kind: type[msgspec.Struct]) -> st.SearchStrategy[Any]:
    """Values of a struct with something in each of its fields."""
    struct = inspect.type_info(kind)
    assert isinstance(struct, inspect.StructType)
    return st.builds(kind, **{field.name: _values(field.type) for field in struct.fields})


def _values(kind: inspect.Type) -> st.SearchStrategy[Any]:
    match kind:
        case inspect.AnyType():
            return _ANYTHING
        case inspect.NoneType():
            return st.none()
        case inspect.BoolType():
            return st.booleans()
        case inspect.IntType():
            low = -_INT64 if kind.ge is None else kind.ge
            return st.integers(low, _INT64 - 1 if kind.le is None else kind.le)
        case inspect.FloatType():
            return st.floats(allow_nan=False, allow_infinity=False)
        case inspect.StrType():
            most = 3 if kind.max_length is None else min(kind.max_length, max(3, kind.min_length or 0))
            return st.text(min_size=kind.min_length or 0, max_size=most)
        case inspect.BytesType():
            return st.binary(max_size=3)
        case inspect.LiteralType():
            return st.sampled_from(kind.values)
    return _values_of_many(kind)


def _values_of_many(kind: inspect.Type) -> st.SearchStrategy[Any]:
    match kind:
        case inspect.UnionType():
            return st.one_of([_values(each) for each in kind.types])
        case inspect.TupleType():
            return st.tuples(*(_values(each) for each in kind.item_types))
        case inspect.VarTupleType():
            return st.lists(_values(kind.item_type), max_size=2).map(tuple)
        case inspect.ListType():
            return st.lists(_values(kind.item_type), max_size=2)
        case inspect.DictType():
            return st.dictionaries(_values(kind.key_type), _values(kind.value_type), max_size=2)
        case inspect.StructType():
            return st.deferred(lambda: values_of(kind.cls))
    raise TypeError(f"expected a type that messages are made of, found {kind}")
