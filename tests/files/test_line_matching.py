import sys
from itertools import pairwise

import pytest
from hypothesis import given, strategies as st

from onika.files import line_matching
from onika.files.line_matching import MOST_CHANGES, Match, matches

TEXTS = st.text("ABCD", max_size=14)


def longest_common(old, new):
    """How many lines can stay at most, by the table that everybody knows."""
    row = [0] * (len(new) + 1)
    for line in old:
        before = row
        row = [0]
        for at, other in enumerate(new):
            row.append(before[at] + 1 if line == other else max(before[at + 1], row[at]))
    return row[-1]


def assert_sound(old, new, found):
    """Matches say what is so, in order, do not touch each other in both texts, and end with the texts."""
    assert found[-1] == (len(old), len(new), 0)
    for match in found:
        assert old[match.old : match.old + match.lines] == new[match.new : match.new + match.lines]
    for match, following in pairwise(found):
        assert match.lines
        assert match.old + match.lines <= following.old
        assert match.new + match.lines <= following.new


@given(TEXTS, TEXTS)
def test_as_many_lines_stay_as_can(old, new):  # R-B01
    found = matches(old, new)
    assert_sound(old, new, found)
    assert sum(match.lines for match in found) == longest_common(old, new)


@given(st.text("ABCD", max_size=40), st.text("ABCD", max_size=40), st.integers(0, 3))
def test_where_too_much_has_changed_what_is_said_is_still_so(old, new, most):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(line_matching, "MOST_CHANGES", most)
        assert_sound(old, new, matches(old, new))


def test_lines_that_both_texts_have_once_stay_where_all_else_has_changed():
    many = MOST_CHANGES
    old = [*["a"] * many, "first", *["b"] * many, "second", *["c"] * many]
    new = [*["d"] * many, "first", *["e"] * many, "second", *["f"] * many]
    assert matches(old, new) == [
        Match(many, many, 1),
        Match(2 * many + 1, 2 * many + 1, 1),
        Match(3 * many + 2, 3 * many + 2, 0),
    ]


def test_of_lines_that_changed_places_as_many_stay_as_keep_their_order():
    many = MOST_CHANGES
    old = [*["a"] * many, "x", "y", "z", *["b"] * many]
    new = [*["c"] * many, "z", "x", "y", *["d"] * many]
    assert matches(old, new) == [Match(many, many + 1, 2), Match(2 * many + 3, 2 * many + 3, 0)]


def lines_carried_out(old, new):
    """How many lines of the code it takes."""
    count = 0

    def trace(frame, event, _arg):
        nonlocal count
        if frame.f_code.co_filename != line_matching.__file__:
            return None
        count += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        matches(old, new)
    finally:
        sys.settrace(before)
    return count


@pytest.mark.parametrize("has_changed_everywhere", [False, True])
def test_twice_as_long_a_text_takes_twice_as_long(has_changed_everywhere):  # R-B01
    def work(icons):
        old = [line for icon in range(icons) for line in ("ICON", f"NAME {icon % 7}", *["PICT 8888"] * 8, "")]
        new = ["begin", *(line for number, line in enumerate(old) if number % 5 or not has_changed_everywhere), "end"]
        return lines_carried_out(old, new)

    work(1)
    assert work(400) < 2.5 * work(200)
