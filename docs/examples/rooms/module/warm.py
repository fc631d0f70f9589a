"""The wish for warmth."""

import numpy as np

from onika.module import Input, InVar, Module, OutVar, finish


class Warm(Module):
    """Wishes one warmth of both rooms.

    Kind     trigger, periodic, 1..100 Hz
    Ports    INVAR   WARMTH  double[2]  degC  of each room
             OUTVAR  WISH    double[2]  degC  how warm each room shall be
    Input    level           double     degC  5..30
    Finish   flow 0, loop FALSE, when both rooms have it to half a degree
    """

    trigger = True

    WARMTH = InVar("double[2]", "degC", "of each room")
    WISH = OutVar("double[2]", "degC", "how warm each room shall be")

    level = Input("double", "degC", "how warm both rooms shall be", low=5.0, high=30.0)

    def on(self, inputs):
        self._level = inputs.level
        self.WISH = self._level

    def cycle(self):
        self.WISH = self._level
        return finish() if np.all(np.abs(self.WARMTH - self._level) < 0.5) else None
