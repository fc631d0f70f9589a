import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.worlds.mjcf_arms import ARMS
from onika.laws import puma560
from onika.laws.arm import ArmModel
from onika.laws.chain import chain_pose
from onika.laws.frames import inverse_pose, rotation_log, rotation_of_rpy
from onika.laws.textbook import serial_arm

BASE = np.eye(4)
BASE[:3, :3], BASE[:3, 3] = rotation_of_rpy(0.2, -0.1, 2.0), (1.2, -0.3, 0.4)
PUMA = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD, BASE, puma560.TOOL)

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
    arm = serial_arm(SCARA_DH, kind=SCARA_KIND)
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
    arm = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD)
    q = np.array([0.3, -0.8, 1.9, 0.4, 0.9, -0.2])
    slope = [(_potential(q + d) - _potential(q - d)) / 2e-5 for d in 1e-5 * np.eye(6)]
    assert np.allclose(arm.bias(q, np.zeros(6)), slope, atol=1e-6)


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_coriolis_torque_spends_what_the_inertia_gains(seed):
    # the work of C(q, qd) qd is half the change of the inertia: qd . (bias - gravity) = qd . dM/dt qd / 2
    random = np.random.default_rng(seed)
    q, qd = random.uniform(puma560.QMIN, puma560.QMAX), random.uniform(-2, 2, 6)
    arm = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD)
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
    empty = serial_arm(puma560.DH, puma560.DYN)
    q = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    more = PUMA.load[0] * 9.81
    assert np.abs(serial_arm(puma560.DH, puma560.DYN, puma560.LOAD).bias(q, q) - empty.bias(q, q)).max() > 0.4 * more


def test_gravity_at_the_shoulder_is_that_of_the_table():  # the largest is 45.7 N m on joint 2 without the hand
    arm = serial_arm(puma560.DH, puma560.DYN)
    torques = [abs(arm.bias([0, q2, q3, 0, 0, 0], np.zeros(6))[1]) for q2 in (0.0, 0.1, -0.1) for q3 in (1.5, 1.6)]
    assert 44.0 < max(torques) < 46.0


def test_constants_of_the_wrong_size_are_refused():
    with pytest.raises(ValueError, match="expected"):
        serial_arm(puma560.DH, puma560.DYN[:5])


def _inertia(arm: ArmModel, q: np.ndarray) -> np.ndarray:
    """Mass matrix without armature."""
    return arm.inertia(q) - np.diag(arm.armature)


def _potential(q: np.ndarray) -> float:
    """Sum of m g z over links and load, by the plain product of transforms."""
    energy = 0.0
    for k, row in enumerate(puma560.DYN):
        pose = chain_pose(puma560.DH[: k + 1], np.zeros(k + 1), q[: k + 1])
        energy += row[0] * 9.81 * (pose @ [*row[1:4], 1.0])[2]
    hand = chain_pose(puma560.DH, np.zeros(6), q) @ [*puma560.LOAD[1:], 1.0]
    return energy + puma560.LOAD[0] * 9.81 * hand[2]


@pytest.mark.parametrize("name", sorted(ARMS))
def test_any_chain_and_tree_is_what_the_model_says_that_it_was_read_from(name):  # R-X19, decision 46
    arm, random = ARMS[name], np.random.default_rng(5)
    law, rest = _model_of(arm), np.zeros(arm.n)
    for _ in range(50):
        q, qd = random.uniform(-2.7, 2.7, arm.n), random.uniform(-2.0, 2.0, arm.n)
        assert np.abs(law.forward(q) - arm.pose(q)).max() < 1e-12
        bias, inertia = arm.data_at(q, qd).qfrc_bias, arm.inertia(q)
        assert np.abs(law.bias(q, qd) - bias).max() < 1e-10
        assert np.abs(law.inertia(q) - inertia).max() < 1e-10
        qdd = random.uniform(-5.0, 5.0, arm.n)
        assert law.torque(q, qd, qdd) == pytest.approx(inertia @ qdd + bias, abs=1e-9)
        assert law.torque(q, qd, rest) == pytest.approx(law.bias(q, qd), abs=1e-12)


@pytest.mark.parametrize("name", sorted(ARMS))
def test_the_jacobian_of_any_chain_and_tree_is_the_slope_of_its_pose(name):  # R-X19
    arm = ARMS[name]
    law, q = _model_of(arm), np.linspace(-0.6, 0.7, arm.n)
    for column, d in zip(law.jacobian(q).T, 1e-6 * np.eye(arm.n), strict=True):
        after, before = law.forward(q + d), law.forward(q - d)
        turn = rotation_log(after[:3, :3] @ before[:3, :3].T)
        assert np.allclose(column, np.concatenate((after[:3, 3] - before[:3, 3], turn)) / 2e-6, atol=1e-8)


def test_joints_are_drawn_where_they_are():
    q = np.array([0.3, -0.8, 1.9, 0.4, 0.9, -0.2])
    points = PUMA.joint_places(q)
    for k in range(6):  # a joint moves those behind it alone
        assert PUMA.joint_places(q + 0.5 * np.eye(6)[k])[: k + 1] == pytest.approx(points[: k + 1])
    assert points[0] == pytest.approx(BASE[:3, 3])


def test_moments_of_inertia_that_no_body_has_are_refused():
    link = np.zeros((1, 13))
    link[0, :7] = 1.0, 0.0, 0.0, 0.0, 0.1, 0.1, 0.3
    with pytest.raises(ValueError, match=r"of link 1 of which none is larger .* found 0.1 0.1 0.3"):
        ArmModel([[0, 0, 1, 0, 0, 0]], link).bias([0.0], [0.0])


def test_a_rod_whose_moments_are_unlike_by_rounding_is_a_body():
    link = np.zeros((1, 13))
    link[0, :7] = 1.0, 0.0, 0.0, 0.0, 1e-17, 0.1, 0.1 + 5e-17
    assert ArmModel([[0, 0, 1, 0, 0, 0]], link).inertia([0.0]) == pytest.approx(np.array([[0.1]]))


def _model_of(arm):
    screw, link, parent, base, tool = (arm.constants[name] for name in ("SCREW", "LINK", "PARENT", "BASE", "TOOL"))
    return ArmModel(screw, link, parent, None, base, tool)
