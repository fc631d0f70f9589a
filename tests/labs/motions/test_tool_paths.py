"""Further paths of the tool: an arc, and a pose that moves and is tracked."""

import numpy as np
import pytest

from onika.laws.frames import pose_of_nine
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "motions" / "module"
DOWN = "0 0 -1 0 1 0"
START = pose_of_nine([0, 0, -1, 0, 1, 0, 0.5, 0.1, -0.1])
ARC = f"{DOWN} 0.6 0.1 0.0 1.0 {DOWN} 0.7 0.1 -0.1 1.0"
TURNED = pose_of_nine([0, -0.6, -0.8, 1, 0, 0, 0.4, 0.0, 0.0])


def bench_of(name, **local):
    bench = Bench(MODULES / f"{name}.py", frequency=250, local=local).init()
    if name != "orbit":
        bench["X_MEZ"] = START
    return bench


def follow(bench):
    path = [bench["X_REF"].copy()]
    while bench.state is State.ON:
        bench["X_MEZ"] = bench["X_REF"]
        bench.cycle()
        path.append(bench["X_REF"].copy())
    return np.array(path)


def test_an_arc_leads_through_the_place_on_the_way_to_the_target():  # R-K05
    bench = bench_of("carc")
    path = follow(bench.on(ARC))
    assert path[0] == pytest.approx(START)
    assert path[-1][:3, 3] == pytest.approx([0.7, 0.1, -0.1])
    assert np.linalg.norm(path[:, :3, 3] - [0.6, 0.1, -0.1], axis=1) == pytest.approx(np.full(len(path), 0.1))
    assert path[:, 2, 3].max() == pytest.approx(0.0, abs=1e-4)
    assert bench.cycles == pytest.approx(500, abs=2)


def test_the_peak_speed_lengthens_an_arc_with_a_warning():
    bench = bench_of("carc", SPEED=0.1)
    path = follow(bench.on(ARC.replace(" 1.0", " 0.6")))
    assert "1.2 s is too short" in bench.warnings[0]
    steps = np.linalg.norm(np.diff(path[:, :3, 3], axis=0), axis=1)
    assert steps.max() * 250 == pytest.approx(0.1, abs=1e-3)


def test_a_reference_in_force_is_where_an_arc_starts():  # law 3
    bench = bench_of("carc")
    bench["X_REF"] = pose_of_nine([0, 0, -1, 0, 1, 0, 0.5, 0.2, -0.1])
    assert bench.on(ARC)["X_REF"][1, 3] == pytest.approx(0.2)
    assert bench.off().forget("X_REF").on(ARC)["X_REF"] == pytest.approx(START)


@pytest.mark.parametrize(
    ("line", "why"),
    [
        (f"{DOWN} 0.4 0.1 -0.1 1 {DOWN} 0.7 0.1 -0.1 1", "no circle leads from here"),
        (f"0 0 -2 0 1 0 0.6 0.1 0 1 {DOWN} 0.7 0.1 -0.1 1", "expected approach as a vector of length 1"),
    ],
)
def test_what_is_no_arc_is_asked_for_again(line, why):  # R-A10
    bench = bench_of("carc").on(line)
    assert bench.state is State.ASKING
    assert why in str(bench.asked.reason)


@pytest.mark.parametrize(("short_by", "is_blocked"), [(0.019, False), (0.021, True)])
def test_an_arc_waits_for_the_tool_but_not_for_ever_and_one_that_is_blocked_is_an_error(short_by, is_blocked):  # R-X06
    bench = bench_of("carc", SETTLE=0.2).on(ARC).cycle(250)
    assert bench.get("progress") == pytest.approx(0.5)
    bench["X_MEZ"] = pose_of_nine([0, 0, -1, 0, 1, 0, 0.7, 0.1, -0.1 + short_by])
    assert bench.cycle(10_000).now == pytest.approx(2.2, abs=0.01)
    assert (bench.finished is None, bench.state is State.ERROR) == (is_blocked, is_blocked)


