import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.frames import (
    as_array,
    dh_transform,
    inverse_pose,
    nine_of_pose,
    pose_of_nine,
    quaternion_of_rotation,
    rotation_exp,
    rotation_log,
    rotation_of_quaternion,
    rotation_of_rpy,
    rpy_of_rotation,
    turn_between,
)

angles = st.floats(-math.pi, math.pi)
metres = st.floats(-2.0, 2.0)
rotations = st.builds(rotation_of_rpy, angles, angles, angles)


def test_a_dh_transform_turns_and_moves_as_its_four_numbers_say():
    pose = dh_transform(0.3, math.pi / 2, 0.2, math.pi / 2)
    assert np.allclose(pose[:3, 3], (0.0, 0.3, 0.2), atol=1e-15)
    assert np.allclose(pose[:3, :3], [[0, 0, 1], [1, 0, 0], [0, 1, 0]], atol=1e-15)


@settings(max_examples=examples(50), deadline=None)
@given(rotations, metres, metres, metres)
def test_nine_numbers_and_pose_are_the_same_thing(rotation, x, y, z):
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation, (x, y, z)
    assert np.allclose(pose_of_nine(nine_of_pose(pose)), pose, atol=1e-12)
    assert np.allclose(pose_of_nine(nine_of_pose(pose).tolist(), np.empty((4, 4))), pose, atol=1e-12)


def test_printed_digits_are_made_orthogonal_again():  # reading 44
    nine = [-0.0417, -0.0328, -0.999, 0.00829, 0.999, -0.0332, 0.781, 0.159, -0.21]
    pose = pose_of_nine(nine)
    assert np.allclose(pose[:3, :3] @ pose[:3, :3].T, np.eye(3), atol=1e-14)
    assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0)
    assert np.allclose(nine_of_pose(pose), nine, atol=2e-3)


@pytest.mark.parametrize(
    ("nine", "sentence"),
    [
        ([0, 0, 0, 0, 1, 0, 0, 0, 0], "approach"),
        ([0, 0, -1, 0, 5, 0, 0, 0, 0], "normal"),
        ([0, 0, -1, 0, 0.2, 0.98, 0, 0, 0], "square"),
        ([0, 0, math.nan, 0, 1, 0, 0, 0, 0], "approach"),
    ],
)
def test_nine_numbers_that_are_no_orientation_are_refused(nine, sentence):
    with pytest.raises(ValueError, match=sentence):
        pose_of_nine([float(x) for x in nine])


@settings(max_examples=examples(50), deadline=None)
@given(rotations, metres, metres, metres)
def test_a_pose_times_its_inverse_is_nothing(rotation, x, y, z):
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation, (x, y, z)
    assert np.allclose(pose @ inverse_pose(pose), np.eye(4), atol=1e-12)


@settings(max_examples=examples(100), deadline=None)
@given(rotations)
def test_the_exponential_of_the_logarithm_is_the_rotation(rotation):
    vector = rotation_log(rotation)
    assert np.linalg.norm(vector) <= math.pi + 1e-12
    assert np.allclose(rotation_exp(vector), rotation, atol=1e-9)


def test_the_logarithm_of_no_turn_is_zero_and_of_half_a_turn_is_pi():
    assert not rotation_log(np.eye(3)).any()
    assert np.allclose(np.abs(rotation_log(np.diag([-1.0, -1.0, 1.0]))), (0, 0, math.pi))


@settings(max_examples=examples(50), deadline=None)
@given(rotations, rotations)
def test_the_turn_between_two_rotations_leads_from_one_to_the_other(first, second):
    turn = turn_between(first.tolist(), second.tolist())
    assert np.allclose(first @ rotation_exp(turn), second, atol=1e-9)


def test_a_tiny_turn_keeps_its_digits():
    assert np.allclose(rotation_log(rotation_exp([1e-9, 0.0, -2e-9])), (1e-9, 0.0, -2e-9), rtol=1e-6, atol=0.0)


@settings(max_examples=examples(50), deadline=None)
@given(rotations)
def test_a_quaternion_has_length_one_and_turns_like_its_matrix(rotation):
    w, x, y, z = quaternion_of_rotation(rotation)
    assert w * w + x * x + y * y + z * z == pytest.approx(1.0)
    first = (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y))
    assert np.allclose(first, rotation[:, 0], atol=1e-12)


@settings(max_examples=examples(50), deadline=None)
@given(rotations)
def test_roll_pitch_yaw_give_the_rotation_back(rotation):
    assert np.allclose(rotation_of_rpy(*rpy_of_rotation(rotation)), rotation, atol=1e-8)


@pytest.mark.parametrize("pitch", [math.pi / 2, -math.pi / 2])
def test_looking_straight_up_or_down_yaw_is_zero(pitch):
    rotation = rotation_of_rpy(0.4, pitch, 0.3)
    assert rpy_of_rotation(rotation)[2] == 0.0
    assert np.allclose(rotation_of_rpy(*rpy_of_rotation(rotation)), rotation, atol=1e-9)


def test_constants_of_the_wrong_number_are_refused_with_both_shapes():
    with pytest.raises(ValueError, match=r"\(6, 4\).*\(5,\)"):
        as_array([1, 2, 3, 4, 5], (6, 4))


@settings(max_examples=examples(50), deadline=None)
@given(rotations)
def test_a_quaternion_of_a_rotation_is_that_rotation(rotation):
    assert np.allclose(rotation_of_quaternion(quaternion_of_rotation(rotation)), rotation, atol=1e-9)
