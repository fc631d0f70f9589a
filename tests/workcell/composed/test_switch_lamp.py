"""Lamps from files."""

from kit.worlds.file_cells import changed, files_of
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


def test_a_lamp_without_its_switch_is_left_out():  # R-B07, R-X19
    world = FileWorld(changed("world/cell.world", "NEAR cube.top", "NEAR cube.bottom"))
    assert "lamp" not in {sheet.name for sheet in world.devices()}
    assert [fault.place.line for fault in world.faults] == [18, 20]
