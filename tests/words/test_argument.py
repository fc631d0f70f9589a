"""The argument line of a task."""

import pytest
from hypothesis import given, strategies as st

from onika.words.argument import join, split


@given(st.lists(st.text()))
def test_whatever_words_are_joined_are_split_again(words):  # reading 40
    assert split(join(words)) == words


def test_plain_words_are_written_plainly():
    assert join(["0.5", "-1e3", "box"]) == "0.5 -1e3 box"


def test_words_with_blanks_quotes_and_nothing_at_all_stand_in_quotes():  # reading 40
    assert join(["two words", 'a"b', ""]) == '"two words" "a\\"b" ""'


def test_blanks_around_and_between_words_do_not_count():
    assert split("  a \t b  ") == ["a", "b"]
    assert split("   ") == []


@pytest.mark.parametrize("line", ['"open', 'a"b', '"a"b', '"', 'a "b c'])
def test_a_quote_that_is_not_closed_or_stands_inside_a_word_is_refused(line):  # R-A10
    with pytest.raises(ValueError, match="double quotes"):
        split(line)


@given(st.text(alphabet='ab "\\'))
def test_any_line_is_split_or_refused_with_a_reason(line):
    try:
        words = split(line)
    except ValueError as wrong:
        assert "found" in str(wrong)
    else:
        assert split(join(words)) == words
