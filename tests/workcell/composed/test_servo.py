"""The servo within the step."""

import mujoco
import numpy as np
import pytest

from kit.worlds.file_cells import ARM
from onika.workcell.composed.servo import felt_inertia, finger_gains, gains, limit, make_motor, make_servo


def test_gains_are_critical_and_firm_against_friction():  # R-X19
    made = gains(np.array([0.5, 0.001]), np.array([0.0, 0.1]), np.array([0.0, 1.0]), np.zeros(2), np.zeros(2))
    assert made.kp.tolist() == [5000.0, 500.0]
    assert made.kv[0] == pytest.approx(2 * np.sqrt(5000 * 0.5))
    assert made.lead == pytest.approx((made.kv + np.array((0.0, 0.1))) / made.kp)


def test_any_actuator_becomes_a_servo_or_a_motor():
    model = mujoco.MjModel.from_xml_string(ARM)
    data, joints = mujoco.MjData(model), np.array([0, 1, 2])
    felt = felt_inertia(model, data, joints)
    assert (felt > [0.1, 0.05, 0.1]).all()
    limit(model, joints, np.array([1e4, 1e4, 1e4]))
    make_servo(model, joints, gains(felt, *np.zeros((4, 3))))
    model.opt.gravity[:] = 0.0
    data.ctrl[:3] = 0.2, -0.3, 0.05
    mujoco.mj_step(model, data, 500)
    assert data.qpos[:3] == pytest.approx([0.2, -0.3, 0.05], abs=1e-4)
    make_motor(model, joints)
    data.ctrl[:3] = 1.0, 0.0, 0.0
    mujoco.mj_forward(model, data)
    assert data.actuator_force[:3].tolist() == [1.0, 0.0, 0.0]


def test_a_spring_in_a_joint_does_not_pull_it_from_where_it_is_told_to_be():  # R-X19
    made = gains(np.array([0.5]), np.zeros(1), np.zeros(1), np.array([240.0]), np.array([0.1]))
    (goal,), (signal,) = np.array([0.3]), made.against_springs(np.array([0.3]))
    assert made.kp[0] * (signal - goal) == pytest.approx(240.0 * (0.3 - 0.1))
    free = gains(np.array([0.5]), np.zeros(1), np.zeros(1), np.zeros(1), np.zeros(1))
    assert free.against_springs(np.array([0.3]))[0] == 0.3


def test_a_finger_presses_with_all_its_force_some_millimetres_before_its_goal():  # R-X19
    model = mujoco.MjModel.from_xml_string(ARM)
    lift = np.array([model.actuator("lift").id])
    felt = felt_inertia(model, mujoco.MjData(model), np.array([model.joint("lift").dofadr[0]]))
    given = finger_gains(model, lift)
    assert given.kp == pytest.approx(300.0**2 * felt)
    assert given.kp[0] * 0.003 > 30.0
