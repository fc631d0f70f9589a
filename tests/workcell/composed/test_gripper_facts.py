"""What is known of a gripper."""

from dataclasses import replace

import mujoco
import pytest

from kit.worlds.file_cells import ARM
from onika.model.robot import RobotGripper
from onika.workcell.composed.gripper_facts import gripper_facts

HAND = RobotGripper("gripper", ("squeeze",), (0.03, 0.06), (0.0, 0.0))


@pytest.fixture
def model():
    return mujoco.MjModel.from_xml_string(ARM)


def test_two_signals_say_how_a_gripper_moves(model):  # R-X19
    facts = gripper_facts(model, HAND, "elbow")
    assert facts.lengths == pytest.approx((0.0, 0.03))
    assert facts.leverage == pytest.approx(0.5)
    assert facts.force == pytest.approx(10.0)
    assert facts.constants == {"ROBOT": "elbow", "OPEN": (0.06,), "CLOSED": (0.0,), "FORCE": (facts.force,)}


def test_a_gripper_that_is_pulled_goes_to_the_ends_of_its_way(model):
    facts = gripper_facts(model, replace(HAND, moves=("lift",), open=(50.0, 0.1), closed=(-50.0, 0.0)), "elbow")
    assert facts.lengths == pytest.approx((-0.1, 0.1))
    assert facts.force == pytest.approx(50.0 * 2.0)


@pytest.mark.parametrize(
    ("hand", "keyword", "key"),
    [
        (replace(HAND, moves=("hold",)), "MOVES", "workcell.no_such_name"),
        (replace(HAND, force=("pad",)), "FORCE", "workcell.no_such_name"),
        (replace(HAND, moves=("lift",), open=(2.0, 0.1), closed=(1.0, 0.0)), "OPEN", "workcell.gripper_still"),
    ],
)
def test_what_is_not_in_the_model_is_told_with_its_line(model, hand, keyword, key):  # R-B07, R-X19
    unfit = gripper_facts(model, hand, "elbow")
    assert (unfit.keyword, unfit.reason.key) == (keyword, key)


def test_motors_are_led_along_their_way_and_what_knows_its_places_is_not(model):  # R-X19
    assert gripper_facts(model, HAND, "elbow").ways == (None,)
    pulled = replace(HAND, moves=("lift",), open=(50.0, 0.1), closed=(-50.0, 0.0))
    assert gripper_facts(model, pulled, "elbow").ways == (pytest.approx((-0.1, 0.1)),)
    air = ARM.replace('<motor name="lift" joint="lift"', '<general name="lift" joint="lift" dyntype="filter"')
    assert gripper_facts(mujoco.MjModel.from_xml_string(air), pulled, "elbow").ways == (None,)
