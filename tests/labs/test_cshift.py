"""The straight line of the tool from where it is."""

import numpy as np
import pytest

from onika.laws.frames import pose_of_nine
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "cshift.py"
HERE = pose_of_nine([0, -0.6, -0.8, 1, 0, 0, 0.5, 0.1, -0.2])
UP = "0 0 0.1 1"


def cshift(**local):
    bench = Bench(CODE, frequency=250, local=local).init()
    bench["X_MEZ"] = HERE
    return bench


def follow(bench):
    path = [bench["X_REF"]]
    while bench.state is State.ON:
        bench["X_MEZ"] = bench["X_REF"]
        bench.cycle()
        path.append(bench["X_REF"])
    return np.array(path)


def test_the_tool_goes_on_by_so_much_and_points_where_it_pointed():  # R-D25
    bench = cshift()
    path = follow(bench.on("0.03 -0.02 0.1 1"))
    assert path[0] == pytest.approx(HERE)
    assert path[-1][:3, 3] - HERE[:3, 3] == pytest.approx([0.03, -0.02, 0.1])
    assert path[:, :3, :3] == pytest.approx(np.broadcast_to(HERE[:3, :3], (len(path), 3, 3)))
    assert bench.cycles == pytest.approx(250, abs=2)
    assert bench.warnings == []


def test_twice_is_twice_as_far():  # R-D25
    bench = cshift()
    follow(bench.on(UP))
    assert follow(bench.on(UP))[-1][2, 3] - HERE[2, 3] == pytest.approx(0.2)


def test_a_reference_in_force_is_where_it_starts():  # law 3, R-D25
    bench = cshift()
    bench["X_REF"] = pose_of_nine([0, 0, -1, 0, 1, 0, 0.7, 0.28, 0.0])
    assert follow(bench.on(UP))[-1][:3, 3] == pytest.approx([0.7, 0.28, 0.1])


def test_the_peak_speed_lengthens_a_motion_with_a_warning():
    bench = cshift(SPEED=0.1)
    path = follow(bench.on("0 0 0.1 0.5"))
    assert "0.5 s is too short" in bench.warnings[0]
    assert np.abs(np.diff(path[:, 2, 3])).max() * 250 == pytest.approx(0.1, abs=1e-3)


def test_where_the_arm_does_not_follow_it_waits_for_a_while_only():
    bench = cshift(SETTLE=0.5).on(UP)
    cycles = 0
    while bench.state is State.ON:
        bench.cycle()
        cycles += 1
    assert cycles == pytest.approx(375, abs=2)


def test_it_says_how_far_it_is():
    bench = cshift().on(UP)
    for _ in range(125):
        bench.cycle()
    assert bench.get("progress") == pytest.approx(0.5)


def test_further_than_any_arm_reaches_is_asked_for_again():  # R-A10
    assert cshift().on("0 0 9 1").state is State.ASKING


def test_a_hand_that_is_blocked_is_an_error():  # R-X06
    bench = cshift(SETTLE=0.3).on(UP).cycle(1000)
    assert bench.state is State.ERROR
    assert "the hand did not come to its target: it stands 10.0 cm away" in bench.why
