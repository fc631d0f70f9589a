"""A measured vector of which one element drifts."""

import math

from onika.laws.finite import FiniteValues
from onika.laws.onset import Onset
from onika.laws.sentence import no_element
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class SlowDrift(Module):
    """A fault to try: one element of what is measured is off by more and more.

    As an encoder that slips, or a sensor that warms up.

    Kind     passive, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what is measured
             OUTVAR   Z     double[NDOF]  rad  what its readers get; always finite
    Local    ELEMENT  int     -      which element drifts, from 0
             RATE     double  rad/s  how fast it drifts, and which way
             MOST     double  rad    where the drift ends
             AFTER    double  s      when it begins, counted from `on`
    Errors   no such element  ELEMENT is NDOF or more: stays uninitialised
             no number        what is NaN or infinite leaves the number before
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")
    Z = OutVar("double[NDOF]", "rad", "what its readers get; always finite")

    ELEMENT = Local("int", "-", "which element drifts, from 0", default=0, low=0, high=63)
    RATE = Local("double", "rad/s", "how fast it drifts, and which way", default=0.05, low=-10.0, high=10.0)
    MOST = Local("double", "rad", "where the drift ends", default=1.0, low=0.0, high=100.0)
    AFTER = Local("double", "s", "when it begins, counted from `on`", default=1.0, low=0.0, high=3600.0)

    def init(self):
        if why := no_element("ELEMENT", self.ELEMENT, self.NDOF):
            raise ModuleError(why)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._sound.take(self.Z)
        self._onset = Onset(self.AFTER)
        self.Z = self._sound.take(self.Y)

    def cycle(self):
        self.Z = self._sound.take(self.Y)
        if self._onset.has_come(self.dt):
            drifted = max(self._onset.age, 0.0) * self.RATE
            self.Z[self.ELEMENT] += math.copysign(min(abs(drifted), self.MOST), drifted)
