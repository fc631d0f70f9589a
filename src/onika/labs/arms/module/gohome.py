"""Joint path home."""

from onika.laws.arrival import Arrival
from onika.laws.path import joint_duration, quintic
from onika.module import InConst, InVar, Local, Module, OutVar, finish


class Gohome(Module):
    """Joint path of fifth order from where the arm is to its home, whatever robot it is.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INCONST  HOME    double[NDOF]  rad    where it begins, and goes back to
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    SPEED            double        -      share of Q^_MAX that the motion peaks at
             SETTLE           double        s      how long the arm may take to come to rest
    Finish   flow 0, loop FALSE, when the time is over and the arm stands at home, or SETTLE later
    Get/Set  progress 0..1 / -
    Source   dissertation §4.2.1; Craig, Introduction to Robotics, §7.3
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    HOME = InConst("double[NDOF]", "rad", "where it begins, and goes back to")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    SPEED = Local("double", "-", "share of Q^_MAX that the motion peaks at", default=0.4, low=0.01, high=1.0)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)

    def on(self, inputs):
        self._start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._way = self.HOME - self._start
        self._duration = max(joint_duration(self._start, self.HOME, self.SPEED * self.Qd_MAX), self.dt)
        self._time = 0.0
        self._arrival = Arrival.of_joints(self.HOME, self.Q_MEZ, self.SETTLE)
        self.Q_REF = self._start
        self.Qd_REF = 0.0

    def cycle(self):
        self._time += self.dt
        share, rate = quintic(self._time, self._duration)
        self.Q_REF = self._start + share * self._way
        self.Qd_REF = rate * self._way
        if self._arrival.is_over(self._time - self._duration, self.Q_MEZ, self.dt):
            return finish()
        return None

    def get(self, name):
        if name == "progress":
            return min(self._time / self._duration, 1.0)
        return super().get(name)
