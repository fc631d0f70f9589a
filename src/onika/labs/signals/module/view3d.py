"""The arm in an outside 3-D view."""

import numpy as np

from onika.laws.chain import kinds_of
from onika.laws.frames import dh_transform
from onika.module import InConst, InVar, Local, Module, Partner


class View3d(Module):
    """Has an outside 3-D view show where the arm is: the places of its joints and the pose of its tool.

    Kind     passive, synchronous, 1..60 Hz
    Ports    INCONST  NDOF   int             -    number of joints
             INCONST  DH     double[NDOF,4]  -    a m, alpha rad, d m, theta offset rad
             INCONST  BASE   double[4,4]     -    frame 0 in the world
             INCONST  TOOL   double[4,4]     -    tool in the last frame
             INVAR    Q_MEZ  double[NDOF]    rad  measured position
    Local    PARTNER         line            -    where the view listens: unix:PATH or tcp:HOST:PORT
             STARTS          line            -    what starts the view, if the task is to do that
             PATIENCE        double          s    how long the view may take to answer
    Errors   no answer       warns and goes off
    Source   dissertation §5.8.3; Fu, Gonzalez & Lee, Robotics, §2.2
    """

    passive = True

    NDOF = InConst("int", "-", "number of joints")
    DH = InConst("double[NDOF,4]", "-", "a m, alpha rad, d m, theta offset rad")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "tool in the last frame")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")

    PARTNER = Local("line", "-", "where the view listens: unix:PATH or tcp:HOST:PORT", default="")
    STARTS = Local("line", "-", "what starts the view, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the view may take to answer", default=1.0, low=0.001, high=3600.0)

    def init(self):
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)
        self._slides = kinds_of(self.DH)

    def cycle(self):
        frames = [self.BASE]
        for (a, alpha, d, theta), slides, q in zip(self.DH, self._slides, self.Q_MEZ, strict=True):
            frames.append(frames[-1] @ dh_transform(a, alpha, d + q * slides, theta + q * (1.0 - slides)))
        tool = frames[-1] @ self.TOOL
        points = np.array([frame[:3, 3] for frame in [*frames, tool]])
        self.partner.ask("pose", t=self.now, points=points, tool=tool)
