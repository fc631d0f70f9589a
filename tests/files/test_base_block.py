"""Blocks of bases: what is wrong with a line is told with its number."""

import pytest

from onika.files.robot import read, write
from onika.model.robot import RobotBase

ROVER = """VERSION     2.0
FILE        rover.xml

BASE        base
WHEELS      left right 0.06 0.26
SPEED       0.6 2.5

EOF
"""


def test_a_base_stands_on_wheels_or_on_slides():  # R-K04
    robot, faults = read(ROVER, "rover", "f")
    assert faults == ()
    assert robot.devices == (RobotBase("base", ("left", "right"), 0.06, 0.26, (), (0.6, 2.5)),)
    assert write(robot, ROVER) == ROVER
    slides, faults = read(
        ROVER.replace("WHEELS      left right 0.06 0.26\nSPEED       0.6 2.5", "SLIDES x y turn"), "r", "f"
    )
    assert faults == ()
    assert slides.devices == (RobotBase("base", slides=("x", "y", "turn")),)


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("0.06 0.26", "0.06", 5, "files.meaning_after"),
        ("0.06 0.26", "0 0.26", 5, "files.meaning_after"),
        ("left right", "left left", 5, "files.base_moves_unlike"),
        ("WHEELS      left right 0.06 0.26\n", "", 4, "files.wheels_or_slides"),
        ("SPEED", "SLIDES x y turn\nSPEED", 4, "files.wheels_or_slides"),
        ("WHEELS      left right 0.06 0.26", "SLIDES x y", 5, "files.meaning_after"),
        ("WHEELS      left right 0.06 0.26", "SLIDES x y z turn", 5, "files.base_moves_unlike"),
        ("0.6 2.5", "0.6", 6, "files.meaning_after"),
        ("0.6 2.5", "0.6 0", 6, "files.meaning_after"),
        ("SPEED       0.6 2.5", "\nAXES a\nMOVES left", 8, "files.actuator_twice"),
    ],
)
def test_what_is_wrong_with_a_base_is_told_with_its_line(old, new, line, key):  # R-B07, R-K04
    robot, faults = read(ROVER.replace(old, new, 1), "rover", "f")
    assert robot is None
    assert (line, key) in [(fault.place.line, fault.reason.key) for fault in faults]
