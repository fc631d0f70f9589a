"""Resolved motion rate control: joint speeds for a wanted twist of the tool, damped, within limits.

qd = V diag(s / (s^2 + lambda^2)) U^T twist + (I - V V^T) pull, J = U diag(s) V^T (Whitney 1969); lambda grows where the
smallest singular value falls below LEAST (Nakamura & Hanafusa 1986; Maciejewski & Klein 1988). A joint that stands at a
limit and would be pushed beyond it is left out; if a joint would be too fast all are slowed down alike, so that the
tool keeps its direction.
"""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.frames import Array, Numbers, as_array

LEAST = 0.02
"""The smallest singular value of the Jacobian below which steps are damped."""
_DAMPING = 0.05  # lambda where the smallest singular value is 0
_PULL = 0.25  # share of the highest speeds that the way home may have


class ResolvedRate:
    """Joint speeds of one arm within its limits double[n]; joints that the twist leaves free go to `home`.

    `homing` 1/s: how quick they go; 0: they stay.
    """

    def __init__(
        self, arm: ArmModel, qmin: Numbers, qmax: Numbers, speed: Numbers, home: Numbers, homing: float
    ) -> None:
        self._arm, self._homing = arm, homing
        self._low, self._high, self._speed, self._home = (as_array(row, (arm.n,)) for row in (qmin, qmax, speed, home))
        self._jacobian = np.empty((6, arm.n))

    def speeds(self, q: Array, twist: Array, dt: float) -> Array:
        """Speeds double[n] (rad/s, m/s) at q for a twist double[6] of the tool in the world (m/s, rad/s).

        After `dt` seconds at these speeds no joint is beyond its limits.
        """
        jacobian = self._arm.jacobian(q, self._jacobian)
        most = _PULL * self._speed
        pull = np.clip(self._homing * (self._home - q), -most, most)
        result = np.zeros(self._arm.n)
        moves = np.ones(self._arm.n, dtype=bool)
        while moves.any():
            result[:] = 0.0
            result[moves] = _solution(jacobian[:, moves], twist, pull[moves])
            stopped = ((q <= self._low) & (result < 0.0)) | ((q >= self._high) & (result > 0.0))
            if not stopped.any():
                break
            moves &= ~stopped
        result *= min(1.0, 1.0 / max(float((np.abs(result) / self._speed).max()), 1e-12))
        return np.clip(result, np.minimum((self._low - q) / dt, 0.0), np.maximum((self._high - q) / dt, 0.0))


def _solution(jacobian: Array, twist: Array, pull: Array) -> Array:
    """Damped speeds for a twist, and what of the pull it does not feel."""
    u, sizes, vt = np.linalg.svd(jacobian, full_matrices=False)
    shortage = max(0.0, 1.0 - float(sizes[-1]) / LEAST)
    damping = (_DAMPING * shortage) ** 2
    along: Array = vt.T @ (sizes / (sizes * sizes + damping + 1e-300) * (u.T @ twist))
    return along + pull - vt.T @ (vt @ pull)
