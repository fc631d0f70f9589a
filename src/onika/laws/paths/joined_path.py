"""A path of joints that begins where it likes, joined to where the arm is."""

from typing import Protocol

from onika.laws.frames import Array, Numbers
from onika.laws.path import joint_duration, quintic


class JointPath(Protocol):
    """What gives position and speed double[n] at a time in s, from 0 to its duration; it begins and ends at rest."""

    @property
    def duration(self) -> float:
        """Seconds that it takes."""

    def at(self, t: float) -> tuple[Array, Array]:
        """Position and speed at t."""


class JoinedPath:
    """From `start` double[n] to where `path` begins on a path of fifth order, then along it; at rest in between.

    No joint is faster than `speed` (rad/s, m/s) on the way there.
    """

    def __init__(self, start: Array, path: JointPath, speed: Numbers) -> None:
        begin = path.at(0.0)[0]
        self._start, self._way, self._path = start, begin - start, path
        self._lead = joint_duration(start, begin, speed)
        self.duration = self._lead + path.duration
        """Seconds that both take."""

    @property
    def end(self) -> Array:
        """Where it ends double[n]."""
        return self.at(self.duration)[0]

    def at(self, t: float) -> tuple[Array, Array]:
        """Position and speed double[n] at t in s."""
        if t < self._lead:
            share, rate = quintic(t, self._lead)
            return self._start + share * self._way, rate * self._way
        return self._path.at(t - self._lead)
