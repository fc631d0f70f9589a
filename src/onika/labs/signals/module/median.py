"""A median filter."""

import numpy as np

from onika.laws.finite import FiniteValues
from onika.module import InConst, InVar, Local, Module, OutVar


class Median(Module):
    """Takes spikes out of joint positions: what comes out is the middle one of the last values, by size.

    Spikes that fill less than half of the window leave no trace. A ramp comes late by half of the window.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what comes in
             OUTVAR   Z     double[NDOF]  rad  what passes; always finite
    Local    WINDOW         int           -    how many values; an even number counts as one more
    Errors   no number  what is NaN or infinite leaves the number before
    Source   Tukey, Exploratory Data Analysis, §7
    """

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what comes in")
    Z = OutVar("double[NDOF]", "rad", "what passes; always finite")

    WINDOW = Local("int", "-", "how many values; an even number counts as one more", default=5, low=1, high=99)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._values = np.tile(self._sound.take(self.Y), (self.WINDOW | 1, 1))
        self._next = 0
        self.Z = self._sound.values

    def cycle(self):
        self._values[self._next] = self._sound.take(self.Y)
        self._next = (self._next + 1) % len(self._values)
        self.Z = np.median(self._values, axis=0)
