import pytest
from hypothesis import given, strategies as st

from onika.desk.trial.tolerance import LASTS_S, demand, readable, tolerance, upwards
from onika.model.kept import Demand


def test_what_stays_the_same_is_asked_for_as_exactly_as_its_unit_says():  # R-X07
    assert demand("Q", "rad", True, [(0.18144, -1.5)] * 3) == Demand("Q", (0.181, -1.5), "rad", 0.005)
    assert demand("GRIP", "-", True, [(-1.0,)]) == Demand("GRIP", (-1.0,), "", 0.01)


def test_what_varies_is_asked_for_less_exactly_and_then_not_at_all():  # R-X07
    assert demand("Q", "rad", True, [(1.0,), (1.006,)]).tolerance == 0.02
    assert demand("Q", "rad", True, [(1.0,), (1.1,)]) is None


def test_whole_numbers_are_asked_for_exactly_or_not_at_all():  # R-X07
    assert demand("LAMP", "-", False, [(1.0,), (1.0,)]) == Demand("LAMP", (1.0,))
    assert demand("LAMP", "-", False, [(1.0,), (0.0,)]) is None


@pytest.mark.parametrize("unit", ["N", "N m", "rad/s", "m/s", "V"])
def test_forces_and_speeds_are_never_asked_for(unit):  # R-X07
    assert demand("F", unit, True, [(1.0,), (1.0,)]) is None


def test_what_is_no_number_is_not_asked_for():
    assert demand("Q", "rad", True, [(float("nan"),)]) is None


def test_durations_have_a_floor_of_their_own():  # R-X07
    assert tolerance(LASTS_S, 0.0) == 0.05
    assert tolerance(LASTS_S, 9.0) is None


@given(st.floats(1e-6, 1e3), st.floats(-1e3, 1e3))
def test_a_tolerance_is_readable_and_never_smaller_and_rounding_stays_well_within_it(wanted, value):
    within = upwards(wanted)
    assert wanted * (1 - 1e-6) <= within <= 2.6 * wanted
    assert float(f"{within:.0e}") == pytest.approx(within)
    assert abs(readable(value, within) - value) <= within / 2
