"""One number that a sensor measures."""

from onika.module import Local, Module, ModuleError, OutVar


class Gauge(Module):
    """One of the numbers of a device that measures: a distance, a force, an opening, a switch; in the device's unit.

    Kind     general, periodic, 10..1000 Hz
    Ports    OUTVAR  SENSE  double  -  what is measured
    Local    NUMBER         int     -  which of the device's numbers it is, from 1 on
             FAR            double  -  said in place of what is below 0, where a range finder sees nothing; 0: as it is
    Errors   no such number  the device publishes fewer numbers: stays uninitialised
    """

    SENSE = OutVar("double", "-", "what is measured")

    NUMBER = Local("int", "-", "which of the device's numbers it is, from 1 on", default=1, low=1)
    FAR = Local(
        "double", "-", "said in place of what is below 0, where a range finder sees nothing; 0: as it is", default=0.0
    )

    def init(self):
        published = len(self.device.sheet.state) - 2
        if published < self.NUMBER:
            raise ModuleError(
                "expected a device that publishes {number} numbers or more, found one that publishes {published}",
                number=self.NUMBER,
                published=published,
            )

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        measured = float(self.device.read()[self.NUMBER - 1])
        self.SENSE = self.FAR if self.FAR and measured < 0.0 else measured
