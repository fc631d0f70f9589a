import numpy as np
import pytest

from kit.worlds.mjcf_arms import ARMS
from onika.laws.arm_identity import arm_constants, axes_constants, driven_otherwise

SEVEN = ARMS["seven"]
SAID = SEVEN.identity("torque")


@pytest.mark.parametrize("name", sorted(ARMS))
def test_the_constants_of_an_arm_are_what_its_device_says(name):  # R-X19, decision 5
    arm = ARMS[name]
    constants = arm_constants(arm.identity("position"))
    assert constants["NDOF"] == arm.n and constants["ROBOT"] == "small"
    for key, value in arm.constants.items():
        assert np.array_equal(constants[key], value) and np.shape(constants[key]) == np.shape(value), key
    assert constants["LOAD"].tolist() == [0.0] * 4


def test_a_device_that_is_no_arm_is_told():
    with pytest.raises(ValueError, match="expected an arm behind the device, found gripper"):
        arm_constants({"ROBOT": "gripper"})
    with pytest.raises(ValueError, match="found another device"):
        arm_constants({})


def test_what_an_arm_does_not_say_is_named_at_once():
    said = {name: value for name, value in SAID.items() if name not in ("TOOL", "HOME")}
    with pytest.raises(ValueError, match="to say its HOME TOOL"):
        arm_constants(said)
    with pytest.raises(ValueError, match=r"expected \(7,\) numbers"):
        arm_constants(SAID | {"QMAX": (1.0,) * 6})


def test_axes_without_a_chain_say_their_limits():
    constants = axes_constants({"QMIN": (0.0, 0.0), "QMAX": (1.0, 2.0), "Q^_MAX": (3.0, 3.0), "HOME": (0.5, 0.5)})
    assert constants["NDOF"] == 2 and constants["QMAX"].tolist() == [1.0, 2.0]
    with pytest.raises(ValueError, match="to say its QMAX"):
        axes_constants({"QMIN": (0.0,), "Q^_MAX": (1.0,), "HOME": (0.0,)})


def test_a_device_that_is_driven_otherwise_is_told():
    assert driven_otherwise(SAID, "torque") is None
    assert (
        driven_otherwise(SAID, "velocity") == "expected a device that is driven by velocity, found one driven by torque"
    )
    assert driven_otherwise({}, "torque").endswith("driven by -")
