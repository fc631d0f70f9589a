"""What of the box assembly does not stand where it began."""

import numpy as np
import pytest

from kit.worlds.assembler import Assembler
from kit.worlds.box_cells import boxes_world

SECOND = 1_000_000_000


@pytest.fixture
def world():
    world = boxes_world()
    world.claim("arm_left", 7)
    return world


def words(displaced, *, is_harmless=False):
    return [str(displacement.text) for displacement in displaced if displacement.is_harmless is is_harmless]


def test_at_the_start_and_where_things_only_settle_all_is_at_its_place(world):  # law 18
    world.step(SECOND)
    assert world.displaced() == ()
    shaken = boxes_world(5)
    shaken.claim("arm_left", 7)
    shaken.step(SECOND)
    assert shaken.displaced() == ()


def test_what_a_hand_holds_is_told_in_words_and_after_a_reset_all_is_as_it_was():  # law 18
    world = boxes_world()
    assembler = Assembler(world)
    for verb, argument in assembler.actions()[:5]:
        verb(argument)
    assert words(world.displaced()) == ["the hand holds the box with the triangle"]
    assert words(world.displaced(), is_harmless=True) == ["the arm does not stand as it began"]
    world.reset()
    assert world.displaced() == ()
    world.step(world.now_ns + SECOND)
    assert world.displaced() == ()


def test_a_box_that_is_elsewhere_or_turned_is_told_with_how_far(world):  # law 18
    boxes = {name: world._plant.data.joint(f"box_{name}.free").qpos for name in ("waves", "cross")}
    boxes["waves"][:2] += (0.03, 0.04)
    boxes["cross"][3:] = (np.cos(0.2), 0.0, 0.0, np.sin(0.2))
    assert words(world.displaced()) == [
        "the box with the waves is 5.0 cm from its place",
        "the box with the cross is turned",
    ]


def test_where_there_are_two_arms_it_is_said_which(world):  # law 18
    world.claim("scara_right", 8)
    world.step(SECOND)
    assert world.displaced() == ()
    world._plant.data.joint("right.joint1").qpos[0] += 0.3
    assert words(world.displaced(), is_harmless=True) == ["the right arm does not stand as it began"]
    assert words(world.displaced()) == []
    places = [str(place) for place in world.places()]
    assert places[1] == "the box with the triangle stands at x = 70.0 cm, y = 28.0 cm, z = -33.5 cm"
    assert places[-2:] == ["the left arm stands as it began", "the right arm stands as it began"]
