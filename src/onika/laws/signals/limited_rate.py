"""A vector that follows another one no faster than it may."""

import numpy as np

from onika.laws.frames import Array, Numbers


class LimitedRate:
    """Follows what is wanted by at most `rate` per second, each of n elements by itself.

    `rate` is one number or double[n], above 0. What is not finite is not followed.
    """

    def __init__(self, start: Numbers, rate: Numbers | float) -> None:
        self.value: Array = np.array(start, dtype=np.float64)
        """Where it is."""
        self._rate = np.broadcast_to(np.asarray(rate, dtype=np.float64), self.value.shape)

    def follow(self, wanted: Array, dt: float) -> Array:
        """Go towards what is wanted for `dt` seconds; gives how fast it went double[n], per second."""
        gap = np.where(np.isfinite(wanted), wanted, self.value) - self.value
        step = np.clip(gap, -self._rate * dt, self._rate * dt)
        self.value = self.value + step
        return np.asarray(step / dt)
