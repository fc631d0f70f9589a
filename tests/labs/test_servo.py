"""The joint servo and what feeds it: pd, gravcomp, diff, torque_sum."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.robot import published
from onika.laws.textbook import serial_arm
from onika.store.shipped import shipped
from onika.testing.bench import Bench

GENERIC = shipped() / "generic" / "module"
GAINS = {"NDOF": 6, "KP": puma560.KP, "KD": puma560.KD}
MODEL = published(puma560, 0.0, 0.0, 0.0, 0.0)
STRETCHED = np.array([0.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0])


def test_the_servo_pulls_towards_the_reference_and_brakes():
    bench = Bench(GENERIC / "pd.py", frequency=500, constants=GAINS).init()
    bench["Q_REF"], bench["Q_MEZ"] = np.full(6, 0.3), np.full(6, 0.2)
    bench["Q^_REF"], bench["Q^_MEZ"] = np.full(6, 1.0), np.full(6, 1.5)
    expected = 0.1 * puma560.KP - 0.5 * puma560.KD
    assert bench.on()["TAU_PD"] == pytest.approx(expected)
    assert bench.cycle()["TAU_PD"] == pytest.approx(expected)


@pytest.mark.parametrize(("stiff", "damp"), [(0.1, 2.0), (1.0, 1.0), (1.7, 0.3)])
def test_stiffness_and_damping_of_the_servo_are_tuned_as_shares_of_the_robots_own(stiff, damp):  # R-B02
    bench = Bench(GENERIC / "pd.py", frequency=500, constants=GAINS, local={"STIFF": stiff, "DAMP": damp}).init()
    bench["Q_REF"], bench["Q_MEZ"] = np.full(6, 0.3), np.full(6, 0.2)
    bench["Q^_REF"], bench["Q^_MEZ"] = np.full(6, 1.0), np.full(6, 1.5)
    assert bench.on()["TAU_PD"] == pytest.approx(stiff * 0.1 * puma560.KP - damp * 0.5 * puma560.KD)
    braking = Bench(GENERIC / "pd.py", frequency=500, constants=GAINS, local={"STIFF": stiff, "DAMP": damp}).init()
    braking["Q^_MEZ"] = np.full(6, 1.5)
    assert braking.forget("Q_REF").on().cycle()["TAU_PD"] == pytest.approx(-damp * 1.5 * puma560.KD)


def test_the_servo_only_brakes_until_a_reference_is_in_force():  # law 3: nothing tears the arm away
    bench = Bench(GENERIC / "pd.py", frequency=500, constants=GAINS).init()
    bench["Q_REF"], bench["Q_MEZ"] = np.full(6, 2.0), np.zeros(6)
    bench["Q^_MEZ"] = np.full(6, 0.1)
    bench.forget("Q_REF").on().cycle(10)
    assert bench["TAU_PD"] == pytest.approx(-0.1 * puma560.KD)
    bench["Q_REF"] = np.full(6, 0.001)
    assert bench.cycle()["TAU_PD"] == pytest.approx(0.001 * puma560.KP - 0.1 * puma560.KD)


def test_the_model_holds_the_arm_against_gravity_and_friction():
    arm = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD)
    bench = Bench(GENERIC / "gravcomp.py", frequency=250, constants=MODEL).init()
    bench["Q_MEZ"] = STRETCHED
    assert bench.on()["TAU_G"] == pytest.approx(arm.bias(STRETCHED, np.zeros(6)))
    assert abs(bench["TAU_G"][1]) > 40.0  # the shoulder carries the stretched arm
    bench["Q^_MEZ"] = np.full(6, 0.5)
    expected = arm.bias(STRETCHED, np.full(6, 0.5)) + 0.5 * puma560.DYN[:, 8]
    assert bench.cycle()["TAU_G"] == pytest.approx(expected)


def test_the_derivative_of_a_ramp_is_its_slope_and_begins_at_rest():
    bench = Bench(GENERIC / "diff.py", frequency=500, constants={"NDOF": 2}, local={"CUTOFF": 50}).init()
    bench["Y"] = [5.0, -3.0]
    assert bench.on()["Y^"].tolist() == [0.0, 0.0]
    for k in range(500):
        bench["Y"] = [5.0 + 0.002 * k, -3.0 - 0.004 * k]
        bench.cycle()
    assert bench["Y^"] == pytest.approx([1.0, -2.0])


def test_torques_are_added():
    bench = Bench(GENERIC / "torque_sum.py", frequency=500, constants={"NDOF": 6}).init()
    bench["TAU_PD"], bench["TAU_G"] = np.arange(6.0), np.full(6, 10.0)
    assert bench.on()["TAU_REF"].tolist() == [10.0, 11.0, 12.0, 13.0, 14.0, 15.0]
    bench["TAU_PD"] = np.zeros(6)
    assert bench.cycle()["TAU_REF"].tolist() == [10.0] * 6
