"""Joint path of limited jerk."""

from onika.laws.joint_motion import JointMotion
from onika.laws.paths.jerk_limited import JerkLimited
from onika.module import InConst, Input, InVar, Local, Module, ModuleError, OutVar, finish


class Jruckig(Module):
    """Joint path as quick as speeds, accelerations and jerks allow, or as slow as its duration says.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF     int           -        number of joints
             INCONST  QMIN     double[NDOF]  rad      lower joint limits
             INCONST  QMAX     double[NDOF]  rad      upper joint limits
             INCONST  Q^_MAX   double[NDOF]  rad/s    highest joint speeds
             INVAR    Q_MEZ    double[NDOF]  rad      measured position; the start where no reference is in force
             OUTVAR   Q_REF    double[NDOF]  rad      reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF   double[NDOF]  rad/s    reference speed
             OUTVAR   Q^^_REF  double[NDOF]  rad/s^2  reference acceleration
    Local    SPEED             double        -        share of Q^_MAX that a motion may peak at
             RISE              double        s        how long it takes to the peak speed at full acceleration
             EASE              double        s        how long it takes to full acceleration
             SETTLE            double        s        how long the arm may take to come to rest
             AWAY              double        rad      how far from its target a joint may come to rest
    Input    endpoint          double[NDOF]  rad      QMIN..QMAX
             duration          double        s        0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the arm stands at the target, or SETTLE later
    Errors   out of reach  endpoint beyond QMIN..QMAX: asks again, stays OFF
             too fast      duration too short for the limits: warns and takes as long as it needs
             blocked       a joint is further than AWAY from its target when its time is over: ERROR
    Get/Set  progress 0..1 / -
    Source   Berscheid & Kröger, Jerk-limited Real-time Trajectory Generation, 2021
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")
    Qdd_REF = OutVar("double[NDOF]", "rad/s^2", "reference acceleration", name="Q^^_REF")

    SPEED = Local("double", "-", "share of Q^_MAX that a motion may peak at", default=0.6, low=0.01, high=1.0)
    RISE = Local("double", "s", "how long it takes to the peak speed at full acceleration", default=0.3, low=0.01)
    EASE = Local("double", "s", "how long it takes to full acceleration", default=0.1, low=0.001)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "rad", "how far from its target a joint may come to rest", default=0.05, low=1e-3)

    endpoint = Input("double[NDOF]", "rad", "where to go", low="QMIN", high="QMAX")
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def on(self, inputs):
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        speed = self.SPEED * self.Qd_MAX
        limits = speed, speed / self.RISE, speed / (self.RISE * self.EASE)
        course = JerkLimited(start, inputs.endpoint, *limits, inputs.duration)
        if (shortest := course.duration) > inputs.duration * (1.0 + 1e-9):
            self.warn(
                "{duration:g} s is too short for the joint speeds; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._motion = JointMotion(course, inputs.endpoint, self.Q_MEZ, self.SETTLE)
        self.Q_REF = start
        self.Qd_REF = self.Qdd_REF = 0.0

    def cycle(self):
        self.Q_REF, self.Qd_REF, self.Qdd_REF = self._motion.advance(self.dt)
        if not self._motion.is_over(self.Q_MEZ, self.dt):
            return None
        if why := self._motion.short(self.Q_MEZ, self.AWAY):
            raise ModuleError(why)
        return finish()

    def get(self, name):
        if name == "progress":
            return self._motion.progress
        return super().get(name)
