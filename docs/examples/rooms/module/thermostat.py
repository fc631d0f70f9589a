"""The heating of a house."""

import numpy as np

from onika.module import InVar, Local, Module, OutVar


class Thermostat(Module):
    """Heats each room as far as it is colder than wished, with at most 60 W.

    Kind     general, periodic, 1..100 Hz
    Ports    INVAR   WARMTH  double[2]  degC  of each room
             INVAR   WISH    double[2]  degC  how warm each room shall be
             OUTVAR  POWER   double[2]  W     of the heater of each room
    Local    GAIN            double     W     power for each degree that is missing
    """

    WARMTH = InVar("double[2]", "degC", "of each room")
    WISH = InVar("double[2]", "degC", "how warm each room shall be")
    POWER = OutVar("double[2]", "W", "of the heater of each room")

    GAIN = Local("double", "W", "power for each degree that is missing", default=40.0, low=0.0)

    def cycle(self):
        missing = self.WISH - self.WARMTH
        self.POWER = np.clip(2.0 * (self.WISH - 10.0) + self.GAIN * missing, 0.0, 60.0)

    def off(self):
        self.POWER = 0.0
