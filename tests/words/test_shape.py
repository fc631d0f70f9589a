"""Types with dimensions."""

import pytest
from hypothesis import given, strategies as st

from onika.words.shape import Shape
from onika.words.value import TEXT_CAPACITY, ValueType

DIMENSIONS = st.integers(1, 999) | st.from_regex(r"[A-Z][A-Z0-9_^]{0,6}", fullmatch=True)
SHAPES = st.builds(Shape, st.sampled_from(ValueType), st.lists(DIMENSIONS, max_size=3).map(tuple))


@given(SHAPES)
def test_a_shape_is_read_as_it_is_written(shape):  # R-A03
    assert Shape.parse(str(shape)) == shape


def test_dimensions_are_numbers_or_constants():  # R-A03
    assert Shape.parse("double[NDOF, 4]") == Shape(ValueType.DOUBLE, ("NDOF", 4))
    assert Shape.parse("double[NDOF,4]").names == ("NDOF",)


@pytest.mark.parametrize("text", ["", "real", "double[", "double[]", "double[0]", "double[-1]", "int[n]", "int[2][3]"])
def test_what_is_no_shape_is_refused_with_what_was_expected(text):  # R-A03
    with pytest.raises(ValueError, match=r"expected a (type|dimension)"):
        Shape.parse(text)


def test_a_shape_follows_its_constants():  # R-A03, law 7
    shape = Shape.parse("double[NDOF,4]")
    assert shape.resolve({"NDOF": 6}) == Shape(ValueType.DOUBLE, (6, 4))
    assert (shape.resolve({"NDOF": 6}).count, shape.resolve({"NDOF": 6}).size) == (24, 192)


def test_a_constant_that_is_missing_or_not_positive_gives_no_shape():
    with pytest.raises(KeyError):
        Shape.parse("double[NDOF]").resolve({})
    with pytest.raises(ValueError, match="at least 1"):
        Shape.parse("double[NDOF]").resolve({"NDOF": 0})


def test_a_scalar_is_one_element_and_a_text_has_a_fixed_capacity():  # law 7
    assert Shape.parse("int").count == 1
    assert Shape.parse("string").size == TEXT_CAPACITY
    assert Shape.parse("byte[128,128]").size == 16384
