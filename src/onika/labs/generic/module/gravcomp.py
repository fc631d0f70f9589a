"""Torque against gravity, Coriolis forces and viscous friction."""

from onika.laws.arm import ArmModel
from onika.module import InConst, InVar, Module, OutVar


class Gravcomp(Module):
    """Torque that lets an arm float: against gravity, Coriolis forces and viscous friction.

    tau = g(q) + c(q, qd) + b qd

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int              -      number of joints
             INCONST  SCREW   double[NDOF,6]   -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  LINK    double[NDOF,13]  -      mass, centre, inertia, armature, friction of each link (SI)
             INCONST  PARENT  int[NDOF]        -      the joint that bears each joint; -1: the base
             INCONST  LOAD    double[4]        -      the hand: mass kg, centre m, at q = 0 in frame 0
             INCONST  BASE    double[4,4]      -      frame 0 in the world
             INVAR    Q_MEZ   double[NDOF]     rad    measured position
             INVAR    Q^_MEZ  double[NDOF]     rad/s  measured speed
             OUTVAR   TAU_G   double[NDOF]     N m    the torque
    Source   dissertation §3.2.1; Craig, Introduction to Robotics, §6.4
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    LINK = InConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    LOAD = InConst("double[4]", "-", "the hand: mass kg, centre m, at q = 0 in frame 0")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_G = OutVar("double[NDOF]", "N m", "the torque")

    def init(self):
        self._arm = ArmModel(self.SCREW, self.LINK, self.PARENT, self.LOAD, self.BASE)
        self._friction = self._arm.viscous
        self.cycle()  # the model of the arm is built with its first use: here, not when the task comes on

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        torque, speed = self.TAU_G, self.Qd_MEZ
        self._arm.bias(self.Q_MEZ, speed, out=torque)
        torque += self._friction * speed
