"""The end of a motion."""

import numpy as np
import pytest

from onika.laws.arrival import Arrival

DT = 0.01
END = np.array([1.0, -2.0])


def arrival(settle=0.5):
    return Arrival.of_joints(END, np.zeros(2), settle)


def test_before_its_time_no_motion_is_over_though_it_rests_at_its_end():
    judged = arrival()
    assert not any(judged.is_over(late, END, DT) for late in (-1.0, -0.015, -0.01, -0.001))
    assert judged.is_over(0.0, END, DT)


def test_it_is_over_at_the_second_look_at_what_stands_at_the_end():
    judged = arrival()
    assert not judged.is_over(0.0, END, DT)  # it was elsewhere a moment ago: it may be passing
    assert judged.is_over(DT, END, DT)


@pytest.mark.parametrize("near", [0.0, 0.0009, -0.0009])
def test_as_near_as_a_millirad_is_there(near):
    judged = arrival()
    judged.is_over(-DT, END + near, DT)
    assert judged.is_over(0.0, END + near, DT)


def test_one_element_that_is_not_there_or_moves_keeps_it_from_being_over():
    away, moving = arrival(), arrival()
    there = END + np.array([0.0, 0.0011])
    assert not any(away.is_over(late, there, DT) for late in (-DT, 0.0, DT, 0.49))
    for k in range(1, 20):
        assert not moving.is_over(k * DT, END + np.array([0.0, 2e-4 * (-1) ** k]), DT)


def test_when_the_time_to_settle_is_over_the_motion_is_over_wherever_it_is():
    judged = arrival(settle=0.2)
    assert not judged.is_over(0.19, np.zeros(2), DT)
    assert judged.is_over(0.2, np.zeros(2), DT)


def test_a_tool_rests_where_a_joint_does_not():
    end = np.eye(4)
    for make, rests in ((Arrival.of_joints, True), (Arrival.of_tool, False)):
        judged = make(end, end, 0.5)
        assert judged.is_over(0.0, end + 5e-5, DT) is rests  # 5 mm/s


def test_who_stands_too_far_from_the_end_is_told():  # R-X06
    judged = arrival()
    assert judged.joint_short(np.add(END, [0.0, 0.05]), 0.06) is None
    short = judged.joint_short(END - [0.01, 0.07], 0.06)
    assert short.startswith("the arm did not come to its target: joint 2 is 0.07 rad")
    pose = np.eye(4)
    judged = Arrival.of_tool(pose, pose, 0.5)
    moved = pose.copy()
    moved[:3, 3] = 0.03, 0.0, 0.04
    assert judged.tool_short(moved, 0.051) is None
    assert judged.tool_short(moved, 0.049) == "the hand did not come to its target: it stands 5.0 cm away from there"
