"""A place that goes round."""

import math

from onika.laws.frames import pose_of_nine
from onika.laws.sentence import sentence_of
from onika.module import Local, Module, ModuleError, OutVar


class Orbit(Module):
    """A pose that goes round a circle for ever, as a part on a turntable: something to track where no camera looks.

    Kind     general, periodic, 20..1000 Hz
    Ports    OUTVAR  X_PART  double[4,4]  -  the pose in the world; at `on` it is beside its middle along x
    Local    MIDDLE          double[9]    -  approach, normal, position (m) of the middle in the world
             RADIUS          double       m  how far from the middle it is
             ROUND           double       s  how long it takes to go round once
    Errors   no pose  MIDDLE has vectors that are no unit vectors, or not square: stays uninitialised
    """

    X_PART = OutVar("double[4,4]", "-", "the pose in the world; at `on` it is beside its middle along x")

    MIDDLE = Local(
        "double[9]",
        "-",
        "approach, normal, position (m) of the middle in the world",
        default=(0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.5, 0.0, 0.0),
    )
    RADIUS = Local("double", "m", "how far from the middle it is", default=0.05, low=0.0, high=1.0)
    ROUND = Local("double", "s", "how long it takes to go round once", default=8.0, low=0.5, high=3600.0)

    def init(self):
        try:
            self._middle = pose_of_nine([float(number) for number in self.MIDDLE])
        except ValueError as wrong:
            raise ModuleError(sentence_of(wrong)) from None

    def on(self, inputs):
        self._turns = 0.0
        self._place()

    def cycle(self):
        self._turns = (self._turns + self.dt / self.ROUND) % 1.0
        self._place()

    def _place(self):
        angle = 2.0 * math.pi * self._turns
        self.X_PART = self._middle
        self.X_PART[0, 3] += self.RADIUS * math.cos(angle)
        self.X_PART[1, 3] += self.RADIUS * math.sin(angle)
