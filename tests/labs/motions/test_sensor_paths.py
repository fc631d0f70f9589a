"""Paths of the tool by what a sensor measures: until a bound is passed, and so that a value stays."""

import numpy as np
import pytest

from onika.laws.frames import pose_of_nine
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "motions" / "module"
DOWN = "0 0 -1 0 1 0"
START = pose_of_nine([0, 0, -1, 0, 1, 0, 0.5, 0.1, 0.3])


def bench_of(name, **local):
    bench = Bench(MODULES / f"{name}.py", frequency=250, local=local).init()
    if bench.state is not State.ERROR:
        bench["X_MEZ"] = START
    return bench


def follow(bench, sense):
    """Until it is done: the path of the tool, whose sensor says what `sense` says of its place."""
    path = [bench["X_REF"].copy()]
    while bench.state is State.ON:
        bench["X_MEZ"] = bench["X_REF"]
        bench["SENSE"] = sense(*bench["X_REF"][:3, 3])
        bench.cycle()
        path.append(bench["X_REF"].copy())
    return np.array(path)


def begun(name, line, first, **local):
    bench = bench_of(name, **local)
    bench["SENSE"] = first
    return bench.on(line)


# ---- until a bound is passed ----


@pytest.mark.parametrize(("side", "sign"), [("below", 1.0), ("above", -1.0)])
def test_a_line_ends_where_the_value_passes_its_bound_on_its_side(side, sign):  # R-K08
    bench = begun("csense", f"{DOWN} 0.5 0.1 0.0 9", sign * 0.3, LEVEL=sign * 0.12, SIDE=side)
    path = follow(bench, lambda _x, _y, z: sign * z)
    assert bench.finished.flow == 1
    assert 0.12 - 0.05 * 0.1 <= path[-1][2, 3] <= 0.12
    ways = np.abs(np.diff(path[:, 2, 3]))
    assert ways.max() * 250 <= 0.051
    assert np.abs(np.diff(ways)).max() * 250 <= 0.05 / 20  # it slows down, it does not jump


def test_a_line_on_which_no_bound_is_passed_ends_at_its_target():  # R-K08
    bench = begun("csense", f"{DOWN} 0.5 0.1 0.2 9", 1.0, LEVEL=0.12)
    path = follow(bench, lambda _x, _y, z: z)
    assert (bench.finished.flow, path[-1][2, 3]) == (0, pytest.approx(0.2))


def test_where_the_bound_is_passed_already_the_tool_stays():  # R-K08
    bench = begun("csense", f"{DOWN} 0.5 0.1 0.0 9", 0.1, LEVEL=0.12)
    path = follow(bench, lambda *_: 0.1)
    assert bench.finished.flow == 1
    assert np.array_equal(path[-1], path[0])


def test_a_line_that_is_blocked_is_an_error_and_a_short_time_is_lengthened():  # R-X06
    bench = begun("csense", f"{DOWN} 0.5 0.1 0.2 1", 1.0, LEVEL=0.12)
    assert "1 s is too short" in bench.warnings[0]
    bench["SENSE"] = 1.0
    bench.cycle(2000)
    assert bench.state is State.ERROR and "did not come to its target" in bench.why
    assert bench_of("csense", LEVEL=0.1, SIDE="beside").state is State.ERROR


@pytest.mark.parametrize("name", ["csense", "cfollow"])
def test_what_is_no_pose_is_asked_for_again_and_progress_is_told(name):  # R-A10
    bench = begun(name, "0 0 -2 0 1 0 0.5 0.1 0.0 9", 1.0, LEVEL=0.12)
    assert bench.state is State.ASKING
    bench = begun(name, f"{DOWN} 0.6 0.1 0.3 8", 0.12 if name == "cfollow" else 1.0, LEVEL=0.12)
    assert bench.cycle(1000).get("progress") == pytest.approx(0.5, abs=0.01)


# ---- so that a value stays ----


def hill(x, _y, z):
    """The distance to a hill of 10 cm that is highest at x = 0.7."""
    return z - 0.1 * np.exp(-(((x - 0.7) / 0.1) ** 2))


def test_the_tool_goes_over_a_hill_at_the_height_that_it_keeps():  # R-K08
    bench = begun("cfollow", f"{DOWN} 0.9 0.1 7.0 9", 0.3, LEVEL=0.3, GAIN=20.0)
    path = follow(bench, hill)
    assert bench.finished.flow == 0
    heights = [hill(*pose[:3, 3]) for pose in path]
    assert np.abs(np.subtract(heights, 0.3)).max() < 0.01
    assert path[:, 2, 3].max() == pytest.approx(0.4, abs=0.01)
    assert path[-1][:3, 3] == pytest.approx([0.9, 0.1, 0.3], abs=0.005)


def test_a_value_that_is_off_at_first_is_come_to_no_faster_than_told():  # R-K08
    bench = begun("cfollow", f"{DOWN} 0.5 0.1 0.0 4", 0.3, LEVEL=0.2, AXIS="0 0 5", GAIN=100.0, RATE=0.05)
    path = follow(bench, lambda _x, _y, z: z)
    assert np.abs(np.diff(path[:, 2, 3])).max() * 250 <= 0.05 + 1e-9
    assert (bench.finished.flow, path[-1][2, 3]) == (0, pytest.approx(0.2, abs=0.005))


def test_a_value_that_does_not_come_is_told_and_one_that_leads_away_is_an_error():  # R-K08, R-X06
    bench = begun("cfollow", f"{DOWN} 0.6 0.1 0.3 2", 0.3, LEVEL=0.3, CLOSE=0.01, SETTLE=0.5, REACH=1.0)
    follow(bench, lambda *_: 0.32)
    assert bench.finished.flow == 1
    bench = begun("cfollow", f"{DOWN} 0.6 0.1 0.3 9", 0.3, LEVEL=0.3, REACH=0.1)
    follow(bench, lambda *_: 9.0)
    assert bench.state is State.ERROR
    assert "led the tool 10." in bench.why


def test_an_axis_without_a_direction_is_refused():  # R-X04
    assert "expected a direction after AXIS" in bench_of("cfollow", LEVEL=0.3, AXIS="0 0 0").why
