"""User input against an argument line."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.runtime.user_input import AskedItem, UserInput
from onika.wire.sheet import InputSheet
from onika.words import argument
from onika.words.value import ValueType


def wanted(*sheets, **constants):
    return UserInput(tuple(sheets), constants)


def sheet(shape, name="x", low=None, high=None, default=None):
    return InputSheet(name, shape, "rad", "meaning", low, high, default)


@pytest.mark.parametrize(
    ("kind", "word", "value"),
    [
        ("string", "box", "box"), ("line", '"two words"', "two words"), ("char", "é", "é"), ("byte", "255", 255),
        ("short", "-32768", -32768), ("int", "7", 7), ("long", "-9000000000", -9_000_000_000),
        ("float", "0.25", 0.25), ("double", "1e-3", 1e-3),
    ],
)  # fmt: skip
def test_a_scalar_of_each_of_the_nine_types_is_read(kind, word, value):  # R-A10
    x = wanted(sheet(kind)).parse(word).x
    assert (x, type(x)) == (value, type(value))


@pytest.mark.parametrize("kind", [kind for kind in ValueType if kind.is_real or kind.is_whole])
def test_a_vector_of_each_number_type_is_an_array_of_that_type(kind):  # R-A10
    value = wanted(sheet(f"{kind.value}[3]")).parse("1 2 3").x
    assert value.tolist() == [1, 2, 3]
    assert value.dtype == np.dtype(kind.code)


@pytest.mark.parametrize("kind", ["string", "line", "char"])
def test_a_vector_of_letters_is_a_list(kind):  # R-A10
    assert wanted(sheet(f"{kind}[2]")).parse("a b").x == ["a", "b"]


def test_several_inputs_take_their_words_in_order_of_definition():  # reading 40
    values = wanted(sheet("double[2]", "endpoint"), sheet("line", "label"), sheet("int", "count")).parse('1 2 "a b" 3')
    assert (values.endpoint.tolist(), values.label, values.count) == ([1.0, 2.0], "a b", 3)


@given(st.lists(st.text(max_size=20), min_size=3, max_size=3))
def test_any_texts_arrive_through_the_argument_line(texts):  # reading 40
    assert wanted(sheet("line[3]")).parse(argument.join(texts)).x == texts


@pytest.mark.parametrize("line", ["", "1", "1 2 3"])
def test_missing_or_too_many_values_are_refused_with_what_is_wanted(line):  # R-A10, reading 40
    with pytest.raises(ValueError, match=r"expected 2 values \(x\[2\]\), found "):
        wanted(sheet("double[2]")).parse(line)


def test_a_malformed_line_is_refused():  # R-A10
    with pytest.raises(ValueError, match="double quotes"):
        wanted(sheet("string")).parse('"open')


def test_everything_that_is_wrong_is_told_at_once():  # R-A10
    with pytest.raises(ValueError, match=r"^a\[1\]: .*'x'; b: .*whole number .*'1.5'$"):
        wanted(sheet("double[2]", "a"), sheet("int", "b")).parse("1 x 1.5")


@given(st.floats(-10, 10), st.floats(-10, 10), st.floats(-20, 20))
def test_bounds_by_number_belong_to_what_is_allowed(low, other, value):  # R-A10
    low, high = sorted((low, other))
    line = repr(value)
    if low <= value <= high:
        assert wanted(sheet("double", low=low, high=high)).parse(line).x == value
    else:
        with pytest.raises(ValueError, match="rad, found"):
            wanted(sheet("double", low=low, high=high)).parse(line)


def test_bounds_may_be_the_names_of_constants_element_by_element():  # law 25
    item = wanted(sheet("double[NDOF]", low="QMIN", high="QMAX"), NDOF=2, QMIN=np.array([-1, -2]), QMAX=3.0)
    assert (item.items[0].low, item.items[0].high) == ((-1.0, -2.0), (3.0, 3.0))
    assert item.parse("-1 -2").x.tolist() == [-1.0, -2.0]
    with pytest.raises(ValueError, match=r"x\[0\]: expected -1..3 rad, found -1.5"):
        item.parse("-1.5 -1.5")


def test_one_bound_alone_leaves_the_other_side_open():
    assert wanted(sheet("int", low=1)).parse("2000000000").x == 2_000_000_000
    with pytest.raises(ValueError, match=r"expected 1..inf rad, found 0"):
        wanted(sheet("int", low=1)).parse("0")


def test_bounds_that_do_not_fit_the_vector_are_refused_at_once():
    with pytest.raises(ValueError, match="x has 2 elements: expected as many bounds or defaults, found 3"):
        wanted(sheet("double[2]", low="QMIN"), QMIN=np.zeros(3))


def test_an_item_says_everything_a_user_has_to_know():  # R-A10
    item = wanted(sheet("double[2]", low=0, high=9, default=[1.0, 2.0])).items[0]
    assert item == AskedItem("x", "double", 2, "rad", "meaning", (1.0, 2.0), (0.0, 0.0), (9.0, 9.0))


def test_one_default_stands_for_every_element():
    assert wanted(sheet("string[2]", default="none")).items[0].default == ("none", "none")
    assert wanted(sheet("double[2]")).items[0].default is None


def test_a_task_that_wants_nothing_takes_an_empty_line():
    assert vars(wanted().parse("")) == {}
    with pytest.raises(ValueError, match="expected 0 values"):
        wanted().parse("1")


def test_what_was_read_ahead_is_handed_out_once_and_read_anew_after_it():  # R-A10
    inputs = wanted(sheet("double[2]"))
    inputs.foresee(["1 2", "not a number"])
    first, second = inputs.parse("1 2"), inputs.parse("1 2")
    first.x[:] = 0.0
    assert second.x.tolist() == [1.0, 2.0]
    with pytest.raises(ValueError, match="expected 2 values"):
        inputs.parse("not a number")


def test_a_value_beyond_a_bound_by_a_hair_is_told_in_full():  # R-A10, R-X01
    with pytest.raises(ValueError, match=r"expected 0\.1..600 rad, found 600\.0001"):
        wanted(sheet("double", low=0.1, high=600.0)).parse("600.0001")
