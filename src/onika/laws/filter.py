"""A derivative with a first-order low-pass, for measured positions that come sampled."""

import math

import numpy as np

from onika.laws.frames import Array, Numbers
from onika.laws.sentence import LawSentence


class Derivative:
    """D(s) = s / (1 + s tau) by backward differences: v' = (tau v + (x' - x)) / (tau + dt).

    `n` signals, sampled every `dt` seconds, low-pass at `cutoff` Hz (tau = 1 / (2 pi cutoff)); stable for every dt.
    A cutoff of infinity is the plain difference quotient.
    """

    def __init__(self, n: int, dt: float, cutoff: float) -> None:
        if not (dt > 0.0 and cutoff > 0.0):
            raise ValueError(
                LawSentence(
                    "laws.filter_unfit",
                    "expected dt and cutoff above 0, found {dt} s and {cutoff} Hz",
                    dt=str(dt),
                    cutoff=str(cutoff),
                )
            )
        tau = 1.0 / (2.0 * math.pi * cutoff)
        # arrays, because NumPy multiplies two arrays quicker than an array and a number
        self._keep, self._take = np.array([tau / (tau + dt)] * n), np.array([1.0 / (tau + dt)] * n)
        self._scaled = np.zeros(n)
        self.value: Array = np.zeros(n)
        """The newest derivative."""
        self._carried = np.zeros(n)  # keep v - take x of the sample before: what the next one is added to

    def reset(self, x: Numbers) -> None:
        """Start at rest at x: the derivative is zero."""
        np.multiply(x, -self._take, out=self._carried)
        self.value = np.zeros(len(self._carried))

    def update(self, x: Numbers, out: Array | None = None) -> Array:
        """Take the next sample; gives the derivative double[n] per second, written into `out` where given."""
        scaled, carried = self._scaled, self._carried
        np.multiply(x, self._take, out=scaled)
        value: Array = np.add(scaled, carried, out=out)
        np.multiply(value, self._keep, out=carried)
        np.subtract(carried, scaled, out=carried)
        self.value = value
        return value
