import numpy as np
import pytest

from kit.worlds.mjcf_arms import ARMS
from onika.laws.arm import ArmModel
from onika.laws.payload import PayloadEstimate

CONSTANTS = ARMS["seven"].constants
NAMES = ("SCREW", "LINK", "PARENT")
ALONE = ArmModel(*(CONSTANTS[name] for name in NAMES), None, CONSTANTS["BASE"], CONSTANTS["TOOL"])
CENTRE = ALONE.tool @ [0.02, -0.01, 0.05, 1.0]
LOAD = np.array([1.3, *CENTRE[:3]])
LADEN = ArmModel(*(CONSTANTS[name] for name in NAMES), LOAD, CONSTANTS["BASE"], CONSTANTS["TOOL"])


def learn(estimate, arm, count=200, noise=0.0):
    random, rest = np.random.default_rng(4), np.zeros(7)
    for q in random.uniform(-1.2, 1.2, (count, 7)):
        estimate.take(q, arm.bias(q, rest) - ALONE.bias(q, rest) + noise * random.normal(size=7))
    return estimate.load()


def test_mass_and_centre_of_what_is_held_are_learnt_from_some_postures():  # R-K05
    assert learn(PayloadEstimate(ALONE, 1e4), LADEN) == pytest.approx(LOAD, abs=2e-3)


def test_noise_is_averaged():
    assert learn(PayloadEstimate(ALONE, 1e4), LADEN, count=2000, noise=0.5) == pytest.approx(LOAD, abs=0.05)


def test_an_empty_hand_weighs_nothing_and_its_centre_is_the_tool():
    assert learn(PayloadEstimate(ALONE, 1e3), ALONE) == pytest.approx([0.0, *ALONE.tool[:3, 3]], abs=1e-9)


def test_what_was_held_before_is_forgotten():
    estimate = PayloadEstimate(ALONE, 50.0)
    learn(estimate, LADEN)
    assert learn(estimate, ALONE, count=600)[0] == pytest.approx(0.0, abs=1e-3)


def test_a_posture_that_tells_nothing_for_long_keeps_numbers_finite():
    estimate, q, rest = PayloadEstimate(ALONE, 20.0), np.zeros(7), np.zeros(7)
    for _ in range(3000):
        estimate.take(q, LADEN.bias(q, rest) - ALONE.bias(q, rest))
    assert np.isfinite(estimate.load()).all()
    estimate.reset()
    assert estimate.load()[0] == 0.0
