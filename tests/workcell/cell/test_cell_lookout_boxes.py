"""What is told of the box assembly as files, beside the class that it was first: the same, of the same devices."""

import numpy as np
import pytest

from kit.worlds.assembler import GRASP_M, Assembler, pose_at
from kit.worlds.box_cells import boxes_world
from onika.words.reason import in_language
from onika.workcell.boxes import BoxesWorld
from onika.workcell.layout import LAYOUT_M
from onika.workcell.table import TOP_M

OPEN, ABOVE, DOWN, CLOSE, LIFT = range(5)


def do(assembler, *numbers):
    actions = assembler.actions()
    for number in numbers:
        verb, argument = actions[number]
        verb(argument)


def drag(assembler):
    do(assembler, OPEN, ABOVE, DOWN, CLOSE)
    x, y = LAYOUT_M["triangle"]
    assembler.go(pose_at(x - 0.08, y, GRASP_M - 0.003))


def press(assembler):
    do(assembler, OPEN, ABOVE)
    assembler.go(pose_at(0.55, 0.18, TOP_M + 0.005))


def fall(assembler):
    world = assembler.world
    name = "box_cross" if isinstance(world, BoxesWorld) else "box_cross.free"
    world._plant.data.joint(name).qpos[:3] = 0.5, -0.9, -0.6
    world.step(world.now_ns + 400_000_000)


DONE = {
    "what is taken, carried and put down": lambda it: do(it, *range(9)),
    "a closed hand comes down on a box": lambda it: do(it, ABOVE, DOWN),
    "a hand closes on nothing": lambda it: do(it, OPEN, ABOVE, CLOSE),
    "a hand that only waves": lambda it: do(it, OPEN, CLOSE),
    "let go in the air": lambda it: do(it, OPEN, ABOVE, DOWN, CLOSE, LIFT, OPEN),
    "dragged along the table": drag,
    "a hand goes too deep": press,
    "a box on the floor": fall,
}


LIKE_OTHERS = {"a hand that only waves", "a hand goes too deep", "a hand closes on nothing"}
"""What small worlds of the tests show too: these wait for the long tests."""


@pytest.mark.parametrize(
    "done",
    [pytest.param(done, id=name, marks=pytest.mark.slow if name in LIKE_OTHERS else ()) for name, done in DONE.items()],
)
def test_the_same_is_told_of_the_same_devices(done):  # R-E16, R-X19
    told = []
    for world in (BoxesWorld(), boxes_world()):
        world.watch_mishaps()
        done(Assembler(world))
        mishaps = world.take_mishaps()
        told.append([(str(mishap.text), mishap.at_ns, mishap.devices) for mishap in mishaps])
        places = [str(displaced.text) for displaced in world.displaced()]
        told[-1] += [(place.partition(" stands ")[0], 0, ()) for place in places]
    assert told[0] == told[1]


def test_who_watches_changes_nothing():  # R-E16, law 14
    ends = []
    for is_watched in (False, True):
        world = boxes_world()
        if is_watched:
            world.watch_mishaps()
        Assembler(world).turn(np.array([0.3, -0.7, 2.9, 0.0, 1.0, 1.36]))
        ends.append(world.fingerprint())
    assert ends[0] == ends[1]


def test_without_forces_what_is_reached_into_is_told_in_two_languages():  # R-E16, R-X19, law 18
    world = boxes_world()
    world.watch_mishaps()
    world.claim("arm_left_kin", 1)
    place = world._plant.data.joint("box_square.free").qpos
    place[:3] = world._plant.data.body("left.link3").xpos
    world.step(10_000_000)
    (mishap,) = world.take_mishaps()
    assert str(mishap.text) == "the arm touches the box with the square"
    assert in_language(mishap.text, "es") == "el brazo toca la caja con el cuadrado"
