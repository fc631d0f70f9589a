"""The arc of the tool."""

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

from kit.examples import examples
from onika.laws.frames import pose_of_nine
from onika.laws.paths.arc import Arc

DOWN = [0, 0, -1, 0, 1, 0]
places = st.tuples(*[st.floats(-0.5, 0.5)] * 3).map(np.array)


def pose(place, turn=DOWN):
    return pose_of_nine([*turn, *place])


def test_half_a_circle_passes_its_top_at_its_middle():
    arc = Arc(pose([0.5, 0, 0]), np.array([0.6, 0, 0.1]), pose([0.7, 0, 0]))
    assert arc.at(0.5)[:3, 3] == pytest.approx([0.6, 0, 0.1])
    assert arc.length == pytest.approx(0.1 * np.pi)
    assert arc.duration(0.3, 1.0) == pytest.approx(1.875 * 0.1 * np.pi / 0.3)


def test_the_way_round_is_that_of_the_place_on_the_way():
    below = Arc(pose([0.5, 0, 0]), np.array([0.6, 0, -0.1]), pose([0.7, 0, 0]))
    long = Arc(pose([0.5, 0, 0]), np.array([0.7, 0, 0]), pose([0.6, 0, 0.1]))
    assert below.at(0.5)[:3, 3] == pytest.approx([0.6, 0, -0.1])
    assert long.angle == pytest.approx(1.5 * np.pi)


@settings(max_examples=examples(100), deadline=None)
@given(places, places, places)
def test_every_place_of_an_arc_is_as_far_from_its_middle_and_it_meets_all_three(first, via, last):
    assume(np.linalg.norm(np.cross(via - first, last - first)) > 1e-3)
    arc = Arc(pose(first), via, pose(last))
    course = np.array([arc.at(s)[:3, 3] for s in np.linspace(0, 1, 721)])
    assert course[0] == pytest.approx(first, abs=1e-9)
    assert course[-1] == pytest.approx(last, abs=1e-6)
    steps = np.linalg.norm(np.diff(course, axis=0), axis=1)
    assert steps == pytest.approx(np.full(720, steps[0]), rel=1e-6)
    assert np.linalg.norm(course - via, axis=1).min() <= steps[0]


def test_places_on_a_line_are_a_straight_line():
    arc = Arc(pose([0.5, 0, 0]), np.array([0.6, 0, 0]), pose([0.9, 0, 0]))
    assert arc.at(0.5)[:3, 3] == pytest.approx([0.7, 0, 0])
    assert (arc.angle, arc.length) == (0.0, pytest.approx(0.4))


@pytest.mark.parametrize(
    ("via", "last"), [([0.4, 0, 0], [0.9, 0, 0]), ([0.5, 0, 0], [0.9, 0, 0]), ([0.6, 0, 0], [0.5, 0, 0])]
)
def test_three_places_without_a_way_from_one_to_the_next_are_refused(via, last):
    with pytest.raises(ValueError, match="no circle leads from here"):
        Arc(pose([0.5, 0, 0]), np.array(via), pose(last))


def test_it_turns_evenly_to_how_the_last_pose_points():
    turned = [0, -0.6, -0.8, 1, 0, 0]
    arc = Arc(pose([0.5, 0, 0]), np.array([0.6, 0, 0.1]), pose([0.7, 0, 0], turned))
    assert arc.at(1.0) == pytest.approx(pose([0.7, 0, 0], turned))
    for s in (0.2, 0.7):
        assert arc.at(s)[:3, :3] @ arc.at(s)[:3, :3].T == pytest.approx(np.eye(3), abs=1e-9)
