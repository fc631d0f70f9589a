"""The words of a line in files of robots and worlds."""

import pytest

from onika.files.block_words import number_row, reals, text_row


@pytest.mark.parametrize(
    ("words", "numbers"),
    [(("1", "-.5", "2e3"), (1.0, -0.5, 2000.0)), ((), ()), (("1e10",), None), (("nan",), None), (("1", "a"), None)],
)
def test_numbers_are_finite_and_bounded(words, numbers):  # R-B07
    assert reals(words) == numbers


def test_a_zero_has_no_sign():
    assert str(reals(("-0",))[0]) == "0.0"


def test_numbers_are_written_as_short_as_they_are_read_back():  # R-B08
    assert number_row("AT", (1.0, 0.1)) == "AT          1 0.1\n"
    assert text_row("DESC", "") == ""
    assert text_row("DESC", "a\nb") == "DESC        a b\n"
