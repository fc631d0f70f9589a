"""A fence around joint references."""

import numpy as np

from onika.laws.finite import FiniteValues
from onika.laws.signals.limited_rate import LimitedRate
from onika.module import InConst, InVar, Local, Module, OutVar


class Fence(Module):
    """Passes on joint references, but never beyond the limits of the joints less a margin, nor faster than allowed.

    Between a reference that is not trusted (a learner, an outside program, a hand) and whoever follows it.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_WISH  double[NDOF]  rad    wanted position
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    MARGIN           double        rad    how far inside its limits a joint stays
             SPEED            double        -      share of Q^_MAX that it may go at
    Errors   no number  what is NaN or infinite is not followed
             no wish    Q_WISH was not written since the hardware held: stays where it is until it is
    """

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_WISH = InVar("double[NDOF]", "rad", "wanted position")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    MARGIN = Local("double", "rad", "how far inside its limits a joint stays", default=0.02, low=0.0, high=1.0)
    SPEED = Local("double", "-", "share of Q^_MAX that it may go at", default=0.6, low=0.01, high=1.0)

    def on(self, inputs):
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._limited = LimitedRate(start, self.SPEED * self.Qd_MAX)
        self._sound = FiniteValues(self.NDOF)
        self._sound.take(start)
        self._stale = None if self.continues("Q_WISH") else self.Q_WISH.copy()
        middle = (self.QMIN + self.QMAX) / 2.0
        self._low, self._high = np.minimum(self.QMIN + self.MARGIN, middle), np.maximum(self.QMAX - self.MARGIN, middle)
        self.Q_REF = start
        self.Qd_REF = 0.0

    def cycle(self):
        if self._stale is not None and np.array_equal(self.Q_WISH, self._stale):
            self.Qd_REF = 0.0
            return
        self._stale = None
        wish = np.clip(self._sound.take(self.Q_WISH), self._low, self._high)
        self.Qd_REF = self._limited.follow(wish, self.dt)
        self.Q_REF = self._limited.value
