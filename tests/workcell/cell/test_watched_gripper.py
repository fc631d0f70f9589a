"""The fingers of a gripper as they are watched, and an arm that meets itself."""

import pytest

from kit.worlds.file_cells import CELL, files_of
from kit.worlds.grasping_cells import AT_CUBE, Cell
from onika.ring.device import DeviceOrder
from onika.workcell.cell.file_world import FileWorld


def told(cell):
    return [str(mishap.text) for mishap in cell.world.take_mishaps()]


@pytest.mark.parametrize("has_forces", [True, False])
def test_what_is_taken_and_put_down_is_meant_and_what_is_let_go_in_the_air_is_told(has_forces):  # R-E16, R-X19
    cell = Cell(has_forces=has_forces)
    cell.world.watch_mishaps()
    cell.grip(0.06)
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    cell.go(0.0, 0.0, 0.0)
    assert told(cell) == []
    assert str(cell.world.displaced()[0].text) == f"the hand of {cell.arm} holds the red cube"
    cell.grip(0.06)
    assert f"the hand of {cell.arm} lets the red cube go in the air" in told(cell)


@pytest.mark.parametrize("has_forces", [True, False])
def test_a_hand_that_comes_to_close_on_nothing_is_empty(has_forces):  # R-E16, R-X19
    cell = Cell(has_forces=has_forces)
    cell.world.watch_mishaps()
    cell.opening = 0.0
    cell.go(0.0, 0.0, 0.0)
    cell.grip(0.06)
    cell.grip(0.0)
    assert told(cell) == []
    cell.grip(0.06)
    cell.go(0.5, 0.0, 0.0)
    cell.grip(0.0)
    assert told(cell) == [f"the hand of {cell.arm} closes on nothing: it is empty"]


def test_a_hand_that_loses_what_it_holds_is_told():  # R-E16, R-X19
    cell = Cell(has_forces=True)
    cell.world.watch_mishaps()
    cell.grip(0.06)
    cell.go(*AT_CUBE)
    cell.grip(0.0)
    cell.go(0.0, 0.0, 0.0)
    cell.world._plant.data.joint("cube.free").qpos[0] += 0.3
    cell.tick(100)
    assert "the hand of elbow_left loses the red cube" in told(cell)


FOLDING = """<mujoco><compiler angle="radian"/><worldbody><body name="a">
<joint name="j1" axis="0 1 0" range="-3 3" armature="0.1"/><geom type="capsule" size="0.02" fromto="0 0 1 0.2 0 1"/>
<body name="b" pos="0.2 0 1"><joint name="j2" axis="0 0 1" range="-3.1 3.1" armature="0.1"/>
<geom type="capsule" size="0.02" fromto="0.05 0 0 0.2 0 0"/>
<body name="c" pos="0.2 0 0"><joint name="j3" axis="0 0 1" range="-3.1 3.1" armature="0.1"/>
<geom type="capsule" size="0.02" fromto="0.05 0 0 0.2 0 0"/>
<body name="d" pos="0.2 0 0"><joint name="j4" axis="0 0 1" range="-3.1 3.1" armature="0.1"/>
<geom type="capsule" size="0.02" fromto="0.05 0 0 0.2 0 0"/><site name="tip" pos="0.2 0 0"/>
</body></body></body></body></worldbody></mujoco>"""


def test_an_arm_that_meets_itself_is_told_once():  # R-E16, R-X19
    robot = "VERSION 2.0\nFILE fold.xml\nARM arm\nTOOL tip\nHOME 0 0.1 0.1 0.1\nEOF\n"
    world = FileWorld(files_of({**CELL, "robot/elbow.robot": robot, "robot/fold.xml": FOLDING}))
    world.watch_mishaps()
    world.claim("elbow_left_kin", 1)
    for k in range(700):
        world.command("elbow_left_kin", 1, DeviceOrder.DRIVE, [0.0, *[0.1 + 1.9 * min(k / 600, 1.0)] * 3])
        world.step(world.now_ns + world.step_ns)
    assert [str(mishap.text) for mishap in world.take_mishaps()] == ["elbow_left_kin meets itself"]
