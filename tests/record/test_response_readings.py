import math

import numpy as np
import pytest

from onika.record.frequency_response import FrequencyResponse
from onika.record.response_readings import readings

HERTZ = np.linspace(0.1, 40.0, 2000)


def response(gain, coherence=1.0):
    return FrequencyResponse(HERTZ, gain(2j * np.pi * HERTZ), np.full(len(HERTZ), coherence), 9)


def test_the_bandwidth_is_where_half_the_power_is_left():  # R-C14
    reading = readings(response(lambda s: 5.0 / (1.0 + s / (2 * np.pi * 6.0))))
    assert reading.low_db == pytest.approx(20 * math.log10(5.0), abs=0.01)
    assert reading.bandwidth_hz == pytest.approx(6.0, rel=1e-3)
    assert reading.peak_db == 0.0


def test_the_peak_is_that_of_a_weakly_damped_system():  # R-C14
    omega, damping = 2 * np.pi * 8.0, 0.2
    reading = readings(response(lambda s: omega**2 / (s * s + 2 * damping * omega * s + omega**2)))
    assert reading.peak_db == pytest.approx(-20 * math.log10(2 * damping * math.sqrt(1 - damping**2)), abs=0.01)
    assert reading.peak_hz == pytest.approx(8.0 * math.sqrt(1 - 2 * damping**2), abs=0.02)


def open_loop(s):
    """Two lags and an integrator: textbook margins."""
    return 40.0 / (s * (1 + s / 20.0) * (1 + s / 60.0))


def test_margins_of_an_open_loop_are_those_of_the_closed_one_that_it_makes():  # R-C14
    opened = readings(response(open_loop), is_open=True)
    closed = readings(response(lambda s: open_loop(s) / (1 + open_loop(s))))
    # The phase is -180 degrees at sqrt(20 * 60) rad/s; the gain there is 40 / 80.
    assert opened.gain_margin_hz == pytest.approx(math.sqrt(1200.0) / (2 * np.pi), rel=1e-3)
    assert opened.gain_margin_db == pytest.approx(20 * math.log10(2.0), abs=0.01)
    omega = 2 * np.pi * opened.phase_margin_hz
    assert abs(open_loop(1j * omega)) == pytest.approx(1.0, rel=1e-3)
    wanted = 180 - 90 - math.degrees(math.atan(omega / 20.0) + math.atan(omega / 60.0))
    assert opened.phase_margin == pytest.approx(wanted, abs=0.05)
    for name in ("phase_margin", "phase_margin_hz", "gain_margin_db", "gain_margin_hz"):
        assert getattr(closed, name) == pytest.approx(getattr(opened, name), rel=1e-6)


def test_a_loop_that_swings_has_negative_margins():
    reading = readings(response(lambda s: 4.0 * open_loop(s)), is_open=True)
    assert reading.phase_margin < 0.0
    assert reading.gain_margin_db < 0.0


def test_what_is_not_there_is_no_number():
    reading = readings(response(lambda s: 0.5 + 0 * s), is_open=True)
    assert math.isnan(reading.bandwidth_hz)
    assert math.isnan(reading.phase_margin)
    assert math.isnan(reading.gain_margin_db)


def test_what_is_not_reliable_is_not_read():
    assert math.isnan(readings(response(open_loop, coherence=0.5)).low_db)
