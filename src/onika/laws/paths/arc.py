"""An arc of the tool: on a circle through a place to an end."""

import math

import numpy as np

from onika.laws.frames import Array
from onika.laws.path import PEAK, StraightLine
from onika.laws.sentence import LawSentence

_NARROW = 1e-6  # m^2: less than this between two ways, and the three places lie on a line


class Arc:
    """The arc from the pose `start` through the place `via` double[3] to the pose `end`; it turns evenly (m).

    Places lie on the one circle through all three, and are passed at an even share. Where the three lie on a line, it
    is that line; `via` has then to lie between the others. Three places that lie on a line otherwise, or two that are
    one, raise ValueError.
    """

    def __init__(self, start: Array, via: Array, end: Array) -> None:
        self._turn = StraightLine(start, end)
        self._start = start[:3, 3].copy()
        first, whole = via - self._start, end[:3, 3] - self._start
        across = np.cross(first, whole)
        area = float(across @ across)
        self._line: Array | None = None
        if area <= _NARROW * _NARROW:
            self._set_line(first, whole)
            return
        middle = np.cross(across, first) * (whole @ whole) + np.cross(whole, across) * (first @ first)
        centre: Array = self._start + middle / (2.0 * area)
        self._radial = self._start - centre
        axis = across / math.sqrt(area)
        self._tangent = np.cross(axis, self._radial)
        self._centre, radius = centre, float(np.linalg.norm(self._radial))
        last = end[:3, 3] - centre
        self.angle = math.atan2(float(last @ self._tangent), float(last @ self._radial)) % (2.0 * math.pi)
        """How far round it goes, in rad; 0 for a line."""
        self.length = radius * self.angle
        """In m."""

    def duration(self, speed: float, turn_speed: float) -> float:
        """Seconds of a fifth-order motion that peaks at `speed` m/s and `turn_speed` rad/s at most."""
        return PEAK * max(self.length / speed, self._turn.angle / turn_speed)

    def at(self, s: float, out: Array | None = None) -> Array:
        """The pose double[4,4] at share s of the way; fills and gives back `out` where given."""
        pose = self._turn.at(s, out)
        if self._line is not None:
            pose[:3, 3] = self._start + s * self._line
        else:
            angle = self.angle * s
            pose[:3, 3] = self._centre + math.cos(angle) * self._radial + math.sin(angle) * self._tangent
        return pose

    def _set_line(self, first: Array, whole: Array) -> None:
        share = float(first @ whole) / max(float(whole @ whole), 1e-12)
        if not 0.0 < share < 1.0:
            raise ValueError(
                LawSentence(
                    "laws.arc_unclear",
                    "no circle leads from here through the first place to the second: they lie on a line, or are one",
                )
            )
        self._line, self.angle, self.length = whole, 0.0, float(np.linalg.norm(whole))
