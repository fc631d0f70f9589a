"""The arm in an outside 3-D view."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.module import InConst, InVar, Local, Module, Partner


class View3d(Module):
    """Has an outside 3-D view show where the arm is: the places of its joints and the pose of its tool.

    Kind     passive, synchronous, 1..60 Hz
    Ports    INCONST  NDOF    int             -    number of joints
             INCONST  SCREW   double[NDOF,6]  -    axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -    the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -    frame 0 in the world
             INCONST  TOOL    double[4,4]     -    the tool at q = 0 in frame 0
             INVAR    Q_MEZ   double[NDOF]    rad  measured position
    Local    PARTNER          line            -    where the view listens: unix:PATH or tcp:HOST:PORT
             STARTS           line            -    what starts the view, if the task is to do that
             PATIENCE         double          s    how long the view may take to answer
    Errors   no answer       warns and goes off
    Source   dissertation §5.8.3; Lynch & Park, Modern Robotics, §4.1
    """

    passive = True

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")

    PARTNER = Local("line", "-", "where the view listens: unix:PATH or tcp:HOST:PORT", default="")
    STARTS = Local("line", "-", "what starts the view, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the view may take to answer", default=1.0, low=0.001, high=3600.0)

    def init(self):
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)
        self._arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)

    def cycle(self):
        tool = self._arm.forward(self.Q_MEZ)
        points = np.array([self.BASE[:3, 3], *self._arm.joint_places(self.Q_MEZ), tool[:3, 3]])
        self.partner.ask("pose", t=self.now, points=points, tool=tool)
