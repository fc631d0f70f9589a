"""A new press of a button."""

import pytest

from onika.laws.signals.new_press import NewPress


@pytest.mark.parametrize(
    ("at_first", "then", "counts"),
    [
        (False, [True, True, False, True], [True, True, False, True]),
        (True, [True, True, False, True, True], [False, False, False, True, True]),
    ],
)
def test_what_is_pressed_already_counts_once_it_was_let_go(at_first, then, counts):
    press = NewPress(at_first)
    assert [press.is_there(is_pressed) for is_pressed in then] == counts
