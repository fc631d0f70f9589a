import pytest

from onika.runtime.parameter import parse
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
