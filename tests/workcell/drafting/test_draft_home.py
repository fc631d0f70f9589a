"""The home that is guessed of an arm: a keyframe, zero, else where the arm does not meet itself (X19)."""

import mujoco
import numpy as np
import pytest

from onika.workcell.drafting.draft_chain import draft_chain
from onika.workcell.drafting.draft_home import draft_home

FOLDED = """
<mujoco><worldbody><body name="base">
<geom type="box" size="0.05 0.05 0.1"/>
<body name="upper" pos="0 0 0.15"><joint name="a" axis="0 1 0" range="-170 170"/>
<geom type="capsule" size="0.02" fromto="0 0 0.05 0 0 0.3"/>
<body name="lower" pos="0 0 0.3"><joint name="b" axis="0 1 0" range="-170 170"/>
<geom type="capsule" size="0.02" fromto="0 0 -0.05 0 0 {end}"/>
</body></body></body></worldbody>
<actuator><motor joint="a"/><motor joint="b"/></actuator>{key}</mujoco>
"""
KEY = '<keyframe><key name="home" qpos="0.2 -0.3"/></keyframe>'


def home(end, key="", is_apart=False):
    model = mujoco.MjModel.from_xml_string(FOLDED.format(end=end, key=key))
    return draft_home(model, draft_chain(model), is_apart=is_apart)


def test_zero_is_home_where_the_arm_is_free_there():  # R-X19
    guess = home(0.3)
    assert guess.values.tolist() == [0.0, 0.0] and guess.is_usual
    assert guess.origin.key == "workcell.draft_home_zero"


def test_an_arm_that_reaches_into_its_base_at_zero_begins_where_it_does_not():  # R-X19
    guess = home(-0.5)
    assert guess.origin.key == "workcell.draft_home_free" and not guess.is_usual
    assert np.abs(guess.values).max() > 0.1
    assert np.array_equal(guess.values, home(-0.5).values)  # the same arm, the same home


@pytest.mark.parametrize("end", [0.3, -0.5])
def test_a_keyframe_that_is_called_home_is_taken_as_it_is(end):  # R-X19
    guess = home(end, KEY)
    assert guess.values.tolist() == [0.2, -0.3] and guess.origin.key == "workcell.draft_home_key"


def test_where_bodies_that_touch_at_home_are_kept_apart_zero_is_good():  # R-X19
    assert home(-0.5, is_apart=True).values.tolist() == [0.0, 0.0]
