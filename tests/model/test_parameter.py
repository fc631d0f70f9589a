import pytest
from hypothesis import given, strategies as st

from onika.model.parameter import check, default_words, parse
from onika.wire.sheet import LocalSheet
from onika.words.shape import Shape


def test_a_scalar_is_one_word():  # R-A01
    assert parse("CUTOFF", Shape.parse("double"), ("40.5",)) == 40.5
    assert parse("COUNT", Shape.parse("int"), ("7",)) == 7


def test_a_vector_is_as_many_words_as_it_has_elements():  # R-A01
    assert parse("BASE", Shape.parse("double[2]"), ("1", "2")) == [1.0, 2.0]


def test_a_line_keeps_its_words_together():
    assert parse("TEXT", Shape.parse("line"), ("two", "words")) == "two words"


@pytest.mark.parametrize(
    ("shape", "words", "sentence"),
    [
        ("double", ("1", "2"), "expected one double, found 2 words"),
        ("double[3]", ("1", "2"), "expected 3 values, found 2"),
        ("double", ("nan",), "expected a finite number"),
        ("int", ("1.5",), "expected a whole number"),
    ],
)
def test_what_does_not_fit_is_refused_in_words(shape, words, sentence):  # R-B07
    with pytest.raises(ValueError, match=f"LOCAL GAIN: .*{sentence}"):
        parse("GAIN", Shape.parse(shape), words)


STIFF = LocalSheet("STIFF", "double", "-", "share of KP", 1.0, 0.1, 2.0)


@given(st.floats(-10, 10))
def test_a_number_is_taken_within_its_bounds_and_refused_beyond_them(number):  # R-B07
    word = (repr(number),)
    if 0.1 <= number <= 2.0:
        assert check(STIFF, word) == number
    else:
        with pytest.raises(ValueError, match=r"expected 0.1\.\.2 -, found"):
            check(STIFF, word)


def test_each_element_of_a_vector_has_the_bounds_of_its_parameter():  # R-B07
    both = LocalSheet("BOTH", "double[2]", "m", "two lengths", None, 0.0, None)
    assert check(both, ("1", "0")) == [1.0, 0.0]
    with pytest.raises(ValueError, match=r"expected 0\.\.inf m, found -1"):
        check(both, ("1", "-1"))


@pytest.mark.parametrize(
    ("default", "words"),
    [(None, ()), (1.0, ("1.0",)), (3, ("3",)), ([0.5, 2.0], ("0.5", "2.0")), ("two words", ("two", "words"))],
)
def test_a_default_is_written_as_a_file_would_have_it(default, words):  # R-B02
    assert default_words(LocalSheet("X", "double", "-", "", default)) == words
