"""A way along one direction that is led by what is felt there."""

import numpy as np

from onika.laws.frames import Array, Numbers


class Pressing:
    """How far to go along a wanted force, or torque, until it is felt: as fast as it lacks, `gain` times, or at `pace`.

    `wanted` double[3] is what is to be pressed with; a wanted 0 goes nowhere. Where what is met is a spring of k N/m,
    what lacks becomes less by `gain` k per second.
    """

    def __init__(self, wanted: Numbers, pace: float, gain: float) -> None:
        force = np.asarray(wanted, dtype=np.float64)
        self.most = float(np.linalg.norm(force))
        self.direction: Array = force / self.most if self.most > 0.0 else np.zeros(3)
        self.way = 0.0
        """How far it has gone, in m or rad; back counts against it."""
        self._pace, self._gain = pace, gain

    def lacks(self, felt: Numbers) -> float:
        """How much less it presses than is wanted, where the other side's force double[3] is felt."""
        return self.most + float(self.direction @ np.asarray(felt, dtype=np.float64))

    def step(self, felt: Numbers, dt: float) -> Array:
        """Where to go in `dt` seconds, double[3]."""
        length = float(np.clip(self._gain * self.lacks(felt), -self._pace, self._pace)) * dt if self.most > 0.0 else 0.0
        self.way += length
        return self.direction * length
