"""A follower of a leader arm."""

import numpy as np

from onika.laws.finite import FiniteValues
from onika.laws.signals.limited_rate import LimitedRate
from onika.module import InConst, InVar, Local, Module, OutVar


class Mirror(Module):
    """Does what a leader does, from where the arm is: larger or smaller, within the limits, no faster than allowed.

    q_ref = q0 + SCALE (q_lead - q_lead0), within QMIN..QMAX and SPEED Q^_MAX

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_LEAD  double[NDOF]  rad    where the joints of the leader are
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    SCALE            double        -      how far it goes for what the leader goes; below 0 the other way
             SPEED            double        -      share of Q^_MAX that it may follow at
    Errors   no number  what is NaN or infinite is not followed
    Source   dissertation §4.4
    """

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_LEAD = InVar("double[NDOF]", "rad", "where the joints of the leader are")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    SCALE = Local(
        "double",
        "-",
        "how far it goes for what the leader goes; below 0 the other way",
        default=1.0,
        low=-10.0,
        high=10.0,
    )
    SPEED = Local("double", "-", "share of Q^_MAX that it may follow at", default=0.6, low=0.01, high=1.0)

    def on(self, inputs):
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._limited = LimitedRate(start, self.SPEED * self.Qd_MAX)
        self._sound = FiniteValues(self.NDOF)
        self._from, self._lead = start, self._sound.take(self.Q_LEAD).copy()
        self._low, self._high = np.minimum(self.QMIN, start), np.maximum(self.QMAX, start)
        self.Q_REF = start
        self.Qd_REF = 0.0

    def cycle(self):
        wanted = self._from + self.SCALE * (self._sound.take(self.Q_LEAD) - self._lead)
        self.Qd_REF = self._limited.follow(np.clip(wanted, self._low, self._high), self.dt)
        self.Q_REF = self._limited.value
