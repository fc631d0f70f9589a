"""A derivative with a first-order low-pass, for measured positions that come sampled."""

import math

import numpy as np

from onika.laws.frames import Array, Numbers


class Derivative:
    """D(s) = s / (1 + s tau) by backward differences: v' = (tau v + (x' - x)) / (tau + dt).

    `n` signals, sampled every `dt` seconds, low-pass at `cutoff` Hz (tau = 1 / (2 pi cutoff)); stable for every dt.
    A cutoff of infinity is the plain difference quotient.
    """

    def __init__(self, n: int, dt: float, cutoff: float) -> None:
        if not (dt > 0.0 and cutoff > 0.0):
            raise ValueError(f"expected dt and cutoff above 0, found {dt} s and {cutoff} Hz")
        tau = 1.0 / (2.0 * math.pi * cutoff)
        self._keep, self._take = tau / (tau + dt), 1.0 / (tau + dt)
        self._last = np.zeros(n)
        self._step = np.zeros(n)
        self.value = np.zeros(n)

    def reset(self, x: Numbers) -> None:
        """Start at rest at x: the derivative is zero."""
        self._last[:] = x
        self.value[:] = 0.0

    def update(self, x: Numbers, out: Array | None = None) -> Array:
        """Take the next sample; gives the derivative double[n] per second, written into `out` where given."""
        step, value = self._step, self.value
        np.subtract(x, self._last, out=step)
        self._last[:] = x
        step *= self._take
        value *= self._keep
        value += step
        if out is None:
            return value.copy()
        out[:] = value
        return out
