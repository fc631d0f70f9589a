"""Torque from outside, seen in the momentum of an arm."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.signals.momentum_observer import MomentumObserver
from onika.laws.textbook import serial_arm

DT = 0.001
OUTSIDE = np.array([0.0, 8.0, -3.0, 0.0, 1.0, 0.0])


@pytest.fixture(scope="module")
def arm():
    return serial_arm(puma560.DH, puma560.DYN, puma560.LOAD, tool=puma560.TOOL)


def observed(arm, outside, gain=20.0, seconds=1.0):
    """What is seen while an arm swings and somebody pushes it from half of the time on: (before, at the end)."""
    observer, q, qd, seen = MomentumObserver(arm, gain), np.array(puma560.HOME), np.zeros(6), []
    count = round(seconds / DT)
    for step in range(count):
        pushes = outside if step >= count // 2 else np.zeros(6)
        wanted = np.array([2.0, 3.0, -2.0, 1.0, 1.0, 0.5]) * np.cos(6.0 * step * DT)
        friction = arm.viscous * qd + arm.dry * np.tanh(qd / 0.01)
        torque = arm.torque(q, qd, wanted) + friction - pushes
        seen.append(observer.follow(q, qd, torque, DT).copy())
        qd = qd + DT * wanted
        q = q + DT * qd
    return seen[count // 2 - 1], seen[-1]


def test_what_nobody_pushes_stays_near_nothing_while_the_arm_swings(arm):  # R-K05
    before, end = observed(arm, np.zeros(6))
    assert np.abs(before).max() < 0.5
    assert np.abs(end).max() < 0.5


def test_a_push_is_seen_in_the_joint_that_it_pushes(arm):  # R-K05
    before, end = observed(arm, OUTSIDE)
    assert np.abs(before).max() < 0.5
    assert end == pytest.approx(OUTSIDE, abs=0.5)


def test_it_follows_with_the_lag_of_its_gain(arm):
    _, end = observed(arm, OUTSIDE, gain=2.0)
    assert end[1] == pytest.approx(8.0 * (1.0 - np.exp(-1.0)), abs=0.5)
