"""What is in the way of an arm of the box assembly that begins to hold."""

import pytest

from kit.worlds.assembler import GRASP_M, Assembler, pose_at
from kit.worlds.box_cells import LAYOUT_M, TOP_M, boxes_world
from onika.ring.device import DeviceOrder


def words(reasons):
    return [str(reason) for reason in reasons]


def halted(world, device):
    """What is told of an arm that is commanded to hold now."""
    world.take_events()
    world.command(device, 1, DeviceOrder.HOLD, ())
    (told,) = (told for told in world.take_events() if told.device == device)
    return told


@pytest.fixture
def assembler():
    return Assembler(boxes_world())


def test_an_arm_that_holds_in_the_air_has_nothing_in_its_way_and_says_where_it_is(assembler):  # R-X06
    assembler.tick()
    told = halted(assembler.world, "arm_left")
    assert told.touches == ()
    assert str(told.stands).startswith("the hand stands at x = ")


def test_a_hand_that_presses_on_the_table_or_on_a_box_is_told_what_it_meets(assembler):  # R-X06, R-E16
    x, y = LAYOUT_M["waves"]
    assembler.turn(assembler.above("waves"))
    assembler.go(pose_at(x, y, TOP_M + 0.02))
    assert words(halted(assembler.world, "arm_left").touches) == ["the hand touches the box with the waves"]


def test_what_a_hand_carries_meets_is_told_and_the_box_in_the_hand_is_not(assembler):  # R-X06
    assembler.grip(1.0)
    assembler.turn(assembler.above("triangle"))
    assembler.go(pose_at(*LAYOUT_M["triangle"], GRASP_M))
    assembler.grip(-1.0)
    assembler.turn(assembler.above("triangle"))
    told = halted(assembler.world, "arm_left")
    assert told.touches == ()
    assembler.go(pose_at(*LAYOUT_M["triangle"], GRASP_M - 0.02))
    (met,) = words(halted(assembler.world, "arm_left").touches)
    assert met == "the box with the triangle in the hand touches the table"
