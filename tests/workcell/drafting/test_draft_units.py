import struct

import pytest

from kit.worlds.robot_models import PLAIN
from onika.wire.world_source import WorldFile, WorldSource
from onika.workcell.drafting.draft import draft

CORNERS = ((0, 0, 0), (300, 0, 0), (0, 200, 0), (0, 0, 100))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
WITH_MESH = PLAIN.replace("<worldbody>", '<asset><mesh name="m" file="m.stl"/></asset><worldbody>').replace(
    '<body name="rod"', '<geom type="mesh" mesh="m" mass="1"/><body name="rod"'
)


def tetrahedron():
    """A mesh in STL of 300 x 200 x 100."""
    faces = (struct.pack("<12fH", 0, 0, 0, *(c for k in face for c in CORNERS[k]), 0) for face in FACES)
    return bytes(80) + struct.pack("<I", len(FACES)) + b"".join(faces)


def notes(text):
    files = (
        WorldFile("robot/new.xml", "/lab/new.xml", text.encode()),
        WorldFile("m.stl", "/lab/m.stl", tetrahedron()),
    )
    made = draft(WorldSource("new", "", files), "new", "new.xml")
    assert not made.refusal, made.refusal
    return {note.key: note.text for note in made.notes}


@pytest.mark.parametrize(("angle", "is_told"), [("degree", False), ("radian", True)])
def test_limits_of_many_turns_are_told_as_those_that_may_be_degrees(angle, is_told):  # R-X19
    told = notes(PLAIN.replace("<worldbody>", f'<compiler angle="{angle}"/><worldbody>'))
    assert ("workcell.draft_degrees" in told) == is_told
    assert not is_told or "bend go up to 100 rad" in told["workcell.draft_degrees"]


@pytest.mark.parametrize(("scale", "is_told"), [("1 1 1", True), ("0.001 0.001 0.001", False)])
def test_a_mesh_much_larger_than_the_arm_is_told_as_one_that_may_be_in_millimetres(scale, is_told):  # R-X19
    told = notes(WITH_MESH.replace('file="m.stl"', f'file="m.stl" scale="{scale}"'))
    assert ("workcell.draft_millimetres" in told) == is_told
    assert not is_told or "arm that reaches 0.3 m" in told["workcell.draft_millimetres"]
