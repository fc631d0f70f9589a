"""Torques that bring an arm along its reference."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.filter import Derivative
from onika.module import InConst, InVar, Local, Module, OutVar


class Comptorque(Module):
    """Computed torque: any arm follows its reference as if each joint were a mass on a critically damped spring.

    tau = M(q) a + c(q, qd) + g(q) + b qd_ref + f tanh(qd_ref / 0.05)
    a = qdd_ref + W^2 (q_ref - q) + 2 W (qd_ref - qd)

    It needs no gains of a robot. Friction is paid for ahead, by the wanted speed: the measured one would shake light
    links.

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  NDOF     int              -      number of joints
             INCONST  SCREW    double[NDOF,6]   -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  LINK     double[NDOF,13]  -      mass, centre, inertia, armature, friction of each link (SI)
             INCONST  PARENT   int[NDOF]        -      the joint that bears each joint; -1: the base
             INCONST  LOAD     double[4]        -      a load besides: mass kg, centre m, at q = 0 in frame 0
             INCONST  BASE     double[4,4]      -      frame 0 in the world
             INVAR    Q_REF    double[NDOF]     rad    reference position
             INVAR    Q^_REF   double[NDOF]     rad/s  reference speed; its own derivative is paid for ahead
             INVAR    Q_MEZ    double[NDOF]     rad    measured position
             INVAR    Q^_MEZ   double[NDOF]     rad/s  measured speed
             OUTVAR   TAU_REF  double[NDOF]     N m    wanted torque
    Local    W                 double           rad/s  how stiff: natural frequency of each joint
             AHEAD             double           Hz     low-pass of the reference's acceleration
    Errors   no reference      Q_REF was not written since the hardware held: only brakes until it is
    Source   Craig, Introduction to Robotics, §10.4; Lynch & Park, Modern Robotics, §11.4
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    LINK = InConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    LOAD = InConst("double[4]", "-", "a load besides: mass kg, centre m, at q = 0 in frame 0")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    Q_REF = InVar("double[NDOF]", "rad", "reference position")
    Qd_REF = InVar("double[NDOF]", "rad/s", "reference speed; its own derivative is paid for ahead", name="Q^_REF")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_REF = OutVar("double[NDOF]", "N m", "wanted torque")

    W = Local("double", "rad/s", "how stiff: natural frequency of each joint", default=40.0, low=1.0, high=200.0)
    AHEAD = Local("double", "Hz", "low-pass of the reference's acceleration", default=20.0, low=0.1, high=1000.0)

    def init(self):
        self._arm = ArmModel(self.SCREW, self.LINK, self.PARENT, self.LOAD, self.BASE)
        self._rest = np.zeros(self.NDOF)
        self._arm.bias(self._rest, self._rest)  # the model is built with its first use: here, not in a cycle

    def on(self, inputs):
        # a reference from before the last hold would tear the arm away: it is not followed until it is written anew
        self._stale = None if self.continues("Q_REF") else self.Q_REF.copy()
        self._derivative = Derivative(self.NDOF, self.dt, self.AHEAD)
        self._derivative.reset(self.Qd_REF)
        self.cycle()

    def cycle(self):
        if self._stale is not None and np.array_equal(self.Q_REF, self._stale):
            brake = -2.0 * self.W * self.Qd_MEZ
            self.TAU_REF = self._arm.torque(self.Q_MEZ, self.Qd_MEZ, brake)
            return
        if self._stale is not None:
            self._stale = None
            self._derivative.reset(self.Qd_REF)
        wanted, w = self.Qd_REF, self.W
        ahead = self._derivative.update(wanted)
        acceleration = ahead + w * w * (self.Q_REF - self.Q_MEZ) + 2.0 * w * (wanted - self.Qd_MEZ)
        self._arm.torque(self.Q_MEZ, self.Qd_MEZ, acceleration, out=self.TAU_REF)
        self.TAU_REF += self._arm.viscous * wanted + self._arm.dry * np.tanh(wanted / 0.05)
