"""The joint path of fifth order."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from onika.laws import puma560
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "jtraj.py"
CONSTANTS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX}
HOME = puma560.HOME
TARGET = np.array([0.1814, -0.6254, 2.7006, 0.0, 1.0664, 1.7522])


def jtraj(frequency=250.0, **local):
    return Bench(CODE, frequency=frequency, constants=CONSTANTS, local=local).init()


def line(endpoint, duration):
    return " ".join(map(str, [*endpoint, duration]))


def follow(bench, count=10_000):
    """The arm follows exactly; gives the references and their speeds, cycle by cycle."""
    path, speeds = [bench["Q_REF"]], [bench["Q^_REF"]]
    while bench.state is State.ON and bench.cycles < count:
        bench["Q_MEZ"] = bench["Q_REF"]
        bench.cycle()
        path.append(bench["Q_REF"])
        speeds.append(bench["Q^_REF"])
    return np.array(path), np.array(speeds)


postures = st.tuples(*(st.floats(low, high) for low, high in zip(puma560.QMIN, puma560.QMAX, strict=True)))


@settings(max_examples=25, deadline=None)
@given(start=postures, end=postures, duration=st.floats(0.1, 3.0))
def test_every_motion_begins_at_the_start_ends_at_the_target_and_keeps_the_speed_limits(start, end, duration):
    bench = jtraj()
    bench["Q_MEZ"] = start
    path, speeds = follow(bench.on(line(end, duration)))
    assert path[0] == pytest.approx(start)
    assert path[-1] == pytest.approx(end)
    assert speeds[-1] == pytest.approx(np.zeros(6), abs=1e-9)
    assert (np.abs(speeds) <= 0.6 * puma560.QDMAX + 1e-9).all()
    assert bench.finished is not None


def test_the_speed_is_the_derivative_of_the_position():
    bench = jtraj(frequency=1000)
    bench["Q_MEZ"] = HOME
    path, speeds = follow(bench.on(line(TARGET, 3)))
    middle = (path[2:] - path[:-2]) * 500.0
    assert np.abs(middle - speeds[1:-1])[:2990].max() < 1e-4


def test_a_reference_in_force_is_where_the_motion_starts():  # reading 45, law 3
    bench = jtraj()
    bench["Q_MEZ"], bench["Q_REF"] = HOME, HOME + 0.002
    bench.on(line(TARGET, 3))
    assert bench["Q_REF"] == pytest.approx(HOME + 0.002)
    assert bench["Q^_REF"] == pytest.approx(np.zeros(6))


def test_a_reference_from_before_the_last_hold_is_not():  # law 3
    bench = jtraj()
    bench["Q_MEZ"], bench["Q_REF"] = HOME, TARGET
    bench.forget("Q_REF").on(line(TARGET, 3))
    assert bench["Q_REF"] == pytest.approx(HOME)


def test_the_duration_is_that_of_the_input_whatever_the_rate():  # R-A04
    for frequency in (50.0, 250.0, 1000.0):
        bench = jtraj(frequency)
        bench["Q_MEZ"] = HOME
        follow(bench.on(line(TARGET, 3)))
        assert bench.cycles == pytest.approx(3 * frequency, abs=2)


def test_a_motion_that_is_too_quick_is_lengthened_with_a_warning():
    bench = jtraj()
    bench["Q_MEZ"] = HOME
    _, speeds = follow(bench.on(line(TARGET, 0.5)))
    assert "0.5 s is too short" in bench.warnings[0]
    assert (np.abs(speeds) / puma560.QDMAX).max() == pytest.approx(0.6, abs=1e-4)


def test_a_motion_that_is_slow_enough_is_not():
    bench = jtraj(SPEED=0.9)
    bench["Q_MEZ"] = HOME
    follow(bench.on(line(TARGET, 1.6)))
    assert bench.warnings == []


def test_it_waits_until_the_arm_stands_at_the_target():
    bench = jtraj()
    bench["Q_MEZ"] = HOME
    bench.on(line(TARGET, 3)).cycle(770)
    assert bench.state is State.ON  # the arm has not moved
    bench["Q_MEZ"] = TARGET
    assert bench.cycle().state is State.ON  # it moves: it was elsewhere a moment ago
    assert bench.cycle().state is State.OFF


@pytest.mark.parametrize(("short_by", "is_blocked"), [(0.049, False), (0.051, True)])
def test_it_waits_no_longer_than_it_was_told_to_and_an_arm_that_is_blocked_is_an_error(short_by, is_blocked):  # R-X06
    bench = jtraj(SETTLE=0.2)
    bench["Q_MEZ"] = HOME
    bench.on(line(TARGET, 3))
    bench["Q_MEZ"] = TARGET - np.array([0.0, 0.0, short_by, 0.0, 0.0, 0.0])
    bench.cycle(10_000)
    assert (bench.finished is None) == is_blocked
    assert bench.state is (State.ERROR if is_blocked else State.OFF)
    assert not is_blocked or "the arm did not come to its target: joint 3 is 0.05 rad" in bench.why
    assert bench.now == pytest.approx(3.2, abs=0.01)


def test_a_target_beyond_a_limit_is_asked_for_again():  # R-A10, R-C13
    bench = jtraj().on(line([9, 0, 0, 0, 0, 0], 1))
    assert bench.state is State.ASKING
    assert bench.asked.reason == "endpoint[0]: expected -2.79253..2.79253 rad, found 9"


def test_its_progress_can_be_asked_for():
    bench = jtraj()
    bench["Q_MEZ"] = HOME
    bench.on(line(TARGET, 4)).cycle(500)
    assert bench.get("progress") == pytest.approx(0.5)
    with pytest.raises(RuntimeError, match="nothing called"):
        bench.get("regress")
