"""Filters of second order, for what comes sampled: a low-pass and a notch."""

import math
from typing import Self

import numpy as np

from onika.laws.frames import Array, Numbers
from onika.laws.sentence import LawSentence


class SecondOrder:
    """y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y'', where ' is one sample earlier; n signals alike, 1 at frequency 0.

    Made from the continuous filter by the bilinear transform, exact at its frequency (Oppenheim & Schafer,
    Discrete-Time Signal Processing, §7.1). Frequencies in Hz, below half of the rate 1 / `dt`, else ValueError.
    """

    def __init__(self, n: int, ahead: tuple[float, float, float], back: tuple[float, float]) -> None:
        self._ahead, self._back = ahead, back
        self._first, self._second = np.zeros(n), np.zeros(n)  # what the last two samples leave for the next two

    @classmethod
    def lowpass(cls, n: int, dt: float, cutoff: float) -> Self:
        """The Butterworth low-pass: 3 dB less at `cutoff`, 12 dB less for each octave above, no peak."""
        turn = _turn(cutoff, dt)
        wide, c = math.sin(turn) / math.sqrt(2.0), math.cos(turn)
        whole = 1.0 + wide
        ends = (1.0 - c) / (2.0 * whole)
        return cls(n, (ends, 2.0 * ends, ends), (-2.0 * c / whole, (1.0 - wide) / whole))

    @classmethod
    def notch(cls, n: int, dt: float, middle: float, width: float) -> Self:
        """The notch: nothing of `middle` passes; 3 dB less at about `width` / 2 on either side of it."""
        turn = _turn(middle, dt)
        wide, c = math.sin(turn) * width / (2.0 * middle), math.cos(turn)
        whole = 1.0 + wide
        return cls(n, (1.0 / whole, -2.0 * c / whole, 1.0 / whole), (-2.0 * c / whole, (1.0 - wide) / whole))

    def reset(self, x: Numbers) -> None:
        """As if the signals had been `x` for ever: the next samples of `x` pass unchanged."""
        level = np.asarray(x, dtype=np.float64)
        self._second = (self._ahead[2] - self._back[1]) * level
        self._first = (self._ahead[1] - self._back[0]) * level + self._second

    def update(self, x: Array) -> Array:
        """Take the next sample double[n]; gives what passes, a new array."""
        b0, b1, b2 = self._ahead
        a1, a2 = self._back
        y: Array = b0 * x + self._first
        self._first = b1 * x - a1 * y + self._second
        self._second = b2 * x - a2 * y
        return y


def _turn(frequency: float, dt: float) -> float:
    """The angle of a frequency between two samples."""
    most = 0.5 / dt
    if not 0.0 < frequency < most:
        raise ValueError(
            LawSentence(
                "laws.frequency_beyond",
                "expected a frequency above 0 and below {most:g} Hz, half of the rate, found {frequency:g} Hz",
                most=most,
                frequency=frequency,
            )
        )
    return 2.0 * math.pi * frequency * dt
