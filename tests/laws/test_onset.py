"""When something begins."""

import pytest

from onika.laws.onset import Onset


@pytest.mark.parametrize(("after", "dt", "first"), [(0.0, 0.01, 0), (0.3, 0.1, 3), (0.3, 0.01, 30), (0.26, 0.1, 3)])
def test_it_begins_at_the_cycle_that_is_nearest_to_its_time(after, dt, first):
    onset = Onset(after)
    assert [onset.has_come(dt) for _ in range(first + 3)] == [False] * first + [True] * 3


def test_its_age_is_how_long_ago_it_began():
    onset = Onset(0.05)
    ages = []
    for _ in range(8):
        onset.has_come(0.01)
        ages.append(onset.age)
    assert ages == pytest.approx([-0.05, -0.04, -0.03, -0.02, -0.01, 0.0, 0.01, 0.02])
