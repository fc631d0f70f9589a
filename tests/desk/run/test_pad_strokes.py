"""Strokes of a pad in a script."""

import pytest

from onika.desk.run.pad_strokes import steps


def test_a_stroke_is_many_pushes_between_two_times_of_letting_go():  # R-K07
    assert steps("pad 0 0 -1 for 0.1") == (("pad free", "wait 0.05") + ("pad 0 0 -1", "wait 0.05") * 2 + ("pad free",))
    assert len(steps("pad 0 0 -1 for 0.3")) == 2 + 2 * 6 + 1


def test_a_press_ends_by_itself():
    assert steps("pad press for 0.1") == ("pad press", "wait 0.05") * 2


@pytest.mark.parametrize(
    "line", ["pad 0 0 1", "wait 3", "pad free", "pad 0 0 1 for x", "pad 0 0 1 for -1", "pad 1 1 1 for nan", ""]
)
def test_any_other_line_is_itself(line):
    assert steps(line) == (line,)
