"""What a gripper of a file takes along where there are no forces, and where it lays it down."""

import pytest

from kit.worlds.grasping_cells import AT_CUBE, TOP, Cell


def taken(cell):
    cell.grip(0.06)
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    return cell


def test_fingers_stop_at_what_they_close_on_and_it_goes_with_the_hand():  # law 18, R-X19
    cell = taken(Cell())
    hand = cell.world.state("gripper_left")
    assert hand[2] == pytest.approx(0.04, abs=1e-6)
    assert hand[4] > 0.0
    cell.go(0.3, 0.0, 0.0)
    assert cell.place("cube")[2] == pytest.approx(0.30, abs=1e-6)


def test_what_is_let_go_comes_to_rest_on_the_table_or_on_what_stands_there():  # law 18, R-X19
    cell = taken(Cell())
    cell.go(0.0, 0.0, 0.0)
    cell.grip(0.06)
    assert cell.place("cube") == pytest.approx([0.55, 0.0, TOP + 0.02], abs=1e-6)
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    cell.go(0.0, 0.0, 0.05)
    cell.world._plant.data.joint("other.free").qpos[:2] = cell.place("cube")[:2]
    cell.grip(0.06)
    assert cell.place("cube")[2] == pytest.approx(TOP + 0.06, abs=1e-6)


def test_what_stands_on_it_comes_along():  # law 18, R-X19
    cell = Cell()
    cell.world._plant.data.joint("other.free").qpos[:3] = (0.55, 0.0, TOP + 0.06)
    taken(cell)
    cell.go(0.0, 0.0, 0.0)
    assert cell.place("other")[2] - cell.place("cube")[2] == pytest.approx(0.04, abs=1e-6)
    assert cell.place("cube")[2] > TOP + 0.05


def test_a_part_nearly_square_is_squared_and_centred_and_one_askew_is_left():  # law 18, R-X19
    square = taken(Cell(15.0))
    assert square.world._plant.data.joint("cube.free").qpos[3] == pytest.approx(1.0, abs=1e-9)
    askew = taken(Cell(45.0))
    assert askew.world.state("gripper_left")[2] == pytest.approx(0.0565685, abs=1e-6)
    assert askew.world._plant.data.joint("cube.free").qpos[3] < 0.95


def test_a_part_too_wide_or_too_far_is_left_where_it_is():  # law 18, R-X19
    cell = Cell()
    cell.world._plant.data.joint("cube.free").qpos[0] += 0.02
    cell.world._plant.data.joint("plate.free").qpos[:3] = (0.55, 0.0, TOP + 0.01)
    taken(cell)
    assert cell.world.state("gripper_left")[2] == pytest.approx(0.0, abs=1e-6)
    cell.go(0.0, 0.0, 0.0)
    assert cell.place("plate")[2] == pytest.approx(TOP + 0.01, abs=1e-6)


def test_a_hand_keeps_what_it_holds_when_forces_are_taken():  # law 18, R-X19
    cell = taken(Cell(has_forces=True))
    cell.go(0.0, 0.0, -0.02)
    held = cell.place("cube")[2]
    assert held > TOP + 0.05
    cell.world.release(cell.arm, 1)
    cell.world.claim("elbow_left_kin", 1)
    cell.arm, cell.has_forces = "elbow_left_kin", False
    cell.go(0.0, 0.0, 0.0)
    assert cell.place("cube")[2] == pytest.approx(held + 0.02, abs=2e-3)
