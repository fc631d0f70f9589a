"""Force on the tool, as the servo feels it."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.module import InConst, InVar, Module, OutVar

SOFT = 0.05  # m: what a lever shorter than that would say of a force is not believed


class ToolForce(Module):
    """What presses on the tool, from what the servo has to do beyond the model of the arm.

    F = -(J J^T + s^2)^-1 J tau, J the Jacobian of the tool in the world

    No sensor is behind it. Gravity, Coriolis forces and friction are in the torque of the model; what the servo adds
    holds against what touches the arm, and accelerates it. So it is true where the arm stands, or goes slowly and
    evenly, and is touched at its tool; what it carries beyond LOAD is felt as well.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int             -      number of joints
             INCONST  SCREW   double[NDOF,6]  -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -      the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -      frame 0 in the world
             INCONST  TOOL    double[4,4]     -      the tool at q = 0 in frame 0
             INVAR    Q_MEZ   double[NDOF]    rad    measured position
             INVAR    TAU_PD  double[NDOF]    N m    torque of the servo
             OUTVAR   F_MEZ   double[6]       N,N m  force on the tool and torque about it, along the axes of the world
    Source   Craig, Introduction to Robotics, §5.9
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    TAU_PD = InVar("double[NDOF]", "N m", "torque of the servo")
    F_MEZ = OutVar("double[6]", "N,N m", "force on the tool and torque about it, along the axes of the world")

    def init(self):
        self._arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)
        self._jacobian = np.zeros((6, self.NDOF))
        self._soft = SOFT**2 * np.eye(6)
        self.cycle()  # the model of the arm is built with its first use: here, not when the task comes on

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        jacobian = self._arm.jacobian(self.Q_MEZ, out=self._jacobian)
        self.F_MEZ = -np.linalg.solve(jacobian @ jacobian.T + self._soft, jacobian @ self.TAU_PD)
