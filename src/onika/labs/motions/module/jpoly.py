"""One joint alone, by a polynomial."""

import numpy as np

from onika.laws.joint_motion import JointMotion
from onika.laws.paths.polynomial import PolynomialPath
from onika.laws.sentence import sentence_of
from onika.module import AskAgain, InConst, Input, InVar, Local, Module, ModuleError, OutVar, finish


class Jpoly(Module):
    """Drives one joint by a polynomial of the share of time, on from where it is; the others stay where they are.

    q(t) = q0 + c1 s + c2 s^2 + c3 s^3 + c4 s^4 + c5 s^5,  s = t / T

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    SPEED            double        -      share of Q^_MAX that a motion may peak at
             SETTLE           double        s      how long the arm may take to come to rest
             AWAY             double        rad    how far from its target a joint may come to rest
    Input    joint            int           -      1..NDOF
             coefficients     double[5]     rad    of the powers 1 to 5
             duration         double        s      0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the arm stands at its end, or SETTLE later
    Errors   no rest       it does not begin and end at rest: asks again, stays OFF
             out of reach  it leaves QMIN..QMAX: asks again, stays OFF
             too fast      duration too short for SPEED: warns and takes as long as it needs
             blocked       a joint is further than AWAY from its target when its time is over: ERROR
    Get/Set  progress 0..1 / -
    Source   dissertation §4.4; Craig, Introduction to Robotics, §7.3
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    SPEED = Local("double", "-", "share of Q^_MAX that a motion may peak at", default=0.6, low=0.01, high=1.0)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "rad", "how far from its target a joint may come to rest", default=0.05, low=1e-3)

    joint = Input("int", "-", "which joint, counted from 1", low=1, high="NDOF")
    coefficients = Input("double[5]", "rad", "of the powers 1 to 5")
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def on(self, inputs):
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        coefficients = np.zeros((self.NDOF, 6))
        coefficients[:, 0] = start
        coefficients[int(inputs.joint) - 1, 1:] = inputs.coefficients
        try:
            path = PolynomialPath(coefficients, inputs.duration, self.SPEED * self.Qd_MAX)
            path.check_range(np.minimum(self.QMIN, start), np.maximum(self.QMAX, start))
        except ValueError as wrong:
            raise AskAgain(sentence_of(wrong)) from None
        if (shortest := path.duration) > inputs.duration * (1.0 + 1e-9):
            self.warn(
                "{duration:g} s is too short for the joint speeds; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._motion = JointMotion(path, path.at(path.duration)[0], self.Q_MEZ, self.SETTLE)
        self.Q_REF = start
        self.Qd_REF = 0.0

    def cycle(self):
        self.Q_REF, self.Qd_REF = self._motion.advance(self.dt)
        if not self._motion.is_over(self.Q_MEZ, self.dt):
            return None
        if why := self._motion.short(self.Q_MEZ, self.AWAY):
            raise ModuleError(why)
        return finish()

    def get(self, name):
        if name == "progress":
            return self._motion.progress
        return super().get(name)
