"""A low-pass of second order."""

from onika.laws.finite import FiniteValues
from onika.laws.sentence import sentence_of
from onika.laws.signals.second_order import SecondOrder
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class Lowpass(Module):
    """Takes out of joint positions, whatever they are called, what is quicker than its cutoff.

    A Butterworth low-pass of second order: 3 dB less at CUTOFF, 12 dB less for each octave above. What is slower comes
    late by about 0.225 / CUTOFF.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what comes in
             OUTVAR   Z     double[NDOF]  rad  what passes; always finite
    Local    CUTOFF         double        Hz   where the low-pass begins
    Errors   no low-pass  CUTOFF is half of the rate or more: stays OFF
             no number    what is NaN or infinite leaves the number before
    Source   Oppenheim & Schafer, Discrete-Time Signal Processing, §7.1
    """

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what comes in")
    Z = OutVar("double[NDOF]", "rad", "what passes; always finite")

    CUTOFF = Local("double", "Hz", "where the low-pass begins", default=20.0, low=0.01, high=500.0)

    def on(self, inputs):
        try:
            self._filter = SecondOrder.lowpass(self.NDOF, self.dt, self.CUTOFF)
        except ValueError as wrong:
            raise ModuleError(sentence_of(wrong)) from None
        self._sound = FiniteValues(self.NDOF)
        self._filter.reset(self._sound.take(self.Y))
        self.Z = self._sound.values

    def cycle(self):
        self.Z = self._filter.update(self._sound.take(self.Y))
