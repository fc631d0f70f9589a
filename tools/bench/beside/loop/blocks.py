"""The arithmetic of the four blocks, the same for all contestants, and what the loop must come to.

The joint is a unit mass, integrated by explicit Euler: the controller at step k sees the joint as step k-1 left it.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from beside.contestant import Absent, Figures

Vector = NDArray[np.float64]

SIZE = 6
STEP_S = 1e-3
RATE_HZ = 1e3
BLOCKS = 4
_AMPLITUDE = np.linspace(0.2, 1.2, SIZE)
_OMEGA = np.linspace(1.0, 6.0, SIZE)
_STIFFNESS = 400.0
_DAMPING = 40.0


def path(now: float) -> Vector:
    """Where the joint shall be at this time, rad."""
    return _AMPLITUDE * np.sin(_OMEGA * now)


def derivative(new: Vector, old: Vector) -> Vector:
    """The rate between two samples one step apart, rad/s."""
    return (new - old) * RATE_HZ


def torque(wanted: Vector, wanted_rate: Vector, found: Vector, found_rate: Vector) -> Vector:
    """What the controller asks of the joint, Nm."""
    return _STIFFNESS * (wanted - found) + _DAMPING * (wanted_rate - found_rate)


def moved(position: Vector, rate: Vector, pushed: Vector) -> tuple[Vector, Vector]:
    """The joint one step later: rad, rad/s."""
    return position + STEP_S * rate, rate + STEP_S * pushed


@lru_cache(maxsize=64)
def expected(steps: int) -> Vector:
    """The joint's position after so many steps, by a plain loop."""
    old, position, rate = path(0.0), np.zeros(SIZE), np.zeros(SIZE)
    for step in range(steps):
        wanted = path(step * STEP_S)
        position, rate = moved(position, rate, torque(wanted, derivative(wanted, old), position, rate))
        old = wanted
    return position


def check(figures: Figures) -> None:
    """Raises `Absent` where a contestant's joint is not where the plain loop puts it."""
    steps, position = figures["steps"], figures["position"]
    assert isinstance(steps, int | float)
    wanted = expected(int(steps))
    if not np.allclose(position, wanted, rtol=0.0, atol=1e-9):
        raise Absent(f"expected the joint at {wanted.tolist()} after {steps:g} steps, found {position}")
