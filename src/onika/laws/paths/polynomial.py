"""Paths whose joints follow polynomials of the share of time."""

import numpy as np

from onika.laws.frames import Array, Numbers
from onika.laws.paths.joint_range import check_range
from onika.laws.sentence import LawSentence

_AT_REST = 1e-3  # rad or m in the whole duration: what counts as no speed at an end
_LOOKS = np.linspace(0.0, 1.0, 129)


class PolynomialPath:
    """q(s) = c0 + c1 s + c2 s^2 + … for each of n joints, s = t / duration held within 0..1 (rad, m; s).

    `coefficients` double[n,k], the constant one first. It has to rest at both ends, else ValueError. The duration is
    stretched where a joint would be faster than `speed`. Range and speed are judged at 129 points (after Craig,
    Introduction to Robotics, §7.3).
    """

    def __init__(self, coefficients: Array, duration: float, speed: Numbers) -> None:
        self._c = np.array(coefficients, dtype=np.float64)
        self._rate = self._c[:, 1:] * np.arange(1.0, self._c.shape[1])
        _check_rest(self._rate)
        peak = float(np.max(np.abs(_values(self._rate, _LOOKS)) / np.asarray(speed)[:, None]))
        self.duration = max(duration, peak)
        """Seconds that it takes."""

    def check_range(self, low: Numbers, high: Numbers) -> None:
        """Raises ValueError with the first joint that would leave its range."""
        check_range(_values(self._c, _LOOKS).T, low, high)

    def at(self, t: float) -> tuple[Array, Array]:
        """Position and speed double[n] at t in s; before 0 and after its duration it rests."""
        share = np.array([min(max(t / self.duration, 0.0), 1.0)])
        return _values(self._c, share)[:, 0], _values(self._rate, share)[:, 0] / self.duration


def _values(coefficients: Array, shares: Array) -> Array:
    """The polynomials double[n,m] at m shares."""
    return np.asarray(coefficients @ np.vander(shares, coefficients.shape[1], increasing=True).T)


def _check_rest(rate: Array) -> None:
    ends = np.abs(_values(rate, np.array([0.0, 1.0]))).max(axis=1)
    joint = int(ends.argmax())
    if ends[joint] > _AT_REST:
        raise ValueError(
            LawSentence(
                "laws.path_unrested",
                "expected a path that begins and ends at rest; that of joint {joint} has a slope of {slope:.3g} there",
                joint=joint + 1,
                slope=float(ends[joint]),
            )
        )
