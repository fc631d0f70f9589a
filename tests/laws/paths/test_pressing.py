"""A way that is led by what is felt."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.paths.pressing import Pressing

DT = 0.004


@settings(max_examples=examples(30), deadline=None)
@given(st.floats(10.0, 200.0), st.floats(2000.0, 20_000.0), st.floats(0.0, 0.02))
def test_on_a_spring_it_comes_to_the_force_and_never_beyond_it(force, stiffness, away):  # R-B10
    pressing = Pressing([0.0, 0.0, -force], 0.02, 4e-4)
    place, felt, most = 0.0, 0.0, 0.0
    for _ in range(round((away / min(0.02, 4e-4 * force) + 12.0 / (4e-4 * stiffness)) / DT)):
        place += pressing.step([0.0, 0.0, felt], DT)[2]
        felt = stiffness * max(-away - place, 0.0)
        most = max(most, felt)
    assert felt == pytest.approx(force, rel=0.01)
    assert most <= force * 1.05 + 1e-9
    assert pressing.way == pytest.approx(-place)


def test_it_is_never_faster_than_its_pace_and_goes_back_where_too_much_is_felt():
    pressing = Pressing([3.0, 4.0, 0.0], 0.02, 1.0)
    assert pressing.step([0, 0, 0], DT) == pytest.approx(0.02 * DT * np.array([0.6, 0.8, 0]))
    assert pressing.step([-9.0, -12.0, 0], DT) == pytest.approx(-0.02 * DT * np.array([0.6, 0.8, 0]))
    assert pressing.lacks([-3.0, -4.0, 9.0]) == pytest.approx(0.0)


def test_where_nothing_is_wanted_it_goes_nowhere():
    pressing = Pressing([0, 0, 0], 0.02, 1.0)
    assert pressing.step([50.0, 0, 0], DT).tolist() == [0, 0, 0]
