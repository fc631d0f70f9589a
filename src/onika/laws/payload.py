"""What an arm holds, from what its joints bear beyond its own weight: recursive least squares.

At rest tau - g(q) = J_p^T m g e_z + J_r^T (R (m d) x g e_z) is linear in the mass m and in m d, d its centre in the
tool's frame (Atkeson, An & Hollerbach 1986). What was measured longer ago counts less.
"""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.frames import Array

_GRAVITY = 9.81
_UNSURE = (1e3, 1.0, 1.0, 1.0)  # variance before anything is measured: kg2, and kg2 m2 of m d
_NOISE = 1.0  # N2 m2: variance of a measured torque
_LIGHT = 1e-3  # kg: of less nobody says where its centre is


class PayloadEstimate:
    """Mass and centre of what the tool of an arm holds; `memory` in cycles: after so many a measurement counts 1/e."""

    def __init__(self, arm: ArmModel, memory: float) -> None:
        self._arm = arm
        self._keep = float(np.exp(-1.0 / memory))
        self.reset()

    def reset(self) -> None:
        """Nothing is known: it holds nothing."""
        self._estimate = np.zeros(4)
        self._covariance = np.diag(_UNSURE)

    def take(self, q: Array, beyond: Array) -> None:
        """Measured at rest at q (rad, m): torques double[n] (N m, N) beyond those that bear the arm alone."""
        rows = self._regressor(q)
        prior = np.minimum(self._covariance / self._keep, 1e6)
        gain = prior @ rows.T @ np.linalg.inv(rows @ prior @ rows.T + _NOISE * np.eye(len(rows)))
        self._estimate = self._estimate + gain @ (beyond - rows @ self._estimate)
        covariance = prior - gain @ rows @ prior
        self._covariance = 0.5 * (covariance + covariance.T)

    def load(self) -> Array:
        """LOAD double[4]: mass kg, centre m, at q = 0 in frame 0; an unloaded tool's centre is where the tool is."""
        mass, *moment = self._estimate.tolist()
        centre = np.array(moment) / mass if abs(mass) > _LIGHT else np.zeros(3)
        place = self._arm.tool @ [*centre, 1.0]
        return np.array([mass, *place[:3]])

    def _regressor(self, q: Array) -> Array:
        """Torques double[n,4] of a kilogram at the tool, and of a kilogram a metre away along each axis of the tool."""
        turn, jacobian = self._arm.forward(q)[:3, :3], self._arm.jacobian(q)
        up = np.array([0.0, 0.0, _GRAVITY])
        twisted = np.array([np.cross(axis, up) for axis in turn.T])
        return np.column_stack((jacobian[:3].T @ up, jacobian[3:].T @ twisted.T))
