"""Derivative of a measured vector."""

from onika.laws.filter import Derivative
from onika.module import InConst, InVar, Local, Module, OutVar


class Diff(Module):
    """Derivative of measured joint angles, whatever they are called, with a first-order low-pass.

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  NDOF  int           -      number of elements
             INVAR    Y     double[NDOF]  rad    what is measured
             OUTVAR   Y^    double[NDOF]  rad/s  its derivative
    Local    CUTOFF         double        Hz     where the low-pass begins
    Source   dissertation §3.2.1; backward differences, see `onika.laws.filter`
    """

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")
    Yd = OutVar("double[NDOF]", "rad/s", "its derivative", name="Y^")

    CUTOFF = Local("double", "Hz", "where the low-pass begins", default=100.0, low=1e-3)

    def on(self, inputs):
        self._law = Derivative(self.NDOF, self.dt, self.CUTOFF)
        self._law.reset(self.Y)
        self.Yd = 0.0

    def cycle(self):
        self._law.update(self.Y, out=self.Yd)
