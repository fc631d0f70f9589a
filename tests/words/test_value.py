"""The nine types of values."""

import math
import struct

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.words.value import TEXT_CAPACITY, ValueType

REAL = [kind for kind in ValueType if kind.is_real]
WHOLE = [kind for kind in ValueType if kind.is_whole]
TEXTS = [kind for kind in ValueType if kind.is_text]


def test_there_are_nine_types():  # R-A10
    names = ["string", "line", "char", "byte", "float", "double", "long", "int", "short"]
    assert [kind.value for kind in ValueType] == names


@given(st.sampled_from(WHOLE), st.integers())
def test_a_whole_number_is_read_within_its_range_and_refused_beyond(kind, number):  # R-A10
    low, high = kind.bounds
    if low <= number <= high:
        assert kind.parse(str(number)) == number
        assert kind.parse(kind.show(number)) == number
        assert kind.fits(number)
    else:
        assert not kind.fits(number)
        with pytest.raises(ValueError, match=f"expected a {kind.value} from"):
            kind.parse(str(number))


@pytest.mark.parametrize("kind", WHOLE)
def test_the_range_of_a_whole_number_is_that_of_its_place_in_memory(kind):
    info = np.iinfo(kind.code)
    assert kind.bounds == (info.min, info.max)


@given(st.sampled_from(REAL), st.floats(allow_nan=False, allow_infinity=False))
def test_a_real_number_is_read_as_it_is_shown(kind, number):
    assert kind.parse(kind.show(number)) == number
    assert kind.fits(number)


@pytest.mark.parametrize("kind", REAL)
@pytest.mark.parametrize("text", ["nan", "inf", "-inf", "1e999"])
def test_nan_and_infinity_are_no_input(kind, text):  # law 5
    with pytest.raises(ValueError, match="finite"):
        kind.parse(text)
    assert not kind.fits(math.nan)
    assert not kind.fits(math.inf)


@pytest.mark.parametrize("kind", [*REAL, *WHOLE])
@pytest.mark.parametrize("text", ["", "one", "1,5", "0x1g"])
def test_what_is_no_number_is_refused_and_shown(kind, text):
    with pytest.raises(ValueError, match=r"expected a (whole )?number"):
        kind.parse(text)


@pytest.mark.parametrize("kind", WHOLE)
def test_a_real_number_is_no_whole_one(kind):
    assert not kind.fits(1.5)
    with pytest.raises(ValueError, match="whole"):
        kind.parse("1.5")


@given(st.sampled_from(TEXTS), st.text())
def test_a_text_is_itself(kind, text):
    assert kind.parse(text) == text == kind.show(text)
    assert kind.fits(text)


def test_a_character_is_one_of_256():
    assert ValueType.CHAR.parse("é") == "é"
    for text in ("", "ab", "€"):
        assert not ValueType.CHAR.fits(text)
        with pytest.raises(ValueError, match="one character"):
            ValueType.CHAR.parse(text)


@pytest.mark.parametrize("kind", ValueType)
def test_the_size_in_memory_is_that_of_the_code(kind):
    expected = TEXT_CAPACITY if kind in TEXTS else np.dtype(kind.code).itemsize
    assert kind.size == expected
    assert struct.calcsize("=" + kind.code) == np.dtype(kind.code).itemsize


def test_every_type_is_of_one_sort():
    sorts = [(kind.is_text, kind.is_real, kind.is_whole, kind is ValueType.CHAR) for kind in ValueType]
    assert all(sum(sort) == 1 for sort in sorts)
