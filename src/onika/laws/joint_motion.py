"""A motion of joints while it goes on: its time, what it commands at it, and when it is over."""

from typing import Protocol

from onika.laws.arrival import Arrival
from onika.laws.frames import Array
from onika.laws.sentence import LawSentence


class TimedPath(Protocol):
    """What says what is commanded at a time in s, from 0 to its duration: position and speed double[n], and more."""

    @property
    def duration(self) -> float:
        """Seconds that it takes."""

    def at(self, t: float) -> tuple[Array, ...]:
        """What is commanded at t."""


class JointMotion:
    """Along `path` to `end` double[n] (rad, m where a joint slides), and on until the arm rests there.

    `measured` double[n] is where the joints stand when it begins; `settle` seconds after its time it is over at last.
    """

    def __init__(self, path: TimedPath, end: Array, measured: Array, settle: float) -> None:
        self._path, self._time = path, 0.0
        self._arrival = Arrival.of_joints(end, measured, settle)

    def advance(self, dt: float) -> tuple[Array, ...]:
        """What is commanded dt seconds after the last time."""
        self._time += dt
        return self._path.at(self._time)

    def is_over(self, measured: Array, dt: float) -> bool:
        """Whether its time has passed and the joints rest at its end; asked once in each cycle."""
        return self._arrival.is_over(self._time - self._path.duration, measured, dt)

    def short(self, measured: Array, most: float) -> LawSentence | None:
        """Which joint stands more than `most` rad (m) from its end; None: none does."""
        return self._arrival.joint_short(measured, most)

    @property
    def progress(self) -> float:
        """The share of its time that has passed, 0 to 1."""
        return float(min(self._time / self._path.duration, 1.0))
