import math

import numpy as np

from onika.laws import puma560
from onika.laws.chain import SLIDES, chain_pose, kinds_of, links, text_of
from onika.laws.frames import dh_transform


def test_a_link_stands_where_its_row_says_at_zero():
    row = np.array([[0.3, math.pi / 2, 0.2, 0.5]])
    (link,) = links(row, np.zeros(1))
    assert np.allclose(link.position, dh_transform(0.3, math.pi / 2, 0.2, 0.5)[:3, 3])


def test_axis_and_anchor_are_the_former_frame_seen_from_the_link():
    row = np.array([[0.3, 0.7, 0.2, 0.5]])
    (link,) = links(row, np.zeros(1))
    pose = dh_transform(0.3, 0.7, 0.2, 0.5)
    assert np.allclose(pose[:3, :3] @ link.axis, (0, 0, 1))
    assert np.allclose(pose[:3, :3] @ link.anchor + pose[:3, 3], 0.0, atol=1e-15)


def test_a_prismatic_joint_slides_along_the_former_z():
    dh, kind = np.array([[0.0, 0.0, 0.1, 0.0]]), np.ones(1)
    assert np.allclose(chain_pose(dh, kind, np.array([0.25]))[:3, 3], (0.0, 0.0, 0.35))
    assert links(dh, kind)[0].slides


def test_a_full_turn_in_its_offset_says_that_a_joint_slides_and_changes_no_frame():  # R-K03
    dh = np.array([[0.3, 0.7, 0.2, 0.5], [0.3, 0.7, 0.2, 0.5 + SLIDES]])
    assert kinds_of(dh).tolist() == [0.0, 1.0]
    turns, slides = links(dh, kinds_of(dh))
    assert (turns.slides, slides.slides) == (False, True)
    assert np.allclose(turns.position, slides.position)
    assert np.allclose(turns.quaternion, slides.quaternion)


def test_the_puma_at_home_points_straight_up():
    pose = chain_pose(puma560.DH, np.zeros(6), puma560.HOME)
    assert np.allclose(pose[:3, 2], (0.0, 0.0, 1.0), atol=1e-12)
    assert np.isclose(pose[2, 3], 0.4318 + 0.43307 + 0.05625)


def test_numbers_are_written_with_every_digit():
    assert [float(word) for word in text_of((0.1, 1 / 3, -2e-17)).split()] == [0.1, 1 / 3, -2e-17]
