"""Paths: the fifth-order time law, the straight line between two poses, and how long a motion takes."""

import math

import numpy as np

from onika.laws.frames import Array, Numbers, turn_between

PEAK = 1.875
"""Peak speed of the fifth-order law, as a multiple of the mean speed: s'(1/2) = 15/8."""


def quintic(t: float, duration: float) -> tuple[float, float]:
    """Value s and speed ds/dt (1/s) of s = 10 x^3 - 15 x^4 + 6 x^5, x = t / duration held within 0..1.

    Speed and acceleration are zero at both ends (Craig, Introduction to Robotics, §7.3). Duration 0 is done at once.
    """
    if t >= duration:
        return 1.0, 0.0
    if t <= 0.0:
        return 0.0, 0.0
    x = t / duration
    rest = 1.0 - x
    return x * x * x * (10.0 + x * (6.0 * x - 15.0)), 30.0 * x * x * rest * rest / duration


def ramped(t: float, duration: float, ramp: float) -> tuple[float, float]:
    """Value s and speed ds/dt (1/s) of a trapezoid of speed, t / duration held within 0..1.

    `ramp`, above 0 and 1/2 at most, is the share of the time in which the speed rises evenly, and that in which it
    falls; its peak is 1 / (1 - ramp) of the mean (Craig, Introduction to Robotics, §7.3). Duration 0 is done at once.
    """
    if t >= duration:
        return 1.0, 0.0
    if t <= 0.0:
        return 0.0, 0.0
    x, top = t / duration, 1.0 / (1.0 - ramp)
    if x < ramp:
        return 0.5 * top * x * x / ramp, top * x / (ramp * duration)
    if x > 1.0 - ramp:
        rest = 1.0 - x
        return 1.0 - 0.5 * top * rest * rest / ramp, top * rest / (ramp * duration)
    return top * (x - 0.5 * ramp), top / duration


def joint_duration(start: Numbers, end: Numbers, speed: Numbers) -> float:
    """Seconds of a fifth-order motion whose joints peak at `speed` (rad/s, m/s) at most; the slowest joint decides."""
    rows = (row.tolist() if isinstance(row, np.ndarray) else row for row in (start, end, speed))
    return PEAK * max([abs(last - first) / limit for first, last, limit in zip(*rows, strict=True)], default=0.0)


class StraightLine:
    """The straight line from one pose to another, turning about one fixed axis at an even share.

    p(s) = p0 + s (p1 - p0), R(s) = R0 exp(s log(R0^T R1)), s = 0..1. A turn of exactly pi goes either way round.
    """

    def __init__(self, start: Array, end: Array) -> None:
        # with plain numbers: a motion that begins makes the arm wait for this, and arrays would take twice as long
        turned = start[:3, :3].tolist()
        x, y, z = turn_between(turned, end[:3, :3].tolist())
        self.length = math.dist(start[:3, 3].tolist(), end[:3, 3].tolist())
        self.angle = angle = math.sqrt(x * x + y * y + z * z)
        x, y, z = (x / angle, y / angle, z / angle) if angle > 1e-9 else (0.0, 0.0, 1.0)
        # R(s) = R0 (I + sin K + (1 - cos) K^2): the three products are worked out once; a row times K is row x axis
        once = [(b * z - c * y, c * x - a * z, a * y - b * x) for a, b, c in turned]
        twice = [(b * z - c * y, c * x - a * z, a * y - b * x) for a, b, c in once]
        self._r0, self._rk, self._rkk = np.array(turned), np.array(once), np.array(twice)
        self._p0: Array = start[:3, 3].copy()
        self._way: Array = end[:3, 3] - self._p0
        self._turns = self.angle > 1e-9

    def duration(self, speed: float, turn_speed: float) -> float:
        """Seconds of a fifth-order motion that peaks at `speed` m/s and `turn_speed` rad/s at most."""
        return PEAK * max(self.length / speed, self.angle / turn_speed)

    def at(self, s: float, out: Array | None = None) -> Array:
        """The pose double[4,4] at share s of the way; fills and gives back `out` where given."""
        pose = np.empty((4, 4)) if out is None else out
        if self._turns:
            angle = self.angle * s
            pose[:3, :3] = self._r0 + math.sin(angle) * self._rk + (1.0 - math.cos(angle)) * self._rkk
        else:
            pose[:3, :3] = self._r0
        pose[:3, 3] = self._p0 + s * self._way
        pose[3] = (0.0, 0.0, 0.0, 1.0)
        return pose
