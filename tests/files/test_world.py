"""Files of worlds: what is wrong with a line is told with its number; see `contract/test_formats` for the rest."""

import pytest

from onika.files.world import read, write
from onika.model.world import PartBlock, PlaceBlock, Spot

CUBES = """VERSION     2.0
DESC        an arm at a table
FLOOR       0

PART        table
FILE        table.xml
AT          0.55 0 0.2 90

# it moves
PART        cube
FILE        cube.xml
ON          table.top
FREE        0.001

PLACE       left
ROBOTS      panda scara

SWITCH      contact
NEAR        cube.foot table.patch 0.006
PRESSED     table.patch 0.02

LAMP        lamp
WHEN        contact
SHINES      table.bulb

BUTTON      panic
STOPS       left

EOF
"""


@pytest.mark.parametrize("line", ["ABOVE       table.height 0.3", "ABOVE       table.height -0.3 2", "TOUCHED"])
def test_a_switch_says_what_closes_it(line):  # R-X19
    text = CUBES.replace("PRESSED     table.patch 0.02", line)
    world, faults = read(text, "cubes", "f")
    assert faults == ()
    assert line in write(world).splitlines()
    assert read(write(world), "cubes", "f")[0] == world


@pytest.mark.parametrize("line", ["ABOVE table.height", "ABOVE table.height 0.3 1.5", "ABOVE table.height 0.3 -1"])
def test_a_number_of_a_sensor_is_counted_from_0(line):  # R-B07, R-X19
    world, (fault,) = read(CUBES.replace("PRESSED     table.patch 0.02", line), "cubes", "f")
    assert (world, fault.place.line) == (None, 20)


def test_a_world_is_what_stands_where():  # R-X19
    world, faults = read(CUBES, "cubes", "f")
    assert faults == ()
    assert world.parts == (
        PartBlock("table", "table.xml", Spot((0.55, 0.0, 0.2, 90.0))),
        PartBlock("cube", "cube.xml", Spot(on="table.top"), 0.001),
    )
    assert world.places == (PlaceBlock("left", ("panda", "scara")),)
    assert (world.switches[0].near, world.lamps[0].when) == (("cube.foot", "table.patch", 0.006), ("contact",))
    assert (world.buttons[0].stops, world.robots, world.floor) == (("left",), ("panda", "scara"), 0.0)


def test_comments_stay_where_they_are():  # R-B01
    world, _ = read(CUBES, "cubes", "f")
    assert write(world, CUBES) == CUBES


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("2.0", "1.3", 1, "files.version_of_ours"),
        ("FLOOR       0", "STEP 0.1", 3, "files.step_outside"),
        ("FLOOR       0", "STEP soon", 3, "files.meaning_after"),
        ("FLOOR       0", "CONTACT round 1", 3, "files.cone_unknown"),
        ("FLOOR       0", "CONTACT elliptic", 3, "files.meaning_after"),
        ("AT          0.55 0 0.2 90", "AT 0.55 0 0.2", 7, "files.meaning_after"),
        ("ON          table.top", "ON shelf.top", 12, "files.no_such_part"),
        ("ON          table.top", "ON table", 12, "files.no_such_part"),
        ("ON          table.top", "ON cube.top", 12, "files.stands_on_itself"),
        ("AT          0.55 0 0.2 90", "ON cube.top", 7, "files.stands_on_itself"),
        ("FREE        0.001", "FREE far", 13, "files.meaning_after"),
        ("ROBOTS      panda scara", "ROBOTS panda 9", 16, "files.no_name_of_robot"),
        ("ROBOTS      panda scara", "ROBOTS", 16, "files.meaning_after"),
        (
            "NEAR        cube.foot table.patch 0.006\nPRESSED     table.patch 0.02\n",
            "",
            18,
            "files.switch_without_contact",
        ),
        ("WHEN        contact", "WHEN touch", 23, "files.name_unknown"),
        ("STOPS       left", "STOPS right", 27, "files.name_unknown"),
        ("BUTTON      panic", "BUTTON lamp", 26, "files.name_twice"),
    ],
)
def test_what_is_wrong_is_told_with_its_line_and_the_world_is_left_out(old, new, line, key):  # R-B07, R-X19
    world, faults = read(CUBES.replace(old, new, 1), "cubes", "f")
    assert world is None
    assert (line, key) in [(fault.place.line, fault.reason.key) for fault in faults]
