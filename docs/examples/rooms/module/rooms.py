"""A model house, as Onika's own runtime carries it out; runtime.mjs has the same in house.mjs."""

import numpy as np

from onika.module import InVar, Module, OutVar


class Rooms(Module):
    """Two rooms, warmed by their heaters and cooled by the weather.

    Kind     general, periodic, 1..100 Hz
    Ports    INVAR   POWER   double[2]  W     of the heater of each room
             OUTVAR  WARMTH  double[2]  degC  of each room
    """

    POWER = InVar("double[2]", "W", "of the heater of each room")
    WARMTH = OutVar("double[2]", "degC", "of each room")

    def init(self):
        self._warmth = np.full(2, 10.0)

    def on(self, inputs):
        self.WARMTH = self._warmth

    def cycle(self):
        here = self._warmth
        heat = self.POWER + 1.0 * (here[::-1] - here) - 2.0 * (here - 10.0)
        self._warmth = here + heat * self.dt / 10.0
        self.WARMTH = self._warmth
