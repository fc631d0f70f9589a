"""A jaw that closes on one which does not move: what is drafted of it takes a thing, with forces and without."""

import math

import mujoco
import numpy as np
import pytest

from kit.worlds.file_cells import ARM
from kit.worlds.grasping_cells import AT_CUBE, TOP, Cell, files_with, one_jaw
from onika.files import robot as robot_file
from onika.wire.world_source import WorldFile, WorldSource
from onika.workcell.drafting.draft import draft
from onika.workcell.drafting.draft_chain import draft_chain
from onika.workcell.drafting.draft_gripper import draft_hand

MOTOR = '<motor name="squeeze" joint="jaw" ctrlrange="-1 1"/>'
LONG_M, GAP_M = 0.08, 0.002  # of the jaw, and between both where it is closed


def hand_of(model):
    compiled = mujoco.MjModel.from_xml_string(model)
    chain = draft_chain(compiled)
    return draft_hand(compiled, chain, np.zeros(len(chain.joints)))


def drafted(model):
    files = WorldSource("elbow", "", (WorldFile("robot/elbow.xml", "/lab/elbow.xml", model.encode()),))
    return draft(files, "elbow", "elbow.xml").text


def test_a_jaw_opens_as_far_as_it_faces_the_other_one_and_its_tip_is_measured():  # R-X19
    hand = hand_of(one_jaw())
    assert hand.origin.key == "workcell.draft_width_jaw"
    chord = 2.0 * LONG_M * math.sin(0.5)
    assert hand.device.closed == (0.0, pytest.approx(GAP_M, abs=1e-3))
    assert hand.device.open == (pytest.approx(1.0, abs=0.02), pytest.approx(chord + GAP_M, abs=3e-3))


def test_a_jaw_that_is_pulled_by_a_motor_opens_to_its_end():  # R-X19
    hand = hand_of(one_jaw(MOTOR))
    assert (hand.device.closed[0], hand.device.open[0]) == (-1.0, 1.0)
    assert hand.device.open[1] == pytest.approx(2.0 * LONG_M * math.sin(0.95) + GAP_M, abs=5e-3)


def test_the_tool_is_between_both_and_the_fingers_lie_across():  # R-X19
    robot, faults = robot_file.read(drafted(one_jaw()), "elbow", "elbow.robot")
    arm, _ = robot.devices
    assert (faults, arm.tool, arm.fingers) == ((), "tip", "y")
    across, above = -arm.offset[1], -0.1 - arm.offset[2]  # the site is turned about x by half a turn
    assert -0.022 < across < 0.03 and above == pytest.approx(-0.095, abs=0.01)


def test_a_jaw_that_slides_is_measured_by_its_way():  # R-X19
    slides = one_jaw().replace('axis="1 0 0" range="0 1.9"', 'type="slide" axis="0 1 0" range="0 0.05"')
    hand = hand_of(slides.replace('kp="10" ctrlrange="0 1.9"', 'kp="400" ctrlrange="0 0.05"'))
    assert hand.device.open == (0.05, pytest.approx(0.05 + GAP_M, abs=2e-3))
    assert hand.device.closed[1] == pytest.approx(GAP_M, abs=1e-3)


def test_a_hand_of_two_fingers_has_no_jaw():  # R-X19
    assert hand_of(ARM).jaw is None


@pytest.mark.parametrize("has_forces", [True, False])
def test_what_is_drafted_of_a_jaw_takes_a_cube_and_lets_it_go(has_forces):  # R-X19, R-K05
    cell = Cell(has_forces=has_forces, files=files_with(drafted(one_jaw()), one_jaw()))
    cell.opening = 0.075
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    assert cell.world.state("gripper_left")[2] == pytest.approx(0.04, abs=0.012)
    cell.go(0.0, 0.0, 0.0)
    assert cell.place("cube")[2] > TOP + 0.09
    cell.grip(0.075)
    cell.tick(300)
    assert cell.place("cube")[2] == pytest.approx(TOP + 0.02, abs=2e-3)
