"""Torque from outside, from what the momentum of an arm does beyond what its motors explain."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.frames import Array, Numbers


class MomentumObserver:
    """Follows the torque (N m, N) that others bring to the joints of an arm, with a lag of 1/`gain` seconds.

    No acceleration is measured. Viscous and dry friction are those of the arm's links; dry friction counts where a
    joint goes faster than `still` (rad/s, m/s). `gain` in 1/s. It begins at rest, with nothing from outside.
    """

    def __init__(self, arm: ArmModel, gain: float, still: float = 0.01) -> None:
        self.outside: Array = np.zeros(arm.n)
        """The torque from outside double[n]."""
        self._arm, self._gain, self._still = arm, gain, still
        self._inertia: Array | None = None
        self._first: Array = np.zeros(arm.n)
        self._sum: Array = np.zeros(arm.n)

    def follow(self, q: Numbers, qd: Numbers, torque: Numbers, dt: float) -> Array:
        """What is measured `dt` seconds after the last time, and the torque of the motors between; gives `outside`."""
        speed, driven = np.asarray(qd, dtype=np.float64), np.asarray(torque, dtype=np.float64)
        inertia = self._arm.inertia(q)
        momentum = inertia @ speed
        if self._inertia is None:
            self._inertia, self._first = inertia, momentum
        turned = (inertia - self._inertia) @ speed  # what the changing inertia does to the momentum in this time
        self._inertia = inertia
        borne = self._arm.bias(q, speed) + self._friction(speed)
        self._sum += (driven - borne + self.outside) * dt + turned
        self.outside = self._gain * (momentum - self._first - self._sum)
        return self.outside

    def _friction(self, speed: Array) -> Array:
        return self._arm.viscous * speed + self._arm.dry * np.tanh(speed / self._still)
