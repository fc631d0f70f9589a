"""Pose of a platform on six legs."""

import numpy as np

from onika.laws.stewart import Platform
from onika.module import InVar, Local, Module, ModuleError, OutVar


class StewartFwd(Module):
    """Where the plate of a platform on six legs is, by Newton from where it was.

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   Q_MEZ      double[6]    rad  measured position of the legs (m)
             OUTVAR  PLATE_MEZ  double[4,4]  -    pose of the plate in the base, position in m
    Local    FEET           double[18]   m  where the legs stand in the base: x y z of each of the six
             HEADS          double[18]   m  where they end in the plate: x y z of each of the six
             REST           double       m  length of a leg whose joint is at 0
    Errors   no pose         no pose near the last one has these legs: ERROR; clear begins above the base again
    Source   Merlet, Parallel Robots, §4
    """

    Q_MEZ = InVar("double[6]", "rad", "measured position of the legs (m)")
    PLATE_MEZ = OutVar("double[4,4]", "-", "pose of the plate in the base, position in m")

    FEET = Local("double[18]", "m", "where the legs stand in the base: x y z of each of the six")
    HEADS = Local("double[18]", "m", "where they end in the plate: x y z of each of the six")
    REST = Local("double", "m", "length of a leg whose joint is at 0")

    def init(self):
        self._platform = Platform(self.FEET, self.HEADS)
        self._pose = np.eye(4)
        self._pose[2, 3] = self.REST

    def on(self, inputs):
        pose = self._platform.pose(self.Q_MEZ + self.REST, self._pose)
        self.PLATE_MEZ = self._pose if isinstance(pose, str) else pose

    def cycle(self):
        pose = self._platform.pose(self.Q_MEZ + self.REST, self._pose)
        if isinstance(pose, str):
            raise ModuleError(pose)
        self._pose = pose
        self.PLATE_MEZ = pose

    def clear(self):
        self.init()
