import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws import adept_one
from onika.laws.damped import DampedInverse
from onika.laws.frames import pose_of_nine, rotation_about, rotation_of_rpy
from onika.laws.inverse import serial_inverse
from onika.laws.scara_inverse import LEAN, ScaraInverse
from onika.laws.textbook import serial_arm

TILTED = np.eye(4)
TILTED[:3, :3], TILTED[:3, 3] = rotation_of_rpy(0.3, -0.2, 1.1), (0.4, -0.1, 0.2)
CROOKED = np.eye(4)
CROOKED[:3, :3], CROOKED[:3, 3] = rotation_of_rpy(0.4, 0.5, -0.3), (0.05, -0.02, 0.13)

within = st.tuples(
    *(st.floats(float(low), float(high)) for low, high in zip(adept_one.QMIN, adept_one.QMAX, strict=True))
)


def table(*, down=math.pi, offsets=(0.0, 0.0, 0.0, 0.0)):
    dh = adept_one.DH.copy()
    dh[1, 1] = down
    dh[:, 3] += offsets
    return dh


def inverse(dh=adept_one.DH, base=None, tool=adept_one.TOOL):
    solver = serial_inverse(dh, base, tool, adept_one.QMIN, adept_one.QMAX)
    assert isinstance(solver, ScaraInverse)
    return solver


def down(x, y, z):
    return pose_of_nine([0.0, 0.0, -1.0, 0.0, 1.0, 0.0, x, y, z])


@settings(max_examples=examples(50), deadline=None)
@given(
    q=within,
    near=within,
    dh=st.sampled_from([table(), table(down=0.0), table(offsets=(0.2, -0.4, 0.1, 0.7))]),
    base=st.sampled_from([np.eye(4), TILTED]),
    tool=st.sampled_from([adept_one.TOOL, CROOKED]),
)
def test_forward_of_the_inverse_is_the_pose_it_came_from(q, near, dh, base, tool):  # R-K03
    pose = serial_arm(dh, base=base, tool=tool).forward(q)
    law = inverse(dh, base, tool)
    for guess in (q, near):
        solution = law.nearest(pose, guess)
        assert not isinstance(solution, str), solution
        assert (solution >= adept_one.QMIN).all()
        assert (solution <= adept_one.QMAX).all()
        assert np.allclose(serial_arm(dh, base=base, tool=tool).forward(solution), pose, atol=1e-7)


def test_the_solution_from_nearby_is_the_one_nearby():
    rng, arm, law = np.random.default_rng(3), serial_arm(adept_one.DH, tool=adept_one.TOOL), inverse()
    for _ in range(300):
        q = rng.uniform(0.9 * adept_one.QMIN, 0.9 * adept_one.QMAX)
        q[1] = math.copysign(max(abs(q[1]), 0.2), q[1])
        solution = law.nearest(arm.forward(q), q + 0.02)
        assert np.allclose(solution, q, atol=1e-9)


def test_least_squares_gives_the_same_answer():
    other = DampedInverse(serial_arm(adept_one.DH, tool=adept_one.TOOL), adept_one.QMIN, adept_one.QMAX)
    near = np.array([0.1, 0.7, 0.1, -0.8])
    pose = down(0.7, 0.28, -0.2)
    assert np.allclose(other.nearest(pose, near), inverse().nearest(pose, near), atol=1e-6)


@pytest.mark.parametrize(
    ("pose", "reason"),
    [
        (
            down(0.9, 0.0, -0.2),
            "out of reach: the quill would be 0.900 m from joint 1's axis, possible are 0.050..0.800",
        ),
        (down(0.02, 0.0, -0.2), "out of reach: the quill would be 0.020 m"),
        (down(0.6, 0.0, -0.4), "joint 3 would stand at 0.330 m, beyond 0.000..0.295"),
        (down(0.6, 0.0, 0.0), "joint 3 would stand at -0.070 m"),
        (down(-0.79, 0.0, -0.2), "joint 1 would stand at"),
        (
            pose_of_nine([1, 0, 0, 0, 1, 0, 0.6, 0, -0.2]),
            "the hand would lean 90 degrees; this arm only holds it upright",
        ),
        (pose_of_nine([0, 0, 1, 0, 1, 0, 0.6, 0, -0.2]), "the hand would lean 180 degrees"),
    ],
)
def test_a_pose_it_cannot_take_is_explained(pose, reason):  # law 26
    assert reason in inverse().nearest(pose, adept_one.HOME)


def test_a_slight_lean_is_lost_and_the_point_between_the_fingers_kept():
    pose = down(0.6, 0.1, -0.2)
    pose[:3, :3] = rotation_about(1.0, 0.0, 0.0, 0.9 * LEAN) @ pose[:3, :3]
    solution = inverse().nearest(pose, adept_one.HOME)
    reached = serial_arm(adept_one.DH, tool=adept_one.TOOL).forward(solution)
    assert reached[:3, 3] == pytest.approx(pose[:3, 3], abs=1e-9)
    assert reached[:3, 2] == pytest.approx([0.0, 0.0, -1.0])


def test_a_pose_that_is_no_number_is_out_of_reach():
    assert isinstance(inverse().nearest(np.full((4, 4), np.nan), adept_one.HOME), str)
