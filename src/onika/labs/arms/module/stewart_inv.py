"""Leg lengths of a platform on six legs."""

import numpy as np

from onika.laws.stewart import Platform
from onika.module import InVar, Local, Module, ModuleError, OutVar


class StewartInv(Module):
    """Leg lengths for a wanted pose of a platform on six legs, in closed form.

    q_k = |p + R h_k - f_k| - REST

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   X_REF   double[4,4]  -    reference pose of the plate in the base
             INVAR   Q_MEZ   double[6]    rad  measured position of the legs (m); kept where no reference is in force
             OUTVAR  Q_REF   double[6]    rad  reference position of the legs (m)
             OUTVAR  Q^_REF  double[6]    rad/s  their reference speed (m/s)
    Local    FEET           double[18]   m  where the legs stand in the base: x y z of each of the six
             HEADS          double[18]   m  where they end in the plate: x y z of each of the six
             REST           double       m  length of a leg whose joint is at 0
             SPEED          double       m/s  a leg that would be faster is an error
    Errors   no reference    X_REF was not written since the hardware held: the legs stay until it is
             too fast        a leg would pass SPEED, as where the first pose is far away: ERROR
    Source   Gough 1956; Stewart 1965; Merlet, Parallel Robots, §3
    """

    X_REF = InVar("double[4,4]", "-", "reference pose of the plate in the base")
    Q_MEZ = InVar("double[6]", "rad", "measured position of the legs (m); kept where no reference is in force")
    Q_REF = OutVar("double[6]", "rad", "reference position of the legs (m)")
    Qd_REF = OutVar("double[6]", "rad/s", "their reference speed (m/s)", name="Q^_REF")

    FEET = Local("double[18]", "m", "where the legs stand in the base: x y z of each of the six")
    HEADS = Local("double[18]", "m", "where they end in the plate: x y z of each of the six")
    REST = Local("double", "m", "length of a leg whose joint is at 0")
    SPEED = Local("double", "m/s", "a leg that would be faster is an error", default=0.5, low=1e-3)

    def init(self):
        self._platform = Platform(self.FEET, self.HEADS)

    def on(self, inputs):
        # a pose from before the last hold is not followed: it is waited for until it changes
        self._stale = None if self.continues("X_REF") else self.X_REF.copy()
        self.Q_REF = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self.Qd_REF = 0.0

    def cycle(self):
        if self._stale is not None and np.array_equal(self.X_REF, self._stale):
            return
        self._stale = None
        lengths = self._platform.lengths(self.X_REF) - self.REST
        speeds = (lengths - self.Q_REF) / self.dt
        leg = int(np.abs(speeds).argmax())
        if abs(speeds[leg]) > self.SPEED:
            raise ModuleError(
                "expected leg {leg} within {limit:.3f} m/s, found {speed:.3f} m/s",
                leg=leg + 1,
                limit=self.SPEED,
                speed=abs(speeds[leg]),
            )
        self.Q_REF = lengths
        self.Qd_REF = speeds
