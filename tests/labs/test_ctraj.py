"""The straight line of the tool."""

import numpy as np
import pytest

from onika.laws.frames import pose_of_nine
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "ctraj.py"
ABOVE = [0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.125]
GRASP = [0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.3346]


def ctraj(**local):
    bench = Bench(CODE, frequency=250, local=local).init()
    bench["X_MEZ"] = pose_of_nine(ABOVE)
    return bench


def line(nine, duration):
    return " ".join(map(str, [*nine, duration]))


def follow(bench):
    path = [bench["X_REF"]]
    while bench.state is State.ON:
        bench["X_MEZ"] = bench["X_REF"]
        bench.cycle()
        path.append(bench["X_REF"])
    return np.array(path)


def test_the_tool_goes_straight_down_and_stops_there():
    bench = ctraj()
    path = follow(bench.on(line(GRASP, 1.4)))
    assert path[0] == pytest.approx(pose_of_nine(ABOVE))
    assert path[-1] == pytest.approx(pose_of_nine(GRASP))
    assert np.ptp(path[:, 0, 3]) == np.ptp(path[:, 1, 3]) == 0.0
    assert (np.diff(path[:, 2, 3]) <= 0.0).all()
    assert bench.cycles == pytest.approx(350, abs=2)
    assert bench.warnings == []


def test_every_pose_on_the_way_is_a_pose():
    turned = [0, -0.6, -0.8, 1, 0, 0, 0.5, 0.1, -0.2]
    for pose in follow(ctraj().on(line(turned, 3)))[::20]:
        assert pose[:3, :3] @ pose[:3, :3].T == pytest.approx(np.eye(3), abs=1e-9)


def test_peak_speeds_lengthen_a_motion_with_a_warning():
    bench = ctraj(SPEED=0.1)
    path = follow(bench.on(line(GRASP, 0.5)))
    assert "0.5 s is too short" in bench.warnings[0]
    assert np.abs(np.diff(path[:, 2, 3])).max() * 250 == pytest.approx(0.1, abs=1e-3)


def test_a_reference_in_force_is_where_the_line_starts():  # law 3
    bench = ctraj()
    bench["X_REF"] = pose_of_nine(GRASP)
    bench.on(line(ABOVE, 1.4))
    assert bench["X_REF"] == pytest.approx(pose_of_nine(GRASP))
    bench.off().forget("X_REF").on(line(ABOVE, 1.4))
    assert bench["X_REF"] == pytest.approx(pose_of_nine(ABOVE))


def test_nine_numbers_that_are_no_pose_are_asked_for_again():  # R-A10
    bench = ctraj().on(line([0, 0, -2, 0, 1, 0, 0.7, 0, 0], 1))
    assert bench.state is State.ASKING
    assert "expected approach as a vector of length 1" in bench.asked.reason
    assert bench.answer(line(GRASP, 1.4)).state is State.ON


@pytest.mark.parametrize(("short_by", "is_blocked"), [(0.019, False), (0.021, True)])
def test_it_waits_for_the_tool_but_not_for_ever_and_one_that_is_blocked_is_an_error(short_by, is_blocked):  # R-X06
    bench = ctraj(SETTLE=0.3).on(line(GRASP, 1.4))
    bench["X_MEZ"] = pose_of_nine([*GRASP[:8], GRASP[8] + short_by])
    bench.cycle(10_000)
    assert (bench.finished is None) == is_blocked
    assert bench.state is (State.ERROR if is_blocked else State.OFF)
    assert not is_blocked or "the hand did not come to its target: it stands 2.1 cm away" in bench.why
    assert bench.now == pytest.approx(1.7, abs=0.01)


def test_its_progress_can_be_asked_for():
    assert ctraj().on(line(GRASP, 2)).cycle(125).get("progress") == pytest.approx(0.25)
