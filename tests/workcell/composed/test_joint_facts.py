"""What is known of joints; what cannot be is told with its line."""

from dataclasses import replace

import mujoco
import pytest

from kit.worlds.file_cells import ARM
from onika.model.robot import RobotArm, RobotAxes
from onika.workcell.composed.joint_facts import JointFacts, Unfit, arm_facts, axes_facts, shared

ELBOW = RobotArm("arm", "tip")


@pytest.fixture
def model():
    return mujoco.MjModel.from_xml_string(ARM)


def test_an_arm_says_all_of_itself_in_flat_rows(model):  # R-X19
    facts = arm_facts(model, ELBOW, "elbow", {"turn": 1.5})
    assert (facts.joints, facts.actuators, facts.start) == (("turn", "bend", "lift"),) * 2 + ("foot",)
    lengths = {name: len(row) for name, row in facts.constants.items() if not isinstance(row, str)}
    assert lengths == {
        "SCREW": 18,
        "LINK": 39,
        "PARENT": 3,
        "TOOL": 16,
        "QMIN": 3,
        "QMAX": 3,
        "Q^_MAX": 3,
        "TAUMAX": 3,
        "HOME": 3,
        "NDOF": 1,
    }
    assert facts.constants["Q^_MAX"] == (1.5, 2.0, 0.5)
    assert facts.constants["TAUMAX"] == (40.0, 40.0, 200.0)
    assert (facts.constants["ROBOT"], facts.constants["DRIVE"]) == ("elbow", "position")


def test_the_tool_approaches_and_has_fingers_as_its_file_says(model):  # R-X19
    tool = arm_facts(model, replace(ELBOW, offset=(0.0, 0.0, 0.1)), "elbow", {}).constants["TOOL"]
    plain = arm_facts(model, ELBOW, "elbow", {}).constants["TOOL"]
    assert tool[11] == pytest.approx(plain[11] - 0.1)
    turned = arm_facts(model, replace(ELBOW, approach="x", fingers="z"), "elbow", {}).constants["TOOL"]
    assert [turned[k] for k in (2, 6, 10)] == pytest.approx([plain[k] for k in (0, 4, 8)])


def test_a_chain_may_begin_above_the_first_joint(model):
    facts = arm_facts(model, replace(ELBOW, start="upper"), "elbow", {})
    assert facts.joints == ("bend", "lift")


@pytest.mark.parametrize(
    ("arm", "keyword", "key"),
    [
        (replace(ELBOW, tool="top"), "TOOL", "workcell.no_such_name"),
        (replace(ELBOW, start="top"), "FROM", "workcell.no_such_name"),
        (replace(ELBOW, tool="foot"), "TOOL", "workcell.no_joints"),
        (replace(ELBOW, tool="finger1"), "TOOL", "workcell.no_actuator"),
        (replace(ELBOW, home=(0.0, 0.0)), "HOME", "workcell.joint_count"),
        (replace(ELBOW, home=(0.0, 9.0, 0.0)), "HOME", "workcell.home_outside"),
        (replace(ELBOW, speed=(1.0,)), "SPEED", "workcell.joint_count"),
    ],
)
def test_what_is_not_in_the_model_is_told_with_its_line(model, arm, keyword, key):  # R-B07, R-X19
    model.actuator_trnid[3, 0] = 0  # nothing moves the fingers
    unfit = arm_facts(model, arm, "elbow", {})
    assert isinstance(unfit, Unfit)
    assert (unfit.keyword, unfit.reason.key) == (keyword, key)


def test_axes_are_the_joints_of_their_actuators(model):
    facts = axes_facts(model, RobotAxes("lift", ("lift",)), "elbow", {})
    assert (facts.joints, facts.start, facts.constants["NDOF"]) == (("lift",), "", (1.0,))
    assert axes_facts(model, RobotAxes("lift", ("up",)), "elbow", {}).reason.key == "workcell.no_such_name"


def test_a_joint_in_two_devices_is_told(model):  # R-X19
    arm, axes = arm_facts(model, ELBOW, "r", {}), axes_facts(model, RobotAxes("lift", ("lift",)), "r", {})
    assert isinstance(arm, JointFacts)
    assert shared([arm], axes).reason.args["joint"] == "lift"
    assert shared([], axes) is None


def test_a_heavy_robot_without_limits_gets_torques_that_move_it():  # R-X19
    free = ARM.replace(' ctrlrange="-40 40"', "").replace(' ctrlrange="-200 200"', "")
    light = arm_facts(mujoco.MjModel.from_xml_string(free), ELBOW, "elbow", {})
    heavy = arm_facts(mujoco.MjModel.from_xml_string(free.replace('mass="1"', 'mass="3000"')), ELBOW, "elbow", {})
    assert light.torque.tolist() == [1000.0] * 3
    assert heavy.torque[1] > 3000 * 9.81 * 0.09 and heavy.torque[2] == 1000.0
