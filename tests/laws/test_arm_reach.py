"""What modules of arms answer before anything moves."""

import numpy as np
import pytest

from kit.worlds.mjcf_arms import ARMS
from onika.laws import reach
from onika.laws.arm_identity import arm_constants
from onika.laws.arm_reach import ArmReach, DescribedArm

ARM = ARMS["six"]


class Driven(DescribedArm):
    driven_by = "torque"


def test_an_arm_answers_what_is_within_its_reach():  # law 26
    constants = arm_constants(ARM.identity("torque"))
    targets = [("joint object", [0.1] * 6), ("joint object", [9.0] * 6)]
    assert ArmReach.resolve(constants, targets) == reach.why_not(constants, targets)
    (pose,) = ArmReach.poses(constants, [[0.1] * 6])
    assert pose == pytest.approx(reach.poses(constants, [[0.1] * 6])[0])
    (posture,) = ArmReach.postures(constants, [pose])
    assert posture == pytest.approx(reach.postures(constants, [pose])[0])


def test_an_arm_that_its_device_describes_is_known_by_it():  # decision 5
    constants = Driven.constants(None, ARM.identity("torque"))
    assert constants["NDOF"] == 6 and np.array_equal(constants["HOME"], ARM.constants["HOME"])


def test_a_device_that_takes_other_commands_does_not_fit():  # decision 5
    assert Driven.fits(None, ARM.identity("torque")) is None
    assert "driven by torque, found one driven by position" in str(Driven.fits(None, ARM.identity("position")))
