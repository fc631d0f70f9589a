"""What the arm holds, by what its joints bear."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.payload import PayloadEstimate
from onika.module import InConst, InVar, Local, Module, OutVar


class Payload(Module):
    """Mass and centre of what the tool holds, learnt from the torques while the arm is nearly still in some postures.

    Kind     general, periodic, 10..500 Hz
    Ports    INCONST  NDOF      int              -      number of joints
             INCONST  SCREW     double[NDOF,6]   -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  LINK      double[NDOF,13]  -      mass, centre, inertia, armature, friction of each link (SI)
             INCONST  PARENT    int[NDOF]        -      the joint that bears each joint; -1: the base
             INCONST  BASE      double[4,4]      -      frame 0 in the world
             INCONST  TOOL      double[4,4]      -      the tool at q = 0 in frame 0
             INVAR    Q_MEZ     double[NDOF]     rad    measured position
             INVAR    Q^_MEZ    double[NDOF]     rad/s  measured speed
             INVAR    TAU_MEZ   double[NDOF]     N m    torque of the drive, what bears the weight in it
             OUTVAR   LOAD_MEZ  double[4]        -      what is held: mass kg, centre m, at q = 0 in frame 0
    Local    STILL              double           rad/s  a joint that is faster: nothing is learnt
             MEMORY             double           s      what was measured so long ago counts a third
    Source   Atkeson, An & Hollerbach, Estimation of Inertial Parameters of Manipulator Loads and Links, 1986
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    LINK = InConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_MEZ = InVar("double[NDOF]", "N m", "torque of the drive, what bears the weight in it")
    LOAD_MEZ = OutVar("double[4]", "-", "what is held: mass kg, centre m, at q = 0 in frame 0")

    STILL = Local("double", "rad/s", "a joint that is faster: nothing is learnt", default=0.05, low=1e-6)
    MEMORY = Local("double", "s", "what was measured so long ago counts a third", default=10.0, low=0.01)

    def init(self):
        self._arm = ArmModel(self.SCREW, self.LINK, self.PARENT, None, self.BASE, self.TOOL)
        self._estimate = PayloadEstimate(self._arm, self.MEMORY / self.dt)
        self._arm.forward(np.zeros(self.NDOF))  # the model is built with its first use: here, not in a cycle

    def on(self, inputs):
        self._estimate.reset()
        self.LOAD_MEZ = self._estimate.load()

    def cycle(self):
        if np.abs(self.Qd_MEZ).max() > self.STILL:
            return
        own = self._arm.bias(self.Q_MEZ, self.Qd_MEZ) + self._arm.viscous * self.Qd_MEZ
        self._estimate.take(self.Q_MEZ, self.TAU_MEZ - own)
        self.LOAD_MEZ = self._estimate.load()
