"""The grippers of a world from files, and what is in them."""

from kit.worlds.grasping_cells import AT_CUBE, Cell


def test_what_a_hand_is_closed_on_is_in_it():  # R-X19
    cell = Cell(has_forces=True)
    (arm,) = cell.world._stands.arms()
    cell.grip(0.06)
    assert cell.world._hands.held(arm, None) is None
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    assert cell.world._hands.held(arm, None) == "cube"
    assert len(cell.world._hands.ways) == 1
