"""The constants of chains: the product of exponentials of SCREW says where the tool is (R-X19, R-K03)."""

import mujoco
import numpy as np
import pytest

from kit.worlds.file_cells import ARM
from onika.laws.frames import inverse_pose, rotation_exp
from onika.workcell.composed import chain


@pytest.fixture
def model():
    return mujoco.MjModel.from_xml_string(ARM)


@pytest.fixture
def arm(model):
    joints = chain.joints_between(model, None, int(model.body("quill").id))
    return chain.chain(model, joints, int(model.body("foot").id))


def pose_by_screws(screws, q, tool):
    pose = np.eye(4)
    for screw, value in zip(screws, q, strict=True):
        w, v = screw[:3], screw[3:]
        step = np.eye(4)
        step[:3, :3] = rotation_exp(w * value)
        step[:3, 3] = (np.eye(3) - step[:3, :3]) @ np.cross(w, v) if w.any() else v * value
        pose = pose @ step
    return pose @ tool


def test_screws_say_where_the_tool_is(model, arm):  # R-X19
    data, site = chain.at_zero(model, arm.joints), int(model.site("tip").id)
    to_base = inverse_pose(chain.body_pose(data, arm.start))
    tool = to_base @ chain.site_pose(data, site)
    for q in np.random.default_rng(1).uniform(-1, 1, (20, 3)) * (3, 2, 0.1):
        data.qpos[:3] = q
        mujoco.mj_kinematics(model, data)
        assert pose_by_screws(arm.screw, q, tool) == pytest.approx(to_base @ chain.site_pose(data, site), abs=1e-12)


def test_links_weigh_what_the_model_weighs(model, arm):
    moved = [model.body(name).mass[0] for name in ("upper", "lower", "quill", "finger1", "finger2")]
    assert arm.link[:, 0].sum() == pytest.approx(sum(moved))
    assert arm.link[2, 0] == pytest.approx(sum(moved[2:]))
    assert arm.link[:, 10].tolist() == [0.02, 0.02, 0.1]
    assert arm.parent.tolist() == [-1.0, 0.0, 1.0]


def test_the_torques_against_gravity_follow_from_the_links(model, arm):  # R-X19
    data = mujoco.MjData(model)
    data.qpos[:3] = 0.3, 0.4, 0.02
    mujoco.mj_forward(model, data)
    shifted = mujoco.MjData(model)
    weights = []
    for k in range(3):
        energies = []
        for step in (-1e-6, 1e-6):
            shifted.qpos[:] = data.qpos
            shifted.qpos[k] += step
            energies.append(_energy(arm, shifted.qpos[:3]))
        weights.append((energies[1] - energies[0]) / 2e-6)
    assert weights == pytest.approx(data.qfrc_bias[:3], abs=1e-5)


def _energy(arm, q):
    energy = 0.0
    for k in range(3):
        at = np.eye(4)
        at[:3, 3] = arm.link[k, 1:4]
        energy += 9.81 * arm.link[k, 0] * pose_by_screws(arm.screw[: k + 1], q[: k + 1], at)[2, 3]
    return energy


def test_a_ball_joint_is_no_joint_of_a_chain():
    text = '<mujoco><worldbody><body name="b"><joint name="j" type="ball"/><geom size="1"/></body></worldbody></mujoco>'
    model = mujoco.MjModel.from_xml_string(text)
    with pytest.raises(ValueError, match="j"):
        chain.joints_between(model, None, 1)
