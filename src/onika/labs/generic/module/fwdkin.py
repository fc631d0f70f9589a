"""Forward kinematics."""

from onika.laws.arm import SerialArm
from onika.module import InConst, InVar, Module, OutVar


class Fwdkin(Module):
    """Where the tool is: forward kinematics of any arm.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF   int             -    number of joints
             INCONST  DH     double[NDOF,4]  -    a m, alpha rad, d m, theta offset rad
             INCONST  BASE   double[4,4]     -    frame 0 in the world
             INCONST  TOOL   double[4,4]     -    tool in the last frame
             INVAR    Q_MEZ  double[NDOF]    rad  measured position
             OUTVAR   X_MEZ  double[4,4]     -    pose of the tool in the world, position in m
    Source   dissertation §3.2.1; Fu, Gonzalez & Lee, Robotics, §2.2
    """

    NDOF = InConst("int", "-", "number of joints")
    DH = InConst("double[NDOF,4]", "-", "a m, alpha rad, d m, theta offset rad")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "tool in the last frame")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    X_MEZ = OutVar("double[4,4]", "-", "pose of the tool in the world, position in m")

    def init(self):
        self._arm = SerialArm(self.DH, base=self.BASE, tool=self.TOOL)
        self.cycle()  # the model of the arm is built with its first use: here, not when the task comes on

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        self._arm.forward(self.Q_MEZ, out=self.X_MEZ)
