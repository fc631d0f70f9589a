import numpy as np
import pytest

from kit.worlds.mjcf_arms import ARMS
from onika.laws.arm import ArmModel
from onika.laws.resolved_rate import LEAST, ResolvedRate

DT = 0.004


def law_of(name, homing=0.0, **other):
    constants = ARMS[name].constants | other
    arm = ArmModel(constants["SCREW"], parent=constants["PARENT"], base=constants["BASE"], tool=constants["TOOL"])
    limits = (constants[key] for key in ("QMIN", "QMAX", "Q^_MAX", "HOME"))
    return arm, ResolvedRate(arm, *limits, homing)


@pytest.mark.parametrize("name", ["seven", "six"])
def test_the_tool_has_the_twist_that_was_wanted(name):  # R-X19
    arm, law = law_of(name, homing=1.0)
    random = np.random.default_rng(1)
    for q in random.uniform(0.3, 0.9, (20, arm.n)):
        twist = random.uniform(-0.05, 0.05, 6)
        speeds = law.speeds(q, twist, DT)
        if np.linalg.svd(arm.jacobian(q))[1][-1] > LEAST:
            assert arm.jacobian(q) @ speeds == pytest.approx(twist, abs=1e-9)


def test_joints_that_the_tool_does_not_feel_go_home():
    arm, law = law_of("seven", homing=2.0)
    home = ARMS["seven"].constants["HOME"]
    q = home + np.array([0.3, 0.2, -0.3, 0.4, 0.2, -0.2, 0.1])
    start, away = arm.forward(q), np.linalg.norm(q - home)
    for _ in range(2000):
        q = q + DT * law.speeds(q, np.zeros(6), DT)
    assert np.linalg.norm(q - home) < away - 0.05
    assert np.abs(arm.forward(q) - start).max() < 2e-3


@pytest.mark.parametrize("name", sorted(ARMS))
def test_no_joint_passes_its_limits_or_its_speed_whatever_is_wanted(name):  # R-X19
    _arm, law = law_of(name, homing=1.0)
    low, high, most = (ARMS[name].constants[key] for key in ("QMIN", "QMAX", "Q^_MAX"))
    random = np.random.default_rng(2)
    q = ARMS[name].constants["HOME"].copy()
    twists = np.repeat(random.uniform(-3.0, 3.0, (15, 6)), 100, axis=0)
    for twist in twists:
        speeds = law.speeds(q, twist, DT)
        assert np.isfinite(speeds).all() and (np.abs(speeds) <= most + 1e-9).all()
        q = q + DT * speeds
        assert (q >= low - 1e-12).all() and (q <= high + 1e-12).all()


def test_a_tool_that_is_too_fast_is_slowed_down_in_its_direction():
    arm, law = law_of("six")
    q = np.array([0.4, 0.3, 0.9, 0.5, 1.1, 0.2])
    assert np.linalg.svd(arm.jacobian(q))[1][-1] > LEAST
    twist = np.array([5.0, 2.0, -3.0, 0.0, 0.0, 0.0])
    reached = arm.jacobian(q) @ law.speeds(q, twist, DT)
    assert reached == pytest.approx(twist * np.linalg.norm(reached) / np.linalg.norm(twist), abs=1e-9)
    assert 0.01 < np.linalg.norm(reached) < np.linalg.norm(twist)


def test_speeds_stay_small_where_the_arm_is_stretched():
    _arm, law = law_of("five", **{"Q^_MAX": np.full(5, 1e6)})
    speeds = law.speeds(np.array([0.2, 0.0, 0.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.1, 0.0, 0.0, 0.0]), DT)
    assert np.abs(speeds).max() < 5.0