def test_a_pose_goes_round_its_middle_once_in_its_time():  # R-K08
    bench = bench_of("orbit", MIDDLE=f"{DOWN} 0.6 0.1 0.2", RADIUS=0.1, ROUND=2).on()
    course = [bench["X_PART"].copy(), *(bench.cycle()["X_PART"].copy() for _ in range(500))]
    places = np.array(course)[:, :3, 3] - [0.6, 0.1, 0.2]
    assert places[[0, 125, 250, 500]] == pytest.approx(
        np.array([[0.1, 0, 0], [0, 0.1, 0], [-0.1, 0, 0], [0.1, 0, 0]]), abs=1e-9
    )
    assert np.linalg.norm(places, axis=1) == pytest.approx(np.full(501, 0.1))
    assert course[77][:3, :3] == pytest.approx(START[:3, :3])


def test_a_middle_that_is_no_pose_is_refused():
    bench = bench_of("orbit", MIDDLE="0 0 -3 0 1 0 0.6 0.1 0.2")
    assert bench.state is State.ERROR
    assert "expected approach as a vector of length 1" in bench.why


def part(k, hz=250):
    """Where a part is that goes round, after so many cycles."""
    angle = 2 * np.pi * k / hz / 4
    pose = TURNED.copy()
    pose[:2, 3] += 0.05 * np.array([np.cos(angle), np.sin(angle)])
    return pose


def track(seconds, follows=True, **local):
    bench = bench_of("track", **local)
    bench["X_PART"] = part(0)
    bench.on(str(seconds))
    path = [bench["X_REF"].copy()]
    while bench.state is State.ON:
        bench["X_PART"] = part(len(path))
        if follows:
            bench["X_MEZ"] = bench["X_REF"]
        bench.cycle()
        path.append(bench["X_REF"].copy())
    return bench, np.array(path)


def test_the_tool_comes_to_a_pose_that_moves_and_stays_with_it():  # R-K08
    bench, path = track(1.0)
    assert path[0] == pytest.approx(START)
    assert path[-1] == pytest.approx(part(len(path) - 1), abs=1e-9)
    assert path[-200] == pytest.approx(part(len(path) - 200), abs=1e-9)
    assert (bench.finished.flow, bench.finished.loop) == (1, False)


def test_it_comes_nearer_no_faster_than_it_may_and_every_pose_is_one():  # R-K08
    _, path = track(0.5, SPEED=0.1, TURN=0.5)
    steps = np.linalg.norm(np.diff(path[:, :3, 3], axis=0), axis=1) * 250
    gap = np.linalg.norm(path[0][:3, 3] - part(0)[:3, 3])
    assert steps.max() <= 0.1 * (gap + 2 * 0.05) / gap + 2 * np.pi * 0.05 / 4
    assert steps[0] < 1e-3  # it begins at rest, though the pose moves
    for pose in path[::25]:
        assert pose[:3, :3] @ pose[:3, :3].T == pytest.approx(np.eye(3), abs=1e-9)


def test_it_stays_beside_the_pose_by_its_offset():
    _, path = track(0.2, OFFSET="0 0 0.1")
    assert path[-1][:3, 3] == pytest.approx(part(len(path) - 1)[:3, 3] + [0, 0, 0.1], abs=1e-9)


def test_a_tool_that_is_not_there_in_the_end_is_told_by_the_flow():  # R-E05
    bench, _ = track(0.2, follows=False)
    assert bench.finished.flow == 0
    assert bench.get("away") > 0.05


def test_a_pose_that_jumps_is_not_followed():  # law 33
    bench = bench_of("track")
    bench["X_PART"] = part(0)
    bench.on("1").cycle(10)
    before = bench["X_REF"].copy()
    bench["X_PART"] = START
    bench.cycle()
    assert bench.state is State.ERROR
    assert "what is tracked moves at" in bench.why
    assert bench["X_REF"] == pytest.approx(before)
