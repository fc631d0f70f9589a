"""Figures of a signal."""

import numpy as np

from onika.laws.finite import FiniteValues
from onika.laws.sentence import no_element
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class SignalFigures(Module):
    """What one joint position did in the last SPAN seconds: least, greatest, mean, root of the mean square, 99 %.

    99 % of its values were not above the last figure. Before SPAN has passed, the figures are of what there was.

    Kind     passive, periodic, 1..250 Hz
    Ports    INCONST  NDOF     int           -    number of elements
             INVAR    Y        double[NDOF]  rad  what is looked at
             OUTVAR   FIGURES  double[5]     rad  least, greatest, mean, root of the mean square, 99 %
    Local    ELEMENT           int           -    which element is looked at, from 0
             SPAN              double        s    how far back is looked
    Errors   no such element  ELEMENT is NDOF or more: stays uninitialised
             no number        what is NaN or infinite leaves the number before
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is looked at")
    FIGURES = OutVar("double[5]", "rad", "least, greatest, mean, root of the mean square, 99 %")

    ELEMENT = Local("int", "-", "which element is looked at, from 0", default=0, low=0, high=63)
    SPAN = Local("double", "s", "how far back is looked", default=5.0, low=0.01, high=60.0)

    def init(self):
        if why := no_element("ELEMENT", self.ELEMENT, self.NDOF):
            raise ModuleError(why)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._values, self._count = np.zeros(max(round(self.SPAN / self.dt), 1)), 0
        self.FIGURES = abs(self._sound.take(self.Y)[self.ELEMENT])
        self.FIGURES[:3] = self.FIGURES[4] = self._sound.values[self.ELEMENT]

    def cycle(self):
        self._values[self._count % len(self._values)] = self._sound.take(self.Y)[self.ELEMENT]
        self._count += 1
        seen = self._values[: self._count]
        root = float(np.sqrt(np.mean(seen * seen)))
        self.FIGURES = (seen.min(), seen.max(), seen.mean(), root, np.percentile(seen, 99.0))
