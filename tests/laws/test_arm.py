import mujoco
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws import puma560
from onika.laws.arm import SerialArm
from onika.laws.chain import chain_pose
from onika.laws.frames import inverse_pose, rotation_log, rotation_of_rpy

BASE = np.eye(4)
BASE[:3, :3], BASE[:3, 3] = rotation_of_rpy(0.2, -0.1, 2.0), (1.2, -0.3, 0.4)
PUMA = SerialArm(puma560.DH, puma560.DYN, puma560.LOAD, BASE, puma560.TOOL)

# an arm with a prismatic joint: shoulder, elbow, quill, roll
SCARA_DH = [[0.425, 0.0, 0.3, 0.0], [0.375, np.pi, 0.0, 0.0], [0.0, 0.0, 0.24, 0.0], [0.0, 0.0, 0.0, 0.0]]
SCARA_KIND = [0, 0, 1, 0]


def test_forward_kinematics_is_the_product_of_the_transforms():  # R-K01
    random = np.random.default_rng(0)
    for _ in range(1000):
        q = random.uniform(puma560.QMIN, puma560.QMAX)
        expected = BASE @ chain_pose(puma560.DH, np.zeros(6), q) @ puma560.TOOL
        assert np.abs(PUMA.forward(q) - expected).max() < 1e-9


def test_forward_kinematics_of_a_sliding_joint():
    arm = SerialArm(SCARA_DH, kind=SCARA_KIND)
    q = np.array([0.4, -0.9, 0.1, 1.3])
    expected = chain_pose(np.array(SCARA_DH), np.array(SCARA_KIND), q)
    assert np.abs(arm.forward(q) - expected).max() < 1e-12


def test_an_array_handed_in_is_filled_and_given_back():
    out = np.empty((4, 4))
    assert PUMA.forward(puma560.HOME, out) is out
    assert np.array_equal(out, PUMA.forward(puma560.HOME.tolist()))
    torque = np.empty(6)
    assert PUMA.bias(puma560.HOME, np.zeros(6), torque) is torque


def test_gravity_is_the_slope_of_the_potential_energy():
    arm = SerialArm(puma560.DH, puma560.DYN, puma560.LOAD)
    q = np.array([0.3, -0.8, 1.9, 0.4, 0.9, -0.2])
    slope = [(_potential(q + d) - _potential(q - d)) / 2e-5 for d in 1e-5 * np.eye(6)]
    assert np.allclose(arm.bias(q, np.zeros(6)), slope, atol=1e-6)


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_coriolis_torque_spends_what_the_inertia_gains(seed):
    # the work of C(q, qd) qd is half the change of the inertia: qd . (bias - gravity) = qd . dM/dt qd / 2
    random = np.random.default_rng(seed)
    q, qd = random.uniform(puma560.QMIN, puma560.QMAX), random.uniform(-2, 2, 6)
    arm = SerialArm(puma560.DH, puma560.DYN, puma560.LOAD)
    power = qd @ (arm.bias(q, qd) - arm.bias(q, np.zeros(6)))
    energy = [qd @ _inertia(arm, q + sign * 1e-6 * qd) @ qd / 2 for sign in (1, -1)]
    assert power == pytest.approx((energy[0] - energy[1]) / 2e-6, abs=1e-4)


def test_the_jacobian_is_the_slope_of_the_pose():
    q, jacobian = np.array([0.3, -0.8, 1.9, 0.4, 0.9, -0.2]), np.empty((6, 6))
    assert PUMA.jacobian(q, jacobian) is jacobian
    for k, d in enumerate(1e-6 * np.eye(6)):
        after, before = PUMA.forward(q + d), PUMA.forward(q - d)
        assert np.allclose(jacobian[:3, k], (after[:3, 3] - before[:3, 3]) / 2e-6, atol=1e-8)
        turn = rotation_log(after[:3, :3] @ inverse_pose(before)[:3, :3]) / 2e-6
        assert np.allclose(jacobian[3:, k], turn, atol=1e-8)


def test_a_load_weighs_on_the_joints():
    empty = SerialArm(puma560.DH, puma560.DYN)
    q = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    more = PUMA.load[0] * 9.81
    assert np.abs(SerialArm(puma560.DH, puma560.DYN, puma560.LOAD).bias(q, q) - empty.bias(q, q)).max() > 0.4 * more


def test_gravity_at_the_shoulder_is_that_of_the_table():  # the largest is 45.7 N m on joint 2 without the hand
    arm = SerialArm(puma560.DH, puma560.DYN)
    torques = [abs(arm.bias([0, q2, q3, 0, 0, 0], np.zeros(6))[1]) for q2 in (0.0, 0.1, -0.1) for q3 in (1.5, 1.6)]
    assert 44.0 < max(torques) < 46.0


def test_constants_of_the_wrong_size_are_refused():
    with pytest.raises(ValueError, match="expected"):
        SerialArm(puma560.DH, puma560.DYN[:5])


def _inertia(arm: SerialArm, q: np.ndarray) -> np.ndarray:
    """Mass matrix without armature, column by column from inverse dynamics of a model of the same text."""
    model = mujoco.MjModel.from_xml_string(arm._text())
    data = mujoco.MjData(model)
    model.opt.gravity[:] = 0.0
    data.qpos[:] = q
    columns = np.empty((6, 6))
    for k in range(6):
        data.qacc[:] = np.eye(6)[k]
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)
        mujoco.mj_rne(model, data, 1, columns[k])
    return columns


def _potential(q: np.ndarray) -> float:
    """Sum of m g z over links and load, by the plain product of transforms."""
    energy = 0.0
    for k, row in enumerate(puma560.DYN):
        pose = chain_pose(puma560.DH[: k + 1], np.zeros(k + 1), q[: k + 1])
        energy += row[0] * 9.81 * (pose @ [*row[1:4], 1.0])[2]
    hand = chain_pose(puma560.DH, np.zeros(6), q) @ [*puma560.LOAD[1:], 1.0]
    return energy + puma560.LOAD[0] * 9.81 * hand[2]
