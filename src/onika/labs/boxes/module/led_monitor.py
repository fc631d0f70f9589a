"""The lamp of the box assembly."""

from collections import deque

from onika.laws.device import no_lamp
from onika.module import Local, Module, OutVar

SURE = 0.8  # share of the looks that must see the circuit closed


class LedMonitor(Module):
    """Whether the lamp is lit: all contacts of the circuit closed, most of the time.

    Kind     general, periodic, 10..100 Hz
    Ports    OUTVAR   LAMP  int     -  1 while the lamp is lit, else 0
    Local    WINDOW         double  s  how far back is looked: single contacts flicker
    Source   dissertation §6.2.3
    """

    LAMP = OutVar("int", "-", "1 while the lamp is lit, else 0")

    WINDOW = Local("double", "s", "how far back is looked: single contacts flicker", default=0.2)

    @classmethod
    def fits(cls, constants, local_values):
        """Why the device that says this of itself has no lamp."""
        return no_lamp(local_values)

    def on(self, inputs):
        self._seen = deque([False] * max(1, round(self.WINDOW / self.dt)), maxlen=max(1, round(self.WINDOW / self.dt)))
        self.LAMP = 0

    def cycle(self):
        self._seen.append(bool(self.device.read().all()))
        self.LAMP = sum(self._seen) > SURE * len(self._seen)
