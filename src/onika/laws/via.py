"""The path through one point on the way: two fifth-order segments, passed without a stop."""

import numpy as np

from onika.laws.frames import Array, Numbers

_LOOKS = 64  # per segment, for the peak speed; between two looks it is at most 0.2 % higher


class Via:
    """Positions and speeds from rest at `start` through `via` to rest at `end`, each double[n] (rad or m).

    Each segment is a polynomial of fifth order; speeds agree at `via`, accelerations are zero at all three points. A
    joint passes `via` at the harmonic mean of its two mean speeds, or at rest where it turns round there; so it never
    leaves the range between the points (after Craig, Introduction to Robotics, §7.3). `first` and `second` are the
    times of the segments in s; both are stretched alike where a joint would be faster than `speed` (rad/s or m/s).
    """

    def __init__(self, start: Numbers, via: Numbers, end: Numbers, times: tuple[float, float], speed: Numbers) -> None:
        here, between, there = (np.array(point, dtype=np.float64) for point in (start, via, end))
        first, second = times
        before, after = (between - here) / first, (there - between) / second
        same = before * after > 0.0
        sums = np.where(same, before + after, 1.0)
        passing = np.where(same, 2.0 * before * after / sums, 0.0)
        rest = np.zeros_like(here)
        self._segments = (
            _polynomial(here, rest, between, passing, first),
            _polynomial(between, passing, there, rest, second),
        )
        self._times = times
        self.stretch = max(1.0, self._peak(np.array(speed, dtype=np.float64)))
        """How many times as long as asked for it takes; 1 where no joint would be too fast."""
        self.duration = self.stretch * (first + second)

    def at(self, t: float) -> tuple[Array, Array]:
        """Position and speed at t in s; before 0 and after `duration` it rests."""
        own = min(max(t, 0.0), self.duration) / self.stretch
        first, second = self._times
        late = bool(own > first)
        x = (own - first) / second if late else own / first
        coefficients = self._segments[late]
        time = (second if late else first) * self.stretch
        return _value(coefficients, x), _value(_derivative(coefficients), x) / time

    def _peak(self, speed: Array) -> float:
        """The highest speed as a share of what is allowed."""
        looks = np.linspace(0.0, 1.0, _LOOKS + 1)
        rates = [
            np.abs(np.polynomial.polynomial.polyval(looks, _derivative(coefficients))).max(axis=1) / time
            for coefficients, time in zip(self._segments, self._times, strict=True)
        ]
        return float(np.max(np.maximum(*rates) / speed))


def _polynomial(p0: Array, v0: Array, p1: Array, v1: Array, time: float) -> Array:
    """Coefficients double[6,n] of x = 0..1 with these ends, speeds per s and no acceleration at either end."""
    way, out, into = p1 - p0, v0 * time, v1 * time
    return np.array(
        [
            p0,
            out,
            np.zeros_like(p0),
            10.0 * way - 6.0 * out - 4.0 * into,
            -15.0 * way + 8.0 * out + 7.0 * into,
            6.0 * way - 3.0 * out - 3.0 * into,
        ]
    )


def _value(coefficients: Array, x: float) -> Array:
    return x ** np.arange(len(coefficients)) @ coefficients


def _derivative(coefficients: Array) -> Array:
    return coefficients[1:] * np.arange(1.0, 6.0)[:, None]
