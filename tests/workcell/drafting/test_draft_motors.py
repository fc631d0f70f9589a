"""Arms of which only the hand is driven."""

import mujoco
import pytest

from kit.worlds.file_cells import ARM
from onika.workcell.drafting.draft_chain import draft_chain
from onika.workcell.drafting.draft_motors import undriven

MOTORS = ARM[ARM.index('    <motor name="turn"') : ARM.index('    <position name="squeeze"')]
HAND_ONLY = ARM.replace(MOTORS, "")
TENDON = '<tendon><fixed name="pull"><joint joint="finger1" coef="1"/></fixed></tendon>'


def found(text):
    model = mujoco.MjModel.from_xml_string(text)
    return undriven(model, draft_chain(model))


@pytest.mark.parametrize(
    "text",
    [
        HAND_ONLY,
        HAND_ONLY.replace("finger1", "left").replace("finger2", "right"),
        HAND_ONLY.replace("<actuator>", f"{TENDON}<actuator>").replace('joint="finger1" kp', 'tendon="pull" kp'),
    ],
)
def test_an_arm_of_which_only_the_hand_is_driven_lacks_motors(text):  # R-X19
    assert found(text) == ("turn", "bend", "lift")


def test_one_that_is_driven_lacks_none_nor_does_one_that_hangs_at_loose_joints():  # R-X19
    assert found(ARM) == ()
    assert found(ARM.replace('<motor name="turn" joint="turn" ctrlrange="-40 40"/>', "")) == ()
    nothing = HAND_ONLY.replace(HAND_ONLY[HAND_ONLY.index("  <actuator>") : HAND_ONLY.index("</mujoco>")], "")
    assert found(nothing) == ()  # all of them get motors where the world is composed
