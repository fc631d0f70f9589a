"""The speed of a tool, kept within limits."""

import numpy as np

from onika.laws.signals.limited_rate import LimitedRate
from onika.module import InVar, Local, Module, OutVar


class TwistLimit(Module):
    """Passes on a wanted speed of the tool, but changes it no faster than RISE and TURNRISE, and stops at a box.

    Towards a wall of the box LOW..HIGH the tool is so slow that it comes to rest there: v^2 <= 2 RISE distance. What
    has left the box may come back. A speed that is no number is 0.

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   V_WISH   double[6]    m/s,rad/s  wanted speed, along the axes of the world
             INVAR   BUTTONS  int          -          not 0: it comes to rest
             INVAR   X_MEZ    double[4,4]  -          measured pose of the tool
             OUTVAR  V_REF    double[6]    m/s,rad/s  the speed that it may have
    Local    RISE             double       m/s^2      how fast the speed may change
             TURNRISE         double       rad/s^2    how fast the speed of turning may change
             LOW              double[3]    m          lower corner of the box, in the world
             HIGH             double[3]    m          upper corner of the box, in the world
    Get/Set  speed, in m/s, that it has / -
    Source   dissertation §6.2.2.3
    """

    V_WISH = InVar("double[6]", "m/s,rad/s", "wanted speed, along the axes of the world")
    BUTTONS = InVar("int", "-", "not 0: it comes to rest")
    X_MEZ = InVar("double[4,4]", "-", "measured pose of the tool")
    V_REF = OutVar("double[6]", "m/s,rad/s", "the speed that it may have")

    RISE = Local("double", "m/s^2", "how fast the speed may change", default=1.0, low=1e-3)
    TURNRISE = Local("double", "rad/s^2", "how fast the speed of turning may change", default=5.0, low=1e-3)
    LOW = Local("double[3]", "m", "lower corner of the box, in the world", default=(-2.0, -2.0, -2.0))
    HIGH = Local("double[3]", "m", "upper corner of the box, in the world", default=(2.0, 2.0, 2.0))

    def on(self, inputs):
        self._limited = LimitedRate(np.zeros(6), [self.RISE] * 3 + [self.TURNRISE] * 3)
        self.V_REF = 0.0

    def cycle(self):
        wanted = np.where(np.isfinite(self.V_WISH), self.V_WISH, 0.0) if not self.BUTTONS else np.zeros(6)
        self._limited.follow(wanted, self.dt)
        speed = self._limited.value
        here = self.X_MEZ[:3, 3]
        down, up = (np.sqrt(2.0 * self.RISE * np.maximum(gap, 0.0)) for gap in (here - self.LOW, self.HIGH - here))
        speed[:3] = np.clip(speed[:3], -down, up)
        self.V_REF = speed

    def get(self, name):
        return float(np.linalg.norm(self._limited.value[:3])) if name == "speed" else super().get(name)
