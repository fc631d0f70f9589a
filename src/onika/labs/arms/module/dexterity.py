"""How freely the tool can move where the arm stands."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.module import InConst, InVar, Module, OutVar


class Dexterity(Module):
    """How freely the tool can move: how far any arm is from its singular postures and from its limits.

    Kind     general, periodic, 1..500 Hz
    Ports    INCONST  NDOF    int             -   number of joints
             INCONST  SCREW   double[NDOF,6]  -   axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -   the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -   frame 0 in the world
             INCONST  TOOL    double[4,4]     -   the tool at q = 0 in frame 0
             INCONST  QMIN    double[NDOF]    rad  lower joint limits
             INCONST  QMAX    double[NDOF]    rad  upper joint limits
             INVAR    Q_MEZ   double[NDOF]    rad  measured position
             OUTVAR   DEX     double[3]       -    smallest singular value, product of all, way to the nearest limit
    Source   Yoshikawa, Manipulability of Robotic Mechanisms, 1985; Lynch & Park, Modern Robotics, §5.4
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    DEX = OutVar("double[3]", "-", "smallest singular value, product of all, way to the nearest limit")

    def init(self):
        self._arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)
        self.cycle()  # the model of the arm is built with its first use: here, not when the task comes on

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        sizes = np.linalg.svd(self._arm.jacobian(self.Q_MEZ), compute_uv=False)
        room = min(np.min(self.QMAX - self.Q_MEZ), np.min(self.Q_MEZ - self.QMIN), 1e3)
        self.DEX = sizes[-1], np.prod(sizes), room
