"""Forward kinematics."""

from onika.laws.arm import ArmModel
from onika.module import InConst, InVar, Module, OutVar


class Fwdkin(Module):
    """Where the tool is: forward kinematics of any arm.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int             -    number of joints
             INCONST  SCREW   double[NDOF,6]  -    axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -    the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -    frame 0 in the world
             INCONST  TOOL    double[4,4]     -    the tool at q = 0 in frame 0
             INVAR    Q_MEZ   double[NDOF]    rad  measured position
             OUTVAR   X_MEZ   double[4,4]     -    pose of the tool in the world, position in m
    Source   dissertation §3.2.1; Lynch & Park, Modern Robotics, §4.1
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    X_MEZ = OutVar("double[4,4]", "-", "pose of the tool in the world, position in m")

    def init(self):
        self._arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)
        self.cycle()  # the model of the arm is built with its first use: here, not when the task comes on

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        self._arm.forward(self.Q_MEZ, out=self.X_MEZ)
