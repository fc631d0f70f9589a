"""The signal generators of the laboratory."""

import math

import numpy as np
import pytest

from onika.laws import puma560
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "signals" / "module" / "generator.py"


def signal(cycles, **local):
    """The signal at every cycle from the first on, at 100 Hz."""
    bench = Bench(CODE, frequency=100, local=local).init().on()
    return np.array([bench.cycle()["SIGNAL"] for _ in range(cycles)])


def test_a_sine_swings_about_its_offset_with_its_frequency():  # R-C14
    time = np.arange(300) / 100
    expected = 0.5 + 2.0 * np.sin(2 * np.pi * 0.7 * time)
    assert signal(300, AMPLITUDE=2, OFFSET=0.5, FREQUENCY=0.7) == pytest.approx(expected, abs=1e-9)


def test_a_square_and_a_triangle_have_the_height_that_is_asked_for():
    assert set(signal(200, WAVE="square", AMPLITUDE=3)) == {3.0, -3.0}
    triangle = signal(200, WAVE="triangle", AMPLITUDE=3)
    assert (triangle.max(), triangle.min()) == (pytest.approx(3.0), pytest.approx(-3.0))
    assert np.abs(np.diff(triangle)).max() == pytest.approx(4 * 3 / 100)


def test_a_step_comes_after_its_delay_and_not_before():
    assert list(signal(30, WAVE="step", AMPLITUDE=2, OFFSET=1, DELAY=0.2)) == [1.0] * 20 + [3.0] * 10


def test_a_sweep_goes_through_its_frequencies_once_and_rests():
    sweep = signal(800, WAVE="sweep", FREQUENCY=1, END=5, LASTS=6)
    crossings = np.flatnonzero((sweep[:-1] < 0) & (sweep[1:] >= 0))
    gaps = np.diff(crossings)
    assert gaps[0] > 50  # it passes from 1 Hz, where a wave takes a second
    assert gaps[-1] < 25  # to 5 Hz, where it takes a fifth
    assert (np.diff(gaps) <= 1).all()
    assert sweep[605:] == pytest.approx(0.0, abs=1e-9)


def test_another_frequency_goes_on_where_the_wave_stands():  # R-A05
    bench = Bench(CODE, frequency=100, local={"FREQUENCY": 1}).init().on().cycle(38)
    before = bench["SIGNAL"]
    bench.set("FREQUENCY", "2")
    assert abs(bench.cycle()["SIGNAL"] - before) < 2 * math.pi * 2 / 100
    assert bench.get("FREQUENCY") == 2.0


def test_what_is_out_of_bounds_is_refused_and_changes_nothing():
    bench = Bench(CODE, frequency=100).init().on().cycle()
    with pytest.raises(Exception, match=r"AMPLITUDE: expected 0\.\.10, found 11"):
        bench.set("AMPLITUDE", "11")
    assert bench.get("AMPLITUDE") == 1.0
    assert bench.state is State.ON


def test_a_wave_that_is_none_is_refused_before_it_is_on():
    bench = Bench(CODE, frequency=100, local={"WAVE": "sawtooth"}).init()
    assert bench.state is State.ERROR
    assert "sine square triangle step sweep, found sawtooth" in str(bench.why)


JOINTS = shipped() / "generic" / "module" / "jgenerator.py"
LIMITS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX}
MIDDLE = (puma560.QMIN + puma560.QMAX) / 2


def joints(place=MIDDLE, **local):
    bench = Bench(JOINTS, frequency=250, constants=LIMITS, local={"DELAY": 0.1, **local}).init()
    bench["Q_MEZ"] = place
    return bench.on()


def test_one_joint_moves_about_where_the_arm_is_and_the_others_stay():
    bench = joints(JOINT=2, AMPLITUDE=0.1, FREQUENCY=1)
    courses = np.array([bench.cycle()["Q_REF"].copy() for _ in range(300)])
    assert courses[0] == pytest.approx(MIDDLE)
    assert np.ptp(courses, axis=0) == pytest.approx([0, 0, 0.2, 0, 0, 0], abs=1e-4)


@pytest.mark.parametrize("wave", ["sine", "triangle", "sweep"])
def test_the_reference_speed_is_that_of_the_reference(wave):
    bench = joints(WAVE=wave, AMPLITUDE=0.1, FREQUENCY=0.5, END=2, LASTS=3)
    places, speeds = [], []
    for _ in range(700):
        bench.cycle()
        places.append(bench["Q_REF"][0])
        speeds.append(bench["Q^_REF"][0])
    measured = np.gradient(places, 1 / 250)
    smooth = np.abs(np.diff(speeds, prepend=0.0)) < 0.05  # but at the corners of a triangle, and where it begins
    assert smooth.sum() > 650
    assert np.abs(measured - speeds)[smooth][1:-1].max() < 0.25


@pytest.mark.parametrize(
    ("place", "local", "sentence"),
    [
        (puma560.QMAX - 0.01, {"AMPLITUDE": 0.1}, "may go to"),
        (puma560.QMIN, {"WAVE": "step", "AMPLITUDE": -0.1}, "may go to"),
        (MIDDLE, {"AMPLITUDE": 0.5, "FREQUENCY": 20}, "may move at"),
        (MIDDLE, {"WAVE": "sweep", "AMPLITUDE": 0.5, "END": 20}, "may move at"),
    ],
)
def test_a_motion_beyond_the_limits_of_the_joint_is_refused_before_it_begins(place, local, sentence):
    bench = joints(place, **local)
    assert bench.state is not State.ON
    assert sentence in bench.why


def test_a_step_from_a_limit_inwards_is_allowed():
    assert joints(puma560.QMIN, WAVE="step", AMPLITUDE=0.1).cycle(60)["Q_REF"][0] == pytest.approx(
        puma560.QMIN[0] + 0.1
    )


def test_a_joint_that_the_arm_has_not_is_refused():
    bench = Bench(JOINTS, frequency=250, constants=LIMITS, local={"JOINT": 6}).init()
    assert bench.state is State.ERROR
    assert "expected 0..5, found 6" in bench.why
