"""Places and speeds on a floor: x, y (m) and turn (rad); forward, to the left (m/s) and turning to the left (rad/s)."""

import math

import numpy as np

from onika.laws.frames import Array, Numbers


def advanced(place: Numbers, twist: Numbers, dt: float) -> Array:
    """Where a base is that went from a place double[3] for `dt` seconds with one twist double[3]: on an arc.

    Its turn is not brought back within half a turn.
    """
    x, y, turn = (float(number) for number in place)
    forward, left, turning = (float(number) for number in twist)
    angle = turning * dt
    half = 0.5 * angle
    chord = dt * (math.sin(half) / half if abs(half) > 1e-9 else 1.0)
    c, s = math.cos(turn + half), math.sin(turn + half)
    return np.array((x + chord * (c * forward - s * left), y + chord * (s * forward + c * left), turn + angle))


def turn_to(turn: float, wanted: float) -> float:
    """The shortest turn (rad) from one heading to another, -pi..pi."""
    return math.remainder(wanted - turn, 2.0 * math.pi)
