"""Joint path to the target by way of points that an outside path planner names."""

from itertools import pairwise

import numpy as np

from onika.laws.path import joint_duration, quintic
from onika.module import InConst, Input, InVar, Local, Module, OutVar, Partner, finish

NEAR = 1e-3  # rad
STILL = 0.01  # rad/s


class Planner(Module):
    """Joint path to the target by way of points that an outside path planner names; it rests at each of them.

    Until the planner has answered the arm stays where it is. What it answers is believed only where it is finite and
    within the limits of the joints.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    PARTNER          line          -      where the planner listens: unix:PATH or tcp:HOST:PORT
             STARTS           line          -      what starts the planner, if the task is to do that
             PATIENCE         double        s      how long the planner may take to answer
             SPEED            double        -      share of Q^_MAX that a motion may peak at
             SETTLE           double        s      how long the arm may take to come to rest
    Input    endpoint         double[NDOF]  rad    QMIN..QMAX
             duration         double        s      0.1..600
    Finish   flow 0, loop FALSE, when the time is over and the arm stands at the target, or SETTLE later
    Errors   no answer         ERROR, the arm stays where it is
             a false answer    points that are not finite or beyond QMIN..QMAX: ERROR, the arm stays where it is
             too fast          time too short for SPEED: warns and takes as long as it needs
    Get/Set  points, how many the planner named / -
    Source   dissertation §5.8.3, Figure 23
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    PARTNER = Local("line", "-", "where the planner listens: unix:PATH or tcp:HOST:PORT", default="")
    STARTS = Local("line", "-", "what starts the planner, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the planner may take to answer", default=2.0, low=0.001, high=3600.0)
    SPEED = Local("double", "-", "share of Q^_MAX that a motion may peak at", default=0.6, low=0.01, high=1.0)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)

    endpoint = Input("double[NDOF]", "rad", "where to go", low="QMIN", high="QMAX")
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def init(self):
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)

    def on(self, inputs):
        self._start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._end, self._duration = inputs.endpoint.copy(), float(inputs.duration)
        self._legs, self._leg, self._time = [], 0, 0.0
        self._last = self.Q_MEZ.copy()
        self.Q_REF = self._start
        self.Qd_REF = 0.0
        self.partner.ask("path", start=self._start, end=self._end, low=self.QMIN, high=self.QMAX)

    def cycle(self):
        if self._legs:
            return self._go_on()
        if self.partner.has_answered():
            self._lay(self.partner.answer.numbers("via", (None, self.NDOF), self.QMIN, self.QMAX))
        return None

    def get(self, name):
        if name == "points":
            return max(len(self._legs) - 1, 0)
        return super().get(name)

    def _lay(self, via):
        points = [self._start, *via, self._end]
        needs = [joint_duration(a, b, self.SPEED * self.Qd_MAX) for a, b in pairwise(points)]
        whole = sum(needs)
        if whole > self._duration:
            self.warn(
                "{duration:g} s is too short for the joint speeds; it takes {shortest:.2f} s",
                duration=self._duration,
                shortest=whole,
            )
        stretch = max(self._duration, whole) / whole if whole else 0.0
        self._legs = [(a, b - a, need * stretch) for (a, b), need in zip(pairwise(points), needs, strict=True)]

    def _go_on(self):
        self._time += self.dt
        while self._leg < len(self._legs) - 1 and self._time >= self._legs[self._leg][2]:
            self._time -= self._legs[self._leg][2]
            self._leg += 1
        start, way, duration = self._legs[self._leg]
        share, speed = quintic(self._time, duration)
        self.Q_REF = start + share * way
        self.Qd_REF = speed * way
        over = self._time - duration if self._leg == len(self._legs) - 1 else -1.0
        rests = self._rests()
        if over >= self.SETTLE or (over >= 0.0 and rests):
            return finish()
        return None

    def _rests(self):
        moved = np.abs(self.Q_MEZ - self._last).max()
        self._last[:] = self.Q_MEZ
        return moved < STILL * self.dt and np.abs(self.Q_MEZ - self._end).max() < NEAR
