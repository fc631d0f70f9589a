"""Units of people beside those of files."""

from math import isclose, pi

import pytest
from hypothesis import given, strategies as st

from onika.words.unit import RATES, UNITS, scale

choices = st.fixed_dictionaries({name: st.sampled_from(sorted(units)) for name, units in UNITS.items()})
known = st.sampled_from([next(iter(units)) + rate for units in UNITS.values() for rate in RATES])
others = st.sampled_from(["-", "N", "N m/rad", "Hz", "s", "1/s", "radish", "min", "", "deg", "mm"])
values = st.floats(-1e9, 1e9, allow_nan=False)


@given(known, choices, values)
def test_what_is_shown_and_read_back_is_the_same_value(unit, chosen, value):  # R-G08
    factor = scale(unit, chosen).factors[0]
    assert factor > 0
    assert isclose(value * factor / factor, value, rel_tol=1e-15, abs_tol=1e-300)


@given(st.lists(known | others, min_size=1, max_size=4), choices)
def test_a_list_of_units_has_a_factor_for_each(units, chosen):  # R-G08
    together = scale(",".join(units), chosen)
    alone = [scale(unit, chosen) for unit in units]
    assert together.factors == tuple(factor for one_scale in alone for factor in one_scale.factors)
    assert together.name == ",".join(one_scale.name for one_scale in alone)


@given(others, choices)
def test_other_units_are_read_as_they_are(unit, chosen):  # R-G08
    assert (scale(unit, chosen).name, scale(unit, chosen).is_plain) == (unit, True)


@given(known)
def test_where_nothing_else_is_preferred_values_are_those_of_files(unit):  # R-G08
    files = {name: next(iter(units)) for name, units in UNITS.items()}
    for chosen in (files, {}, {"angle_unit": "furlong"}):
        assert (scale(unit, chosen).name, scale(unit, chosen).is_plain) == (unit, True)


@pytest.mark.parametrize(
    ("unit", "name", "value", "shown"),
    [
        ("rad", "deg", pi, 180.0),
        ("rad/s", "deg/s", pi / 2, 90.0),
        ("m", "mm", 0.25, 250.0),
        ("m/s^2", "mm/s^2", 2, 2000),
    ],
)
def test_known_values(unit, name, value, shown):  # R-G08
    here = scale(unit, {"angle_unit": "deg", "length_unit": "mm"})
    assert here.name == name
    assert value * here.factors[0] == pytest.approx(shown)
