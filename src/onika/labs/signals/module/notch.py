"""A notch filter."""

from onika.laws.finite import FiniteValues
from onika.laws.sentence import sentence_of
from onika.laws.signals.second_order import SecondOrder
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class Notch(Module):
    """Takes one frequency out of joint torques, as that at which an arm swings; the others pass.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF     int           -    number of elements
             INVAR    TAU_IN   double[NDOF]  N m  what comes in
             OUTVAR   TAU_OUT  double[NDOF]  N m  what passes; always finite
    Local    MIDDLE            double        Hz   what is taken out
             WIDTH             double        Hz   how wide it is: 3 dB less at half of it on either side
    Errors   no notch   MIDDLE is half of the rate or more: stays OFF
             no number  what is NaN or infinite leaves the number before
    Source   Oppenheim & Schafer, Discrete-Time Signal Processing, §7.1
    """

    NDOF = InConst("int", "-", "number of elements")
    TAU_IN = InVar("double[NDOF]", "N m", "what comes in")
    TAU_OUT = OutVar("double[NDOF]", "N m", "what passes; always finite")

    MIDDLE = Local("double", "Hz", "what is taken out", default=25.0, low=0.01, high=500.0)
    WIDTH = Local("double", "Hz", "how wide it is: 3 dB less at half of it on either side", default=5.0, low=0.01)

    def on(self, inputs):
        try:
            self._filter = SecondOrder.notch(self.NDOF, self.dt, self.MIDDLE, self.WIDTH)
        except ValueError as wrong:
            raise ModuleError(sentence_of(wrong)) from None
        self._sound = FiniteValues(self.NDOF)
        self._filter.reset(self._sound.take(self.TAU_IN))
        self.TAU_OUT = self._sound.values

    def cycle(self):
        self.TAU_OUT = self._filter.update(self._sound.take(self.TAU_IN))
