"""Touch sensors where there are no forces."""

from kit.worlds.grasping_cells import AT_CUBE, Cell


def test_a_switch_is_pressed_by_what_stands_on_its_sensor():  # law 18, R-X19
    cell = Cell()
    cell.grip(0.06)
    assert cell.world.state("lamp")[2] == 1.0
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    cell.go(0.0, 0.0, 0.0)
    assert cell.world.state("lamp")[2] == 0.0
    cell.grip(0.06)
    assert cell.world.state("lamp")[2] == 1.0
