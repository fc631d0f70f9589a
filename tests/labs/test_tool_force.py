"""The force on the tool, as the servo feels it."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.robot import published
from onika.laws.textbook import serial_arm
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "tool_force.py"
CONSTANTS = published(puma560, 0.0, 0.0, 0.0, 0.0)
WORKING = np.array([0.18, -0.63, 2.70, 0.0, 1.07, 1.75])
ARM = serial_arm(puma560.DH, base=np.eye(4), tool=puma560.TOOL)


@pytest.mark.parametrize("force", [(0, 0, 20, 0, 0, 0), (10, -5, 0, 0, 0, 0), (0, 0, 0, 1, 2, 0.5)])
def test_what_the_servo_holds_against_is_what_presses_on_the_tool(force):  # R-D25
    bench = Bench(CODE, frequency=250, constants=CONSTANTS).init()
    bench["Q_MEZ"] = WORKING
    bench["TAU_PD"] = -ARM.jacobian(WORKING).T @ np.array(force, dtype=float)  # statics: the servo bears it
    assert bench.on()["F_MEZ"] == pytest.approx(force, abs=0.15 * np.linalg.norm(force))
    assert bench.cycle()["F_MEZ"] == pytest.approx(force, abs=0.15 * np.linalg.norm(force))


def test_a_stretched_arm_feels_no_force_without_end():  # R-D25
    stretched = np.array([0.0, 0.0, np.pi / 2, 0.0, 0.0, 0.0])
    bench = Bench(CODE, frequency=250, constants=CONSTANTS).init()
    bench["Q_MEZ"], bench["TAU_PD"] = stretched, np.ones(6)
    felt = bench.on()["F_MEZ"]
    assert np.isfinite(felt).all() and np.abs(felt).max() < 30.0


def test_without_torque_nothing_presses():
    bench = Bench(CODE, frequency=250, constants=CONSTANTS).init()
    bench["Q_MEZ"] = WORKING
    assert bench.on()["F_MEZ"].tolist() == [0.0] * 6
