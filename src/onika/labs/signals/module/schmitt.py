"""A level with two edges."""

from onika.module import InVar, Local, Module, ModuleError, OutVar


class Schmitt(Module):
    """Whether a number is high: from HIGH on it is, until it comes down to LOW.

    What shakes between the two changes nothing.

    Kind     general, periodic, 1..1000 Hz
    Ports    INVAR   SIGNAL  double  -  what is looked at
             OUTVAR  EVENT   int     -  1 while it is high, else 0
    Local    LOW             double  -  where it is low again
             HIGH            double  -  where it is high
    Errors   no levels  LOW is not below HIGH: stays uninitialised
    Source   Schmitt, A Thermionic Trigger, Journal of Scientific Instruments 15, 1938
    """

    SIGNAL = InVar("double", "-", "what is looked at")
    EVENT = OutVar("int", "-", "1 while it is high, else 0")

    LOW = Local("double", "-", "where it is low again", default=-0.1)
    HIGH = Local("double", "-", "where it is high", default=0.1)

    def init(self):
        if not self.LOW < self.HIGH:
            raise ModuleError("expected LOW below HIGH, found {low:g} and {high:g}", low=self.LOW, high=self.HIGH)

    def on(self, inputs):
        self.EVENT = int(self.SIGNAL >= self.HIGH)

    def cycle(self):
        if self.SIGNAL >= self.HIGH:
            self.EVENT = 1
        elif self.SIGNAL <= self.LOW:
            self.EVENT = 0
