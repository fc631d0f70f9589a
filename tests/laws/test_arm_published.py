"""Published robots, read from their package as they are: what is derived of them is what their models say (X19)."""

from importlib.util import find_spec
from pathlib import Path

import mujoco
import numpy as np
import pytest

from kit.worlds.mjcf_arms import arm_of_model
from onika.laws.arm import ArmModel
from onika.laws.frames import inverse_pose
from onika.workcell.composed import chain

PACKAGE = find_spec("gymnasium_robotics")
pytestmark = pytest.mark.skipif(PACKAGE is None, reason="needs the robots of the dev extra")
ENVS = Path() if PACKAGE is None or PACKAGE.origin is None else Path(PACKAGE.origin).parent / "envs"

CHAINS = {
    "Fetch": ("assets/fetch/reach.xml", None, "robot0:gripper_link"),
    "Franka": ("assets/kitchen_franka/kitchen_assets/kitchen_env_model.xml", None, "panda0_link7"),
    "pusher": ("mujoco/assets/pusher.xml", None, "tips_arm"),
    "Shadow thumb": ("assets/hand/reach.xml", None, "robot0:thdistal"),
    "Shadow little finger": ("assets/hand/reach.xml", None, "robot0:lfdistal"),
    "Adroit arm and thumb": ("assets/adroit_hand/adroit_door.xml", None, "thdistal"),
    "walker": ("mujoco/assets/walker2d.xml", None, "foot_left"),
    "humanoid arm": ("mujoco/assets/humanoid.xml", "torso", "left_lower_arm"),
    "humanoid leg": ("mujoco/assets/humanoid.xml", "torso", "right_foot"),
}
"""The file of each, the body where its chain begins (the world where none is named), and that of its tool."""

TREES = {
    "Shadow hand": ("assets/hand/reach.xml", "robot0:hand mount", "finger0"),
    "Adroit hand": ("assets/adroit_hand/adroit_door.xml", "table", "S_grasp"),
}


def model_of(file):
    return mujoco.MjModel.from_xml_path(str(ENVS / file))


def postures(model, joints, count):
    """Random ones within limits, half a turn either way where there are none."""
    limited = np.asarray(model.jnt_limited, dtype=bool)[joints]
    low = np.where(limited, model.jnt_range[joints, 0], -np.pi)
    high = np.where(limited, model.jnt_range[joints, 1], np.pi)
    return np.random.default_rng(6).uniform(low, high, (count, len(joints)))


@pytest.mark.parametrize("name", sorted(CHAINS))
def test_the_tool_of_a_published_robot_is_where_its_model_has_it(name):  # R-X19
    file, start, end = CHAINS[name]
    model = model_of(file)
    first, last = (0 if start is None else model.body(start).id), model.body(end).id
    joints = list(chain.joints_between(model, None if start is None else first, last))
    facts, data = chain.chain(model, joints, first), chain.at_zero(model, joints)
    tool = inverse_pose(chain.body_pose(data, first)) @ chain.body_pose(data, last)
    law = ArmModel(facts.screw, facts.link, facts.parent, tool=tool)
    addresses = model.jnt_qposadr[joints]
    for q in postures(model, joints, 100):
        data.qpos[addresses] = q
        mujoco.mj_kinematics(model, data)
        expected = inverse_pose(chain.body_pose(data, first)) @ chain.body_pose(data, last)
        assert np.abs(law.forward(q) - expected).max() < 1e-9


@pytest.mark.parametrize("name", sorted(TREES))
def test_a_published_hand_weighs_what_its_model_says(name):  # R-X19
    file, base, tool = TREES[name]
    arm = arm_of_model(model_of(file), base, tool)
    screw, link, parent, stand = (arm.constants[key] for key in ("SCREW", "LINK", "PARENT", "BASE"))
    law = ArmModel(screw, link, parent, None, stand)
    assert arm.n >= 24 and len(set(parent.tolist())) < arm.n
    for q in postures(arm.model, np.arange(arm.n), 30):
        qd = np.random.default_rng(1).uniform(-2.0, 2.0, arm.n)
        bias, inertia = arm.data_at(q, qd).qfrc_bias, arm.inertia(q)
        assert np.abs(law.bias(q, qd) - bias).max() < 1e-9 * max(1.0, float(np.abs(bias).max()))
        assert np.abs(law.inertia(q) - inertia).max() < 1e-9 * max(1.0, float(np.abs(inertia).max()))
