"""Test signals as functions of time."""

import math

import pytest
from hypothesis import given, strategies as st

from onika.laws.waveform import PERIODIC, sweep, wave

turns = st.floats(0.0, 1e4)
rates = st.floats(0.01, 100.0)


@given(st.sampled_from(PERIODIC), turns, rates)
def test_a_wave_stays_within_one_and_repeats_with_every_turn(kind, place, rate):
    assert -1.0 <= wave(kind, place, rate)[0] <= 1.0
    edge = min((place + 0.25) % 0.25, 0.25 - (place + 0.25) % 0.25)
    if edge > 1e-6:  # at a corner the last bit of a number decides on which side it lies
        assert wave(kind, place % 1.0 + 3.0, rate) == pytest.approx(wave(kind, place, rate), rel=1e-6, abs=1e-6 * rate)


@given(st.sampled_from(("sine", "triangle")), st.floats(0.0, 10.0), rates)
def test_the_slope_of_a_wave_is_its_difference_quotient(kind, place, rate):
    near = 1e-6
    before, after = wave(kind, place, rate)[0], wave(kind, place + near, rate)[0]
    corner = (place + 0.25) % 0.5  # a triangle turns at 1/4 and 3/4
    if kind == "sine" or 1e-5 < corner < 0.5 - 1e-5:
        assert (after - before) / (near / rate) == pytest.approx(wave(kind, place, rate)[1], abs=1e-3 * rate)


def test_waves_begin_as_they_are_told():
    assert wave("sine", 0.0, 1.0) == (0.0, pytest.approx(2.0 * math.pi))
    assert wave("triangle", 0.0, 1.0) == (0.0, 4.0)
    assert wave("triangle", 0.25, 1.0)[0] == 1.0
    assert [wave("square", place, 1.0)[0] for place in (0.0, 0.49, 0.5, 0.99)] == [1.0, 1.0, -1.0, -1.0]
    with pytest.raises(ValueError, match="expected one of sine square triangle, found sawtooth"):
        wave("sawtooth", 0.0, 1.0)


@given(st.floats(0.1, 20.0), st.floats(0.1, 20.0), st.floats(0.1, 30.0))
def test_a_sweep_takes_whole_turns_and_ends_at_rest(first, last, lasts):
    whole, rate = sweep(1e6, first, last, lasts)
    assert whole == int(whole)
    assert rate == 0.0
    assert whole <= (first + last) / 2.0 * lasts + 1e-6
    assert abs(wave("sine", whole, 0.0)[0]) < 1e-9


@given(st.floats(0.5, 20.0), st.floats(0.5, 20.0), st.floats(2.0, 30.0), st.floats(0.0, 0.999))
def test_turns_of_a_sweep_pass_at_its_frequency_which_goes_from_first_to_last(first, last, lasts, share):
    mean = (first + last) / 2.0
    duration = math.floor(mean * lasts + 1e-9) / mean
    time, near = share * duration, 1e-5 * duration
    place, rate = sweep(time, first, last, lasts)
    assert min(first, last) - 1e-9 <= rate <= max(first, last) + 1e-9
    later = sweep(min(time + near, duration * (1 - 1e-12)), first, last, lasts)[0]
    assert (later - place) / near == pytest.approx(rate, rel=0.01, abs=0.01)
