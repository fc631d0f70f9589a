import mujoco
import numpy as np
import pytest

from kit.worlds.file_cells import ARM
from kit.worlds.robot_models import PLAIN
from onika.model.robot import RobotAxes
from onika.workcell.drafting.draft_chain import draft_chain
from onika.workcell.drafting.draft_gripper import draft_hand


def hand_of(text):
    model = mujoco.MjModel.from_xml_string(text)
    chain = draft_chain(model)
    return draft_hand(model, chain, np.zeros(len(chain.joints)))


def test_fingers_are_tried_out_and_the_wider_signal_opens():  # R-X19
    gripper = hand_of(ARM).device
    assert gripper.open == (0.03, pytest.approx(0.076, abs=1e-3))
    assert gripper.closed == (0.0, pytest.approx(0.016, abs=1e-3))


def test_a_width_that_cannot_be_seen_is_guessed_and_that_is_told():  # R-X19
    hand = hand_of(ARM.replace('kp="400"', 'kp="1e-9"'))
    assert hand.origin.key == "workcell.draft_width_guessed"
    assert (hand.device.open[1], hand.device.closed[1]) == (0.05, 0.0)


def test_an_arm_with_nothing_behind_it_has_no_hand():  # R-X19
    motors = '<actuator><motor joint="turn"/><motor joint="bend"/></actuator></mujoco>'
    assert hand_of(PLAIN.replace("</mujoco>", motors)).device is None


def test_more_actuators_than_a_gripper_has_are_the_axes_of_a_hand():  # R-X19
    more = '<motor name="a" joint="finger1"/><motor name="b" joint="finger2"/></actuator>'
    hand = hand_of(ARM.replace("</actuator>", more))
    assert hand.device == RobotAxes("fingers", ("squeeze", "a", "b"))
