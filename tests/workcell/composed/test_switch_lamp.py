"""Lamps from files."""

import pytest

from kit.worlds.file_cells import CUBE, changed, files_of
from onika.workcell.cell.file_world import FileWorld


def test_a_lamp_shines_while_its_switches_are_closed():  # R-X19
    world = FileWorld(files_of())
    world.step(100_000_000)
    assert (world.state("lamp")[2], world.lit) == (1.0, ("cube.cube",))
    assert [str(sentence) for sentence in world.standing()] == ["lamp is lit"]
    far = FileWorld(changed("world/cell.world", "patch 0.05", "patch 0.001"))
    far.step(100_000_000)
    assert (far.state("lamp")[2], far.lit) == (0.0, ())


def test_a_switch_may_have_to_be_pressed():  # R-X19
    pressed = FileWorld(changed("world/cell.world", "patch 0.05", "patch 0.05\nPRESSED table.patch 0.5"))
    pressed.step(500_000_000)
    assert pressed.state("lamp")[2] == 1.0
    heavy = FileWorld(changed("world/cell.world", "patch 0.05", "patch 0.05\nPRESSED table.patch 5"))
    heavy.step(500_000_000)
    assert heavy.state("lamp")[2] == 0.0


def lit_when(line, sensors=""):
    """The lamp of a world whose switch says this, half a second later; sensors are those of the cube."""
    files = changed("world/cell.world", "NEAR cube.top table.patch 0.05", line)
    cube = CUBE.replace("</worldbody>", f"</worldbody><sensor>{sensors}</sensor>")
    world = FileWorld(files_of({**{file.name: file.content.decode() for file in files.files}, "world/cube.xml": cube}))
    world.step(500_000_000)
    return world


@pytest.mark.parametrize(("bound", "is_lit"), [("0.055 2", True), ("0.09 2", False), ("-0.8 1", False), ("-1 1", True)])
def test_a_switch_may_want_a_number_above_a_bound(bound, is_lit):  # R-X19
    place = '<framepos name="where" objtype="site" objname="top"/>'
    assert lit_when(f"ABOVE cube.where {bound}", place).state("lamp")[2] == is_lit


@pytest.mark.parametrize(
    ("line", "key"),
    [("ABOVE cube.where 0 3", "workcell.sensor_number"), ("ABOVE cube.there 0", "workcell.no_such_name")],
)
def test_a_number_that_no_sensor_has_is_told_with_its_line(line, key):  # R-B07, R-X19
    first, *_ = lit_when(line, '<framepos name="where" objtype="site" objname="top"/>').faults
    assert (first.reason.key, first.place.line) == (key, 18)


def test_a_switch_may_be_touched_by_a_hand():  # R-X19
    world = lit_when("TOUCHED")
    assert (world.state("lamp")[2], [*world.parts()]) == (0.0, ["panic", "rests"])
    for value, until_ns in ((1.0, 520_000_000), (0.0, 560_000_000)):
        world.touch("rests", value)
        world.step(until_ns)
        assert world.state("lamp")[2] == value


def test_all_lines_of_a_switch_have_to_hold():  # R-X19
    world = lit_when("NEAR cube.top table.patch 0.05\nPRESSED table.patch 0.5\nTOUCHED")
    assert world.state("lamp")[2] == 0.0
    world.touch("rests", 1.0)
    world.step(540_000_000)
    assert world.state("lamp")[2] == 1.0


def test_a_lamp_without_its_switch_is_left_out():  # R-B07, R-X19
    world = FileWorld(changed("world/cell.world", "NEAR cube.top", "NEAR cube.bottom"))
    assert "lamp" not in {sheet.name for sheet in world.devices()}
    assert [fault.place.line for fault in world.faults] == [18, 20]
