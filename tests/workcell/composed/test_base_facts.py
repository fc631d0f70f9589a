"""What is known of bases, and what makes none."""

import pytest

from kit.worlds.driving_bases import FILES
from kit.worlds.file_cells import files_of
from onika.workcell.cell.file_world import FileWorld


def faults(name, old, new):
    if old not in FILES[name]:
        raise ValueError(f"expected {old!r} in {name}")
    world = FileWorld(files_of({**FILES, name: FILES[name].replace(old, new)}, "floor"))
    return [(fault.place.line, fault.reason.key) for fault in world.faults]


def test_it_says_how_fast_it_can_go():  # R-K04
    sheets = {sheet.name: sheet for sheet in FileWorld(files_of(FILES, "floor")).devices()}
    rover, cross = sheets["rover_base_bay"], sheets["cross_base_bay"]
    assert rover.command == cross.command == ("vx", "vy", "w")
    assert rover.state == ("time", "drive", "x", "y", "turn", "vx", "vy", "w")
    assert rover.identity == {"ROBOT": "rover", "DRIVE": "twist", "V_MAX": (1.0, 0.0, 2.0)}
    assert cross.identity["V_MAX"] == (1.0, 1.0, 2.0)


@pytest.mark.parametrize(
    ("name", "old", "new", "line", "key"),
    [
        ("robot/rover.robot", "WHEELS l r", "WHEELS l q", 4, "workcell.no_such_name"),
        ("robot/rover.xml", 'name="left" axis="0 1 0"', 'name="left" axis="1 0 0"', 4, "workcell.wheel_askew"),
        ("robot/rover.xml", 'name="left" axis', 'name="left" type="slide" axis', 4, "workcell.wheel_askew"),
        ("robot/rover.xml", '<body name="car" pos="0 0 0.1">', '<body name="car"><joint/>', 4, "workcell.base_fixed"),
        ("robot/cross.robot", "SLIDES x y turn", "SLIDES y x turn", 4, "workcell.slide_askew"),
        ("robot/cross.robot", "SLIDES x y turn", "SLIDES x turn y", 4, "workcell.slide_askew"),
        ("robot/cross.robot", "FROM cross\n", "", 7, "workcell.joint_twice"),
    ],
)
def test_what_is_no_base_is_told_with_its_line_and_left_out(name, old, new, line, key):  # R-B07, R-K04
    assert faults(name, old, new) == [(line, key)]
