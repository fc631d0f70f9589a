import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.chain import kinds_of
from onika.laws.textbook import serial_arm

ARM = serial_arm(adept_one.DH, adept_one.DYN, adept_one.LOAD, tool=adept_one.TOOL)


def test_it_turns_turns_slides_and_turns():  # R-K03
    assert kinds_of(adept_one.DH).tolist() == [0, 0, 1, 0]


def test_stretched_it_reaches_eight_hundred_millimetres_with_its_hand_down():
    pose = ARM.forward(np.zeros(4))
    assert pose[:3, 3] == pytest.approx([0.8, 0.0, 0.30 - 0.24 - 0.13])
    assert pose[:3, 2] == pytest.approx([0.0, 0.0, -1.0])


def test_joint_three_counts_downwards_in_metres():
    up, down = (ARM.forward([0.3, 0.4, q, 0.0])[:3, 3] for q in (0.0, 0.2))
    assert up - down == pytest.approx([0.0, 0.0, 0.2])


def test_only_the_quill_carries_weight():
    hanging = adept_one.DYN[2:, 0].sum() + adept_one.LOAD[0]
    assert ARM.bias(adept_one.HOME, np.zeros(4)) == pytest.approx([0.0, 0.0, -9.81 * hanging, 0.0], abs=1e-9)


def test_it_starts_within_its_limits_and_the_motors_carry_it():
    assert (adept_one.QMIN <= adept_one.HOME).all()
    assert (adept_one.HOME <= adept_one.QMAX).all()
    assert (np.abs(ARM.bias(adept_one.HOME, np.zeros(4))) < 0.5 * adept_one.TAUMAX).all()


def test_it_has_the_pumas_hand():
    assert np.array_equal(adept_one.TOOL, puma560.TOOL)
    assert np.array_equal(adept_one.LOAD, puma560.LOAD)
