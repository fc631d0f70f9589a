"""Vectors of which only the finite numbers are taken."""

import numpy as np

from onika.laws.frames import Array, Numbers


class FiniteValues:
    """The newest finite number of each of `n` elements: NaN or infinity leaves the one before, which is 0 at first."""

    def __init__(self, n: int) -> None:
        self.values: Array = np.zeros(n)
        """The newest finite numbers; always the same array."""
        self._is_finite = np.zeros(n, bool)

    def take(self, values: Numbers) -> Array:
        """Take the next vector; gives `values`, the same array each time."""
        np.isfinite(values, out=self._is_finite)
        np.copyto(self.values, values, where=self._is_finite)
        return self.values
