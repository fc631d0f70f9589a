"""What an outside partner answers is looked at before it is believed."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.runtime.error import ModuleError
from onika.runtime.partner.answer import PartnerAnswer

ANYTHING = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=12,
)


def test_numbers_of_the_right_shape_are_an_array():  # R-F04
    answer = PartnerAnswer({"via": [[1, 2.5], [3, 4]], "one": 7, "none": []})
    assert answer.numbers("via", (None, 2)).tolist() == [[1.0, 2.5], [3.0, 4.0]]
    assert answer.number("one") == 7.0
    assert answer.numbers("none", (None, 6)).shape == (0, 6)


@pytest.mark.parametrize(
    "value",
    [
        *([1.0], [1.0, 2.0, 3.0], [[1.0, 2.0]], 1.0, "1 2", ["1", "2"], [True, False], None, {}, [None, 1.0]),
        *([float("nan"), 1.0], [float("inf"), 1.0], [1.0, [2.0]], [10**400, 1.0]),
    ],
)
def test_a_wrong_shape_and_what_is_no_finite_number_is_refused(value):  # R-F04
    with pytest.raises(ModuleError, match="expected q, 2 finite numbers, found"):
        PartnerAnswer({"q": value}).numbers("q", (2,))


def test_bounds_hold_for_each_element():  # R-F04
    answer = PartnerAnswer({"q": [0.5, 2.0]})
    assert answer.numbers("q", (2,), np.array([0.0, 0.0]), np.array([1.0, 3.0])).tolist() == [0.5, 2.0]
    with pytest.raises(ModuleError, match="expected q within"):
        answer.numbers("q", (2,), 0.0, 1.0)
    with pytest.raises(ModuleError, match="within 0 to 1"):
        answer.numbers("q", (2,), 0, 1)


def test_a_field_that_is_not_there_is_named_with_those_that_are():
    with pytest.raises(ModuleError, match="expected via in the answer, found id, points"):
        PartnerAnswer({"id": 1, "points": []}).numbers("via", (None,))


def test_a_text_is_a_text_of_some_length():
    assert PartnerAnswer({"name": "here"}).text("name") == "here"
    for value in (3, "x" * 300):
        with pytest.raises(ModuleError, match="a text of up to 255 characters"):
            PartnerAnswer({"name": value}).text("name")


@given(value=ANYTHING, shape=st.sampled_from([(), (2,), (None,), (None, 3), (2, 2)]))
def test_whatever_is_answered_numbers_are_finite_and_of_the_shape_or_refused(value, shape):  # R-F04
    try:
        numbers = PartnerAnswer({"q": value}).numbers("q", shape)
    except ModuleError:
        return
    assert np.isfinite(numbers).all()
    assert numbers.ndim == len(shape)
    assert all(wanted in (count, None) for count, wanted in zip(numbers.shape, shape, strict=True))
