"""One joint alone."""

from onika.laws.arrival import Arrival
from onika.laws.path import PEAK, quintic
from onika.laws.sentence import joint_beyond
from onika.module import AskAgain, InConst, Input, InVar, Local, Module, ModuleError, OutVar, finish


class Jdrive(Module):
    """Drives one joint to an angle on a path of fifth order; the others stay where they are.

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
             angle            double        rad    -1000..1000
             duration         double        s      0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the arm stands at the target, or SETTLE later
    Errors   out of reach  angle beyond QMIN..QMAX of the joint: asks again, stays OFF
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
    angle = Input("double", "rad", "where the joint is to go", low=-1e3, high=1e3)
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def on(self, inputs):
        self._joint = joint = int(inputs.joint) - 1
        low, high = float(self.QMIN[joint]), float(self.QMAX[joint])
        if not low <= inputs.angle <= high:
            raise AskAgain(joint_beyond(joint + 1, inputs.angle, "rad", low, high))
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._from = float(start[joint])
        self._way = inputs.angle - self._from
        shortest = PEAK * abs(self._way) / (self.SPEED * float(self.Qd_MAX[joint]))
        if inputs.duration < shortest * (1.0 - 1e-9):
            self.warn(
                "{duration:g} s is too short for the joint speeds; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._time, self._duration = 0.0, max(inputs.duration, shortest)
        self.Q_REF = start
        self.Qd_REF = 0.0
        end = start.copy()
        end[joint] = inputs.angle
        self._arrival = Arrival.of_joints(end, self.Q_MEZ, self.SETTLE)

    def cycle(self):
        self._time += self.dt
        share, rate = quintic(self._time, self._duration)
        self.Q_REF[self._joint] = self._from + share * self._way
        self.Qd_REF[self._joint] = rate * self._way
        is_over = self._arrival.is_over(self._time - self._duration, self.Q_MEZ, self.dt)
        if not is_over:
            return None
        if why := self._arrival.joint_short(self.Q_MEZ, self.AWAY):
            raise ModuleError(why)
        return finish()

    def get(self, name):
        if name == "progress":
            return min(self._time / self._duration, 1.0)
        return super().get(name)
