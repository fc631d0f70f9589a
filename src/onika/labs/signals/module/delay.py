"""A measured vector that comes late."""

import numpy as np

from onika.laws.finite import FiniteValues
from onika.laws.onset import Onset
from onika.module import InConst, InVar, Local, Module, OutVar


class Delay(Module):
    """A fault to try: what is measured comes late, as over a slow bus.

    When it begins, nothing new comes for LATE; from then on everything comes, by whole cycles late.

    Kind     passive, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what is measured
             OUTVAR   Z     double[NDOF]  rad  what its readers get; always finite
    Local    LATE   double  s  how late it comes, to the nearest cycle
             AFTER  double  s  when it begins, counted from `on`
    Errors   no number  what is NaN or infinite leaves the number before
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")
    Z = OutVar("double[NDOF]", "rad", "what its readers get; always finite")

    LATE = Local("double", "s", "how late it comes, to the nearest cycle", default=0.1, low=0.0, high=5.0)
    AFTER = Local("double", "s", "when it begins, counted from `on`", default=1.0, low=0.0, high=3600.0)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._sound.take(self.Z)
        self._most = round(self.LATE / self.dt)
        self._past = np.zeros((self._most + 1, self.NDOF))
        self._onset = Onset(self.AFTER)
        self._steps, self._late = 0, 0
        self.Z = self._sound.take(self.Y)

    def cycle(self):
        self._past[self._steps % len(self._past)] = self._sound.take(self.Y)
        if self._onset.has_come(self.dt) and self._late < self._most and self._steps > 0:
            self._late += 1  # nothing comes until what comes is late enough
        self.Z = self._past[(self._steps - self._late) % len(self._past)]
        self._steps += 1
