"""A check of the angles that an arm measures."""

import numpy as np

from onika.module import InConst, Input, InVar, Local, Module, ModuleError, OutVar, finish

NEAR = 0.2  # rad


class Calibration(Module):
    """Tells how far the measured joints are from a position in which the arm is known to stand.

    The arm is brought there before, by hand and eye or by a job; here it only stands. An arm whose encoders count
    from wherever it was switched on is off by what this tells.

    Kind     trigger, periodic, 10..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INVAR    Q_MEZ   double[NDOF]  rad    measured position
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; the known one, or the measured if elsewhere
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed; 0
             OUTVAR   Q_OFF   double[NDOF]  rad    measured minus known, the mean since `on`
    Local    MOST             double        rad    how far a joint may be off
    Input    endpoint         double[NDOF]  rad    QMIN..QMAX
             duration         double        s      0.1..600
    Finish   flow 0, loop FALSE, after the duration, where no joint is off by more than MOST
    Errors   elsewhere        a joint is 0.2 rad or more from there at `on`: ERROR, the arm stays where it is
             off              a joint is off by more than MOST: ERROR; Q_OFF says by how much each is
    Source   dissertation §E.1
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; the known one, or the measured if elsewhere")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed; 0", name="Q^_REF")
    Q_OFF = OutVar("double[NDOF]", "rad", "measured minus known, the mean since `on`")

    MOST = Local("double", "rad", "how far a joint may be off", default=0.01, low=1e-6)

    endpoint = Input("double[NDOF]", "rad", "where the joints are known to be", low="QMIN", high="QMAX")
    duration = Input("double", "s", "how long is looked", low=0.1, high=600.0)

    def on(self, inputs):
        self._known, self._duration = inputs.endpoint, inputs.duration
        self._time, self._count = 0.5 * self.dt, 0  # sums of periods are not exact: half a period decides safely
        self._sum = np.zeros(self.NDOF)
        self.Q_OFF = self.Q_MEZ - self._known
        self._is_there = bool(np.abs(self.Q_OFF).max() < NEAR)
        self.Q_REF = self._known if self._is_there else self.Q_MEZ
        self.Qd_REF = 0.0

    def cycle(self):
        if not self._is_there:
            joint = int(np.abs(self.Q_OFF).argmax())
            raise ModuleError(
                "expected joint {joint} within {near:g} rad of where it is known to be, found it {away:.3f} rad away",
                joint=joint + 1,
                near=NEAR,
                away=float(self.Q_OFF[joint]),
            )
        self._time += self.dt
        self._count += 1
        self._sum += self.Q_MEZ - self._known
        self.Q_OFF = self._sum / self._count
        if self._time < self._duration:
            return None
        joint = int(np.abs(self.Q_OFF).argmax())
        if abs(self.Q_OFF[joint]) > self.MOST:
            raise ModuleError(
                "expected joint {joint} at most {most:g} rad off, found {off:.4f} rad: it has to be calibrated",
                joint=joint + 1,
                off=float(self.Q_OFF[joint]),
                most=self.MOST,
            )
        return finish()
