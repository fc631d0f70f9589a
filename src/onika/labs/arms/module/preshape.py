"""A posture of a hand."""

from onika.laws.arrival import Arrival
from onika.laws.path import joint_duration, quintic
from onika.module import InConst, Input, InVar, Local, Module, OutVar, finish


class Preshape(Module):
    """Brings the fingers of a hand to a posture, one after the other or all at once.

    q(t) = q0 + (q1 - q0) (10 s^3 - 15 s^4 + 6 s^5),  s = (t - k LATER) / T for finger k

    Joints stand in rows of FINGERS, one of each finger. A finger that meets something stays there and presses as hard
    as its drives may: that is how a hand grasps, and no error.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; q0 where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is q0
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    FINGERS          int           -      how many fingers there are
             LATER            double        s      how much later than the one before it a finger begins
             SPEED            double        -      share of Q^_MAX that a motion may peak at
             SETTLE           double        s      how long the fingers may take to come to rest
    Input    endpoint         double[NDOF]  rad    QMIN..QMAX
             duration         double        s      0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the fingers stand at the target, or SETTLE later
    Errors   too fast         duration too short for SPEED: warns and takes as long as it needs
    Get/Set  progress 0..1 / -
    Source   dissertation §4.5.3; Cutkosky, On Grasp Choice, 1989
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; q0 where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is q0")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    FINGERS = Local("int", "-", "how many fingers there are", default=3, low=1)
    LATER = Local("double", "s", "how much later than the one before it a finger begins", default=0.0, low=0.0)
    SPEED = Local("double", "-", "share of Q^_MAX that a motion may peak at", default=0.6, low=0.01, high=1.0)
    SETTLE = Local("double", "s", "how long the fingers may take to come to rest", default=0.3, low=0.0)

    endpoint = Input("double[NDOF]", "rad", "posture of the fingers", low="QMIN", high="QMAX")
    duration = Input("double", "s", "how long each finger takes", low=0.1, high=600.0)

    def on(self, inputs):
        self._start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._way = inputs.endpoint - self._start
        shortest = joint_duration(self._start, inputs.endpoint, self.SPEED * self.Qd_MAX)
        if inputs.duration < shortest * (1.0 - 1e-9):
            self.warn(
                "{duration:g} s is too short for the joint speeds; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._time, self._one = 0.0, max(inputs.duration, shortest)
        self._duration = self._one + self.LATER * (self.FINGERS - 1)
        self._arrival = Arrival.of_joints(inputs.endpoint, self.Q_MEZ, self.SETTLE)
        self.Q_REF = self._start
        self.Qd_REF = 0.0

    def cycle(self):
        self._time += self.dt
        for finger in range(self.FINGERS):
            share, rate = quintic(self._time - finger * self.LATER, self._one)
            joints = slice(finger, None, self.FINGERS)
            self.Q_REF[joints] = self._start[joints] + share * self._way[joints]
            self.Qd_REF[joints] = rate * self._way[joints]
        is_over = self._arrival.is_over(self._time - self._duration, self.Q_MEZ, self.dt)
        return finish() if is_over else None

    def get(self, name):
        if name == "progress":
            return min(self._time / self._duration, 1.0)
        return super().get(name)
