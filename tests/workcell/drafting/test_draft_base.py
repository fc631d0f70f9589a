"""Bases that drive, found in models."""

import mujoco
import pytest

from kit.worlds.new_bases import CAR, SLED, car
from onika.workcell.drafting.draft_base import draft_base


def found(text):
    return draft_base(mujoco.MjModel.from_xml_string(text))


@pytest.mark.parametrize("free", ["<freejoint/>", ""])
@pytest.mark.parametrize(
    ("kind", "size", "turned"),
    [
        ("sphere", "0.08", ""),
        ("cylinder", "0.08 0.02", 'quat="0.70710678 0.70710678 0 0"'),
        ("ellipsoid", "0.08 0.02 0.08", ""),
    ],
)
def test_two_wheels_beside_each_other_are_a_base_with_their_radius_and_distance(free, kind, size, turned):  # R-X19
    base = found(car(free, kind, size, turned))
    assert (base.device.wheels, base.device.radius, base.device.track) == (("left", "right"), 0.08, 0.3)
    assert base.floor == pytest.approx(0.02)
    assert base.origin.key == "workcell.draft_wheels"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('name="l" axis="0 1 0"', 'name="l" axis="1 0 0"'),
        ('name="l" axis="0 1 0"', 'name="l" axis="0 1 0" limited="true" range="-90 90"'),
        ('name="l" pos="0.02 0.15', 'name="l" pos="0.06 0.15'),
        ('<motor name="left" joint="l" ctrlrange="-2 2"/>', ""),
        ("<freejoint/>", '<joint name="tilt" axis="0 1 0"/>'),
    ],
)
def test_what_only_looks_a_little_like_that_is_none(old, new):  # R-X19
    assert old in CAR
    assert found(CAR.replace(old, new)) is None


def test_two_slides_and_a_turn_below_all_else_are_a_base():  # R-X19
    base = found(SLED)
    assert (base.device.slides, base.joints, base.origin.key) == (
        ("mx", "my", "mw"),
        (0, 1, 2),
        "workcell.draft_slides",
    )
    assert found(SLED.replace('type="slide" axis="0 1 0"', 'type="slide" axis="0 0 1"')) is None
