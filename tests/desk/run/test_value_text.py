import pytest
from hypothesis import given, strategies as st

from onika.desk.run.value_text import flat, shown, type_of, words
from onika.words.argument import split


@pytest.mark.parametrize(
    ("value", "kind"),
    [(1, "int"), (1.5, "double"), ("x", "string"), ([1.0] * 3, "double[3]"), ([[1, 2]], "int[1,2]"), ([], "int")],
)
def test_a_value_shows_its_type(value, kind):
    assert type_of(value) == kind


@given(st.lists(st.one_of(st.floats(allow_nan=False), st.integers(), st.text())))
def test_all_elements_stand_in_one_line_from_which_they_can_be_read(value):
    elements = split(words(value))
    assert [type(element)(word) for element, word in zip(value, elements, strict=True)] == value


def test_numbers_are_shown_as_people_read_them():
    assert shown("X", [0.0, -1e-7, 1.5]) == ["X = 0.0000  0.0000  1.5000"]
    assert shown("X", [0.0, -1e-7]) == ["X = 0.000e+00  -1.000e-07"]
    assert shown("X", 123456.0) == ["X = 1.235e+05"]
    assert shown("S", ["a b", "c"]) == ["S = 'a b'    'c'"]
    assert shown("N", 7) == ["N = 7"]
    assert shown("M", [[1, 2], [3, 4]])[1].split() == ["M[1]", "=", "3", "4"]
    assert flat([[1, [2]], 3]) == [1, 2, 3]
