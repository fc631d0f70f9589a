"""What is told of the box assembly, whose arms take and carry boxes."""

import numpy as np

from kit.worlds.assembler import GRASP_M, Assembler, pose_at
from kit.worlds.box_cells import LAYOUT_M, TOP_M, boxes_world
from onika.words.reason import in_language

OPEN, ABOVE, DOWN, CLOSE, LIFT = range(5)
PLACED = range(9)
"""The actions that put the first box on the stack."""


class Watched:
    """A world that is watched, and whoever moves its left arm through actions of the assembly."""

    def __init__(self, *numbers):
        self.world = boxes_world()
        self.world.watch_mishaps()
        self.assembler = Assembler(self.world)
        self.do(*numbers)

    def do(self, *numbers):
        actions = self.assembler.actions()
        for number in numbers:
            verb, argument = actions[number]
            verb(argument)
        return self

    @property
    def said(self):
        return [str(mishap.text) for mishap in self.world.take_mishaps()]


def test_what_is_taken_carried_and_put_down_is_meant():  # R-E16
    watched = Watched(*PLACED)
    assert watched.said == []
    assert str(watched.world.standing()[0]) == "the lamp is dark"


def test_a_closed_hand_that_comes_down_on_a_box_is_told_with_its_instant():  # R-E16
    watched = Watched(ABOVE, DOWN)
    first, *_ = watched.world.take_mishaps()
    assert str(first.text) == "the hand touches the box with the triangle"
    assert first.devices == ("arm_left", "gripper_left")
    assert 0 < first.at_ns <= watched.world.now_ns
    assert len(first.poses) == watched.world.poses().nbytes
    assert first.poses != watched.world.poses().tobytes()


def test_a_hand_that_comes_to_close_on_nothing_is_empty_and_one_that_waves_is_not():  # R-E16
    watched = Watched(OPEN, CLOSE)
    assert watched.said == []
    assert watched.do(OPEN, ABOVE, CLOSE).said == ["the hand closes on nothing: it is empty"]


def test_a_box_that_is_let_go_in_the_air_is_told():  # R-E16
    assert (
        Watched(OPEN, ABOVE, DOWN, CLOSE, LIFT, OPEN).said[0] == "the hand lets the box with the triangle go in the air"
    )


def test_a_box_that_is_dragged_along_the_table_is_told_once():  # R-E16
    watched = Watched(OPEN, ABOVE, DOWN, CLOSE)
    x, y = LAYOUT_M["triangle"]
    watched.assembler.go(pose_at(x - 0.08, y, GRASP_M - 0.003))  # lower than it was taken: it cannot come off the table
    assert watched.said == ["the box with the triangle in the hand touches the table"]


def test_a_hand_that_goes_too_deep_touches_the_table():  # R-E16
    watched = Watched(OPEN, ABOVE)
    watched.assembler.go(pose_at(0.55, 0.18, TOP_M + 0.005))
    assert "the hand touches the table" in watched.said


def test_arms_that_meet_are_told_by_their_sides():  # R-E16
    watched = Watched()
    other = Assembler(watched.world, "right", epoch=2)
    watched.assembler.turn(watched.assembler.above("waves"))
    other.turn(other.above("waves"))
    said = watched.said
    assert any(" meets " in sentence and "left" in sentence and "right" in sentence for sentence in said)


def test_where_there_are_no_forces_what_is_reached_into_is_told():  # R-E16, law 18
    world = boxes_world()
    world.watch_mishaps()
    world.claim("arm_left_kin", 1)
    place = world._plant.data.joint("box_square.free").qpos
    place[:3] = world._plant.data.body("left.link3").xpos
    world.step(10_000_000)
    (mishap,) = world.take_mishaps()
    assert str(mishap.text) == "the arm touches the box with the square"
    assert in_language(mishap.text, "es") == "el brazo toca la caja con el cuadrado"


def test_a_box_on_the_floor_is_told_where_it_was_not_there_at_first():  # R-E16
    world = boxes_world()
    world.watch_mishaps()
    world.claim("arm_left", 1)
    world._plant.data.joint("box_cross.free").qpos[:3] = 0.5, -0.9, -0.6
    world.step(400_000_000)
    assert [(str(mishap.text), mishap.devices) for mishap in world.take_mishaps()] == [
        ("the box with the cross falls to the floor", ())
    ]


def test_who_watches_changes_nothing():  # R-E16, law 14
    ends = []
    for is_watched in (False, True):
        world = boxes_world()
        if is_watched:
            world.watch_mishaps()
        Assembler(world).turn(np.array([0.3, -0.7, 2.9, 0.0, 1.0, 1.36]))
        ends.append(world.fingerprint())
    assert ends[0] == ends[1]
