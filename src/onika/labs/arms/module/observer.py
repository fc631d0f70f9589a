"""What presses on an arm, joint by joint."""

from onika.laws.arm import ArmModel
from onika.laws.signals.momentum_observer import MomentumObserver
from onika.module import InConst, InVar, Local, Module, OutVar


class TorqueObserver(Module):
    """Torque that the surroundings bring to each joint, from momentum and motor torque; no sensor is behind it.

    It follows with a lag of 1/GAIN seconds, also while the arm accelerates. What is carried and not in LOAD counts as
    pressing, and so does friction that is not in LINK.

    Kind     general, periodic, 50..1000 Hz
    Ports    INCONST  NDOF     int              -      number of joints
             INCONST  SCREW    double[NDOF,6]   -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  LINK     double[NDOF,13]  -      mass, centre, inertia, armature, friction of each link (SI)
             INCONST  PARENT   int[NDOF]        -      the joint that bears each joint; -1: the base
             INCONST  LOAD     double[4]        -      the hand: mass kg, centre m, at q = 0 in frame 0
             INCONST  BASE     double[4,4]      -      frame 0 in the world
             INVAR    Q_MEZ    double[NDOF]     rad    measured position
             INVAR    Q^_MEZ   double[NDOF]     rad/s  measured speed
             INVAR    TAU_REF  double[NDOF]     N m    torque of the motors
             OUTVAR   TAU_EXT  double[NDOF]     N m    torque from outside
    Local    GAIN              double           1/s    how quickly it follows
    Errors   no number         a measurement that is NaN or infinite is passed over
    Source   De Luca & Mattone, ICRA 2003; Haddadin et al., IEEE T-RO 33, 2017
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    LINK = InConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    LOAD = InConst("double[4]", "-", "the hand: mass kg, centre m, at q = 0 in frame 0")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_REF = InVar("double[NDOF]", "N m", "torque of the motors")
    TAU_EXT = OutVar("double[NDOF]", "N m", "torque from outside")

    GAIN = Local("double", "1/s", "how quickly it follows", default=20.0, low=0.1, high=200.0)

    def init(self):
        self._arm = ArmModel(self.SCREW, self.LINK, self.PARENT, self.LOAD, self.BASE)
        self._arm.inertia(self.Q_MEZ)  # the model of the arm is built with its first use: here, not in a cycle

    def on(self, inputs):
        self._observer = MomentumObserver(self._arm, self.GAIN)
        self.TAU_EXT = 0.0

    def cycle(self):
        measured = self.Q_MEZ, self.Qd_MEZ, self.TAU_REF
        if all(abs(values).max() < float("inf") for values in measured):
            self.TAU_EXT = self._observer.follow(*measured, self.dt)
