"""Drives every axis along a cosine ramp; written at another site, in its own names."""

import math

from onika.module import InConst, Input, InVar, Module, OutVar, finish


class Ramp(Module):
    """Cosine ramp from where the axes are to the target.

    p(t) = p0 + (p1 - p0) (1 - cos(pi t / T)) / 2

    Kind     trigger, periodic, 50..1000 Hz
    Ports    INCONST  N_AX      int           -      number of axes
             INCONST  LOWEST    double[N_AX]  rad    lower limits
             INCONST  HIGHEST   double[N_AX]  rad    upper limits
             INVAR    POS_ACT   double[N_AX]  rad    where the axes are
             OUTVAR   POS_CMD   double[N_AX]  rad    where they shall be
             OUTVAR   VEL_CMD   double[N_AX]  rad/s  how fast
    Input    endpoint           double[N_AX]  rad    LOWEST..HIGHEST
             duration           double        s      0.1..60
    Finish   flow 0, loop FALSE, when t >= T + 0.5 s
    """

    trigger = True

    N_AX = InConst("int", "-", "number of axes")
    LOWEST = InConst("double[N_AX]", "rad", "lower limits")
    HIGHEST = InConst("double[N_AX]", "rad", "upper limits")
    POS_ACT = InVar("double[N_AX]", "rad", "where the axes are")
    POS_CMD = OutVar("double[N_AX]", "rad", "where they shall be")
    VEL_CMD = OutVar("double[N_AX]", "rad/s", "how fast")

    endpoint = Input("double[N_AX]", "rad", "where to go", low="LOWEST", high="HIGHEST")
    duration = Input("double", "s", "how long it takes", low=0.1, high=60.0)

    def on(self, inputs):
        self._from = (self.POS_CMD if self.continues("POS_CMD") else self.POS_ACT).copy()
        self._way = inputs.endpoint - self._from
        self._time, self._whole = 0.0, inputs.duration
        self.POS_CMD = self._from
        self.VEL_CMD = 0.0

    def cycle(self):
        self._time += self.dt
        angle = math.pi * min(self._time / self._whole, 1.0)
        self.POS_CMD = self._from + self._way * (1.0 - math.cos(angle)) / 2.0
        self.VEL_CMD = self._way * math.pi / self._whole * math.sin(angle) / 2.0
        return finish() if self._time >= self._whole + 0.5 else None
