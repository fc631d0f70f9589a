"""Further paths of joints: ramped, of limited jerk, one joint alone, by polynomials; taught and played."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.paths.taught_path import path_text
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "motions" / "module"
CONSTANTS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX}
HOME = np.array(puma560.HOME)
ASIDE = HOME + np.array([0.5, -0.2, 0.3, 0.1, -0.4, 0.2])
STILL = [0.0] * 6
MAX = np.array(puma560.QDMAX)


def words(*numbers):
    return " ".join(str(number) for part in numbers for number in np.ravel(part))


def swing(size):
    """Coefficients of an arm that leaves HOME in each joint by `size` and comes back."""
    return np.array([[home, 0.0, 16 * away, -32 * away, 16 * away, 0.0] for home, away in zip(HOME, size, strict=True)])


@pytest.fixture
def taught(tmp_path):
    times = np.linspace(0.0, 2.0, 41)
    rows = HOME + np.outer(np.sin(np.pi * times / 2) ** 2, [0.3, 0.0, -0.2, 0.0, 0.0, 0.1])
    path = tmp_path / "way.csv"
    path.write_text(path_text(times, rows))
    return path


LINES = {
    "jramp": words(ASIDE, 2),
    "jruckig": words(ASIDE, 2),
    "jdrive": words(2, HOME[1] + 0.4, 2),
    "jpath": words(swing([0.2, 0.1, -0.1, 0.0, 0.3, 0.0]), 2),
    "jpoly": words(3, [0, 1.2, -0.8, 0, 0], 2),
}
ENDS = {
    "jramp": ASIDE,
    "jruckig": ASIDE,
    "jdrive": HOME + np.array([0, 0.4, 0, 0, 0, 0]),
    "jpath": HOME,
    "jpoly": HOME + np.array([0, 0, 0.4, 0, 0, 0]),
}


def bench_of(name, start=HOME, hz=250, **local):
    bench = Bench(MODULES / f"{name}.py", frequency=hz, constants=CONSTANTS, local=local).init()
    bench["Q_MEZ"] = start
    return bench


def follow(bench, count=10_000):
    """The arm follows exactly; gives the references and their speeds, cycle by cycle."""
    path, speeds = [bench["Q_REF"].copy()], [bench["Q^_REF"].copy()]
    while bench.state is State.ON and len(path) < count:
        bench["Q_MEZ"] = bench["Q_REF"]
        bench.cycle()
        path.append(bench["Q_REF"].copy())
        speeds.append(bench["Q^_REF"].copy())
    return np.array(path), np.array(speeds)


@pytest.mark.parametrize("name", LINES)
def test_a_motion_begins_where_the_arm_is_ends_at_its_target_and_takes_its_time(name):  # R-K08
    bench = bench_of(name)
    path, speeds = follow(bench.on(LINES[name]))
    assert path[0] == pytest.approx(HOME)
    assert path[-1] == pytest.approx(ENDS[name], abs=1e-6)
    assert speeds[-1] == pytest.approx(STILL, abs=1e-6)
    assert bench.cycles == pytest.approx(500, abs=2)
    assert (bench.finished.flow, bench.warnings) == (0, [])


@pytest.mark.parametrize("name", LINES)
def test_the_speed_that_is_told_is_that_of_the_reference(name):  # R-K08
    path, speeds = follow(bench_of(name, hz=1000).on(LINES[name]))
    middle = (path[2:] - path[:-2]) * 500.0
    assert np.abs(middle - speeds[1:-1])[:1990].max() < 5e-3


@pytest.mark.parametrize("name", LINES)
def test_a_motion_that_is_too_quick_is_lengthened_with_a_warning(name):  # R-K08
    bench = bench_of(name, SPEED=0.1)
    _, speeds = follow(bench.on(LINES[name].rpartition(" ")[0] + " 0.1"))
    assert "0.1 s is too short" in bench.warnings[0]
    assert (np.abs(speeds) / MAX).max() == pytest.approx(0.1, rel=0.01)


@pytest.mark.parametrize("name", LINES)
def test_a_reference_in_force_is_where_it_starts_and_a_stale_one_is_not(name):  # law 3
    bench = bench_of(name)
    bench["Q_REF"] = HOME + 0.002
    assert bench.on(LINES[name])["Q_REF"] == pytest.approx(HOME + 0.002)
    bench.off()["Q_REF"] = ASIDE
    assert bench.forget("Q_REF").on(LINES[name])["Q_REF"] == pytest.approx(HOME)


@pytest.mark.parametrize("name", LINES)
@pytest.mark.parametrize(("short_by", "is_blocked"), [(0.049, False), (0.051, True)])
def test_it_waits_for_the_arm_but_not_for_ever_and_one_that_is_blocked_is_an_error(name, short_by, is_blocked):  # R-X06
    bench = bench_of(name, SETTLE=0.2).on(LINES[name])
    bench["Q_MEZ"] = ENDS[name] + short_by * np.eye(6)[2]
    bench.cycle(10_000)
    assert bench.now == pytest.approx(2.2, abs=0.01)
    assert (bench.finished is None, bench.state is State.ERROR) == (is_blocked, is_blocked)
    assert not is_blocked or "the arm did not come to its target: joint 3 is 0.05 rad" in bench.why


@pytest.mark.parametrize("name", LINES)
def test_its_progress_can_be_asked_for(name):  # R-A05
    assert bench_of(name).on(LINES[name]).cycle(250).get("progress") == pytest.approx(0.5, abs=0.01)


def test_a_ramped_path_is_slower_at_its_peak_than_one_of_fifth_order():  # R-K05
    _, speeds = follow(bench_of("jramp", RAMP=0.25).on(LINES["jramp"]))
    assert speeds.max(axis=0)[0] == pytest.approx(0.5 / 2 / 0.75, rel=1e-3)  # 1.875 / 2 of the way for the fifth order


def test_a_path_of_limited_jerk_tells_its_acceleration_too():  # R-K05
    bench = bench_of("jruckig", hz=1000).on(LINES["jruckig"])
    speeds, accelerations = [], []
    for _ in range(1500):
        bench.cycle()
        speeds.append(bench["Q^_REF"].copy())
        accelerations.append(bench["Q^^_REF"].copy())
    assert np.gradient(speeds, 0.001, axis=0)[5:-5] == pytest.approx(np.array(accelerations)[5:-5], abs=0.05)


def test_one_joint_moves_and_no_other():  # R-K08
    for name, joint in (("jdrive", 1), ("jpoly", 2)):
        path, _ = follow(bench_of(name).on(LINES[name]))
        assert [int(k) for k in np.flatnonzero(np.ptp(path, axis=0) > 1e-9)] == [joint]


@pytest.mark.parametrize(
    ("name", "line", "why"),
    [
        ("jdrive", "2 3.2 1", "joint 2 would stand at 3.200 rad, beyond"),
        ("jdrive", "7 0 1", "expected 1..6"),
        ("jdrive", "0 0 1", "expected 1..6"),
        ("jpoly", "1 1 0 0 0 0 1", "that of joint 1 has a slope of 1 there"),
        ("jpoly", "1 0 30 -20 0 0 9", "joint 1 would stand at 10.000 rad, beyond"),
        ("jpath", words(swing([4.0, 0, 0, 0, 0, 0]), 9), "joint 1 would stand at 4.000 rad, beyond"),
        ("jramp", words(HOME + 9.0, 1), "endpoint[0]"),
    ],
)
def test_what_the_arm_cannot_do_is_asked_for_again(name, line, why):  # R-A10
    bench = bench_of(name).on(line)
    assert bench.state is State.ASKING
    assert why in str(bench.asked.reason)


def test_an_arm_that_stands_elsewhere_first_goes_to_where_the_polynomials_begin():  # R-K08
    bench = bench_of("jpath", start=ASIDE)
    path, speeds = follow(bench.on(LINES["jpath"]))
    assert path[0] == pytest.approx(ASIDE)
    assert np.abs(path - HOME).max(axis=1)[-500] == pytest.approx(0.0, abs=1e-3)  # 2 s before its end
    assert (np.abs(speeds) <= 0.6 * MAX + 1e-9).all()


def test_a_taught_path_is_played_from_where_the_arm_is(taught):  # R-B10
    bench = bench_of("jplay", start=ASIDE)
    path, speeds = follow(bench.on(str(taught)))
    played = path[-501:]
    assert path[0] == pytest.approx(ASIDE)
    assert played[0] == pytest.approx(HOME, abs=1e-3)
    assert played[250] == pytest.approx(HOME + np.array([0.3, 0, -0.2, 0, 0, 0.1]), abs=1e-3)
    assert (np.abs(speeds) <= 0.6 * MAX + 1e-9).all()
    assert bench.finished is not None


def test_an_arm_that_is_blocked_on_a_taught_path_is_an_error(taught):  # R-X06
    bench = bench_of("jplay").on(str(taught))
    bench["Q_MEZ"] = HOME + 0.2
    bench.cycle(10_000)
    assert (bench.state, bench.finished) == (State.ERROR, None)
    assert "the arm did not come to its target" in bench.why


def test_a_path_that_was_taught_too_fast_is_played_more_slowly_with_a_warning(taught):
    bench = bench_of("jplay", SPEED=0.01)
    _, speeds = follow(bench.on(str(taught)), 40_000)
    assert "taught too fast" in bench.warnings[0]
    assert (np.abs(speeds) <= 0.01 * MAX * 1.001).all()


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (None, "No such file or directory"),
        ("t,q1\n0,1\n1,2\n", "line 2: expected a time and 6 joint positions"),
        ("t\n0,9,0,0,0,0,0\n1,9,0,0,0,0,0\n", "joint 1 would stand at 9.000 rad"),
    ],
)
def test_a_file_that_is_no_path_of_this_arm_is_asked_for_again(tmp_path, text, why):  # R-A10
    path = tmp_path / "way.csv"
    if text is not None:
        path.write_text(text)
    bench = bench_of("jplay").on(str(path))
    assert bench.state is State.ASKING
    assert why in str(bench.asked.reason)


def test_what_is_taught_until_the_button_is_pressed_can_be_played(tmp_path):  # R-B10, R-K07
    path = tmp_path / "led.csv"
    teacher = Bench(MODULES / "teach.py", frequency=50, constants=CONSTANTS).init()
    teacher["Q_MEZ"] = HOME
    teacher.on(str(path))
    for k in range(1, 126):
        teacher["Q_MEZ"] = HOME + 0.2 * np.sin(np.pi * min(k, 100) / 200) ** 2
        teacher["BUTTONS"] = int(k > 100)
        teacher.cycle()
    assert (teacher.state, teacher.finished.flow, teacher.get("rows")) == (State.OFF, 0, 126)
    played, _ = follow(bench_of("jplay").on(str(path)))
    assert played[125 * 2] == pytest.approx(HOME + 0.1, abs=1e-3)
    assert played[-1] == pytest.approx(HOME + 0.2, abs=1e-6)


def test_teaching_ends_after_a_while_by_itself(tmp_path):
    teacher = Bench(MODULES / "teach.py", frequency=50, constants=CONSTANTS, local={"MOST": 0.5}).init()
    teacher.on(str(tmp_path / "led.csv")).cycle(1000)
    assert (teacher.cycles, teacher.finished.flow) == (25, 0)


def test_a_path_that_cannot_be_written_is_an_error(tmp_path):
    teacher = Bench(MODULES / "teach.py", frequency=50, constants=CONSTANTS).init()
    teacher.on(str(tmp_path / "nowhere" / "led.csv")).cycle()
    teacher["BUTTONS"] = 1
    teacher.cycle(25)
    assert (teacher.state, teacher.finished) == (State.ERROR, None)
    assert "cannot be written: No such file or directory" in teacher.why
