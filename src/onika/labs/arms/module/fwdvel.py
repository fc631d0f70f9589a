"""How fast the tool is."""

from onika.laws.arm import ArmModel
from onika.module import InConst, InVar, Module, OutVar


class Fwdvel(Module):
    """How fast the tool is: the twist of any arm's tool in the world, by its Jacobian.

    v = J(q) qd

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int             -          number of joints
             INCONST  SCREW   double[NDOF,6]  -          axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -          the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -          frame 0 in the world
             INCONST  TOOL    double[4,4]     -          the tool at q = 0 in frame 0
             INVAR    Q_MEZ   double[NDOF]    rad        measured position
             INVAR    Q^_MEZ  double[NDOF]    rad/s      measured speed
             OUTVAR   V_MEZ   double[6]       m/s,rad/s  speed of the tool x, y, z and of its turning about x, y, z
    Source   Craig, Introduction to Robotics, §5.6; Lynch & Park, Modern Robotics, §5.1
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    V_MEZ = OutVar("double[6]", "m/s,rad/s", "speed of the tool x, y, z and of its turning about x, y, z")

    def init(self):
        self._arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)
        self.cycle()  # the model of the arm is built with its first use: here, not when the task comes on

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        self.V_MEZ = self._arm.jacobian(self.Q_MEZ) @ self.Qd_MEZ
