from typing import Annotated, Literal

import msgspec
import pytest
from hypothesis import find, given

from kit.wire.struct_values import values_of


class Leaf(msgspec.Struct, frozen=True, tag=True):
    word: Annotated[str, msgspec.Meta(min_length=5, max_length=6)]
    edge: Literal["left", "right"]


class Branch(msgspec.Struct, frozen=True, tag=True):
    leaves: "tuple[Leaf | Branch, ...]"
    count: Annotated[int, msgspec.Meta(ge=3, le=4)] = 3
    names: dict[str, float] = {}


class Strange(msgspec.Struct):
    many: set[int]


@given(values_of(Branch))
def test_a_value_is_what_its_struct_says(branch):
    assert msgspec.convert(msgspec.to_builtins(branch), Branch) == branch


def test_parts_are_filled_as_deep_as_they_may_stand():
    assert find(values_of(Branch), lambda branch: any(isinstance(each, Branch) for each in branch.leaves))


def test_a_type_that_no_message_is_made_of_is_refused():
    with pytest.raises(TypeError, match="found SetType"):
        values_of(Strange)
