"""A course of values that is gone through more slowly than it comes."""

from collections import deque

import numpy as np

from onika.laws.frames import Array, Numbers


class SlowedCourse:
    """What comes in is passed on in the same order, at a share of its time; nothing is left out.

    What is not passed on yet is kept, at most `most` pieces; then the share counts no longer. `ease` is how fast the
    share itself may change, per second.
    """

    def __init__(self, start: Numbers, most: int, ease: float) -> None:
        self.value: Array = np.array(start, dtype=np.float64)
        """Where it is."""
        self._pieces: deque[Array] = deque([self.value.copy()])
        self._most, self._ease = most, ease
        self._share, self._past = 0.0, 0.0

    @property
    def behind(self) -> int:
        """How many pieces are still to come."""
        return len(self._pieces) - 1

    def follow(self, value: Array, share: float, dt: float) -> Array:
        """One more piece, `dt` seconds after the last; gives how fast the course goes on double[n], per second."""
        self._pieces.append(np.where(np.isfinite(value), value, self._pieces[-1]))
        step = self._ease * dt
        self._share += float(np.clip(np.clip(share, 0.0, 1.0) - self._share, -step, step))
        self._past += max(self._share, float(self.behind - self._most))
        while self._past >= 1.0 and self.behind > 1:
            self._pieces.popleft()
            self._past -= 1.0
        self._past = min(self._past, 1.0)
        before = self.value
        self.value = self._pieces[0] + self._past * (self._pieces[min(1, self.behind)] - self._pieces[0])
        return np.asarray((self.value - before) / dt)
