"""What people call a thing of a world, in each language."""

import pytest

from onika.files.world import read, write

CELL = """VERSION     2.0

PART        box
FILE        box.xml
FREE
NAME        en the box with the waves
NAME        es la caja de las ondas

PLACE       left
ROBOTS      - arm scara
HAND        gripper flange
NAME        en the left arm
HANDNAME    en the left hand

SWITCH      on
PRESSED     box.patch 1

LAMP        lamp
WHEN        on
SHINES      box.bulb
GLOWS       box.glow
NAME        es la lámpara

EOF
"""


def test_a_thing_has_a_name_in_each_language():  # R-X19
    world, faults = read(CELL, "cell", "f")
    assert faults == ()
    assert world.parts[0].names == (("en", "the box with the waves"), ("es", "la caja de las ondas"))
    assert world.places[0].names == (("en", "the left arm"),)
    assert world.places[0].hand_names == (("en", "the left hand"),)
    assert (world.lamps[0].names, world.lamps[0].glows) == ((("es", "la lámpara"),), ("box.glow",))
    assert write(world) == CELL


def test_a_place_may_be_empty_and_have_a_hand():  # R-X19
    world, _ = read(CELL, "cell", "f")
    (place,) = world.places
    assert (place.is_empty, place.robots, place.hand) == (True, ("arm", "scara"), ("gripper", "flange"))
    assert world.robots == ("arm", "scara", "gripper")


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("en the box with the waves", "de die Kiste", 6),
        ("es la caja de las ondas", "en another one", 7),
        ("en the left arm", "en", 12),
        ("gripper flange", "gripper", 11),
        ("- arm scara", "-", 10),
    ],
)
def test_what_is_wrong_with_a_name_a_hand_or_an_empty_place_is_told_with_its_line(old, new, line):  # R-B07, R-X19
    world, faults = read(CELL.replace(old, new), "cell", "f")
    assert world is None
    assert [fault.place.line for fault in faults] == [line]
