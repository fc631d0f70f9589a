"""When a motion is over: its time has passed, and what is measured rests at its end."""

from typing import Self

import numpy as np

from onika.laws.frames import Array
from onika.laws.sentence import LawSentence


class Arrival:
    """Whether what is measured has come to `end` and rests there; asked once in each cycle.

    It is there where no element is `near` or more away from its end, and rests where none changed by `still` per second
    or more since the cycle before. `settle` seconds after the motion's time it is over, wherever it is. All elements
    have one unit: rad, or m and parts of unit vectors.
    """

    def __init__(self, end: Array, measured: Array, settle: float, near: float, still: float) -> None:
        self._end, self._last = end, measured.copy()
        self._settle, self._near, self._still = settle, near, still

    @classmethod
    def of_joints(cls, end: Array, measured: Array, settle: float) -> Self:
        """That of joints double[n]: within 1 mrad, slower than 0.01 rad/s; mm and 0.01 m/s where they slide."""
        return cls(end, measured, settle, near=1e-3, still=0.01)

    @classmethod
    def of_tool(cls, end: Array, measured: Array, settle: float) -> Self:
        """That of a tool double[4,4]: within 1 mm and 1e-3 of each unit vector, slower than 2 mm/s."""
        return cls(end, measured, settle, near=1e-3, still=2e-3)

    def is_over(self, late: float, measured: Array, dt: float) -> bool:
        """Whether the motion is over, `late` seconds after its time (below 0: before) and `dt` after the last cycle."""
        if late < -2.0 * dt:
            return False  # far from the end nobody asks whether the arm stands still
        rests = self._rests(measured, dt)
        return late >= self._settle or (late >= 0.0 and rests)

    def joint_short(self, measured: Array, most: float) -> LawSentence | None:
        """Which joint double[n] stands more than `most` rad (m where it slides) from its end; None: none does."""
        away = np.abs(measured - self._end)
        joint = int(away.argmax())
        if away[joint] <= most:
            return None
        return LawSentence(
            "laws.joint_short",
            "the arm did not come to its target: joint {joint} is {away:.2f} rad (m where it slides) away from there",
            joint=joint + 1,
            away=float(away[joint]),
        )

    def tool_short(self, measured: Array, most: float) -> LawSentence | None:
        """How far a tool double[4,4] stands from its end, if that is more than `most` m; None: it is not."""
        away = float(np.linalg.norm(measured[:3, 3] - self._end[:3, 3]))
        if away <= most:
            return None
        return LawSentence(
            "laws.tool_short",
            "the hand did not come to its target: it stands {away:.1f} cm away from there",
            away=away * 100.0,
        )

    def _rests(self, measured: Array, dt: float) -> bool:
        moved = np.abs(measured - self._last).max()
        self._last[:] = measured
        return bool(moved < self._still * dt and np.abs(measured - self._end).max() < self._near)
