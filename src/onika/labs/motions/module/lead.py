"""The tool, led by hand."""

import numpy as np

from onika.laws.frames import rotation_exp
from onika.laws.signals.limited_rate import LimitedRate
from onika.module import InVar, Local, Module, OutVar


class Lead(Module):
    """Moves the tool at a wanted speed, and brings it to rest when a button is pressed.

    Speed rises and falls no faster than RISE and TURNRISE. The reference stays within the box LOW..HIGH of the world
    and within LEASH of the tool: an arm that does not follow is waited for. A speed that is no number is 0.

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   V_REF    double[6]    m/s,rad/s  wanted speed, along the axes of the world
             INVAR   BUTTONS  int          -          not 0: it comes to rest
             INVAR   X_MEZ    double[4,4]  -          measured pose; the start where no reference is in force
             OUTVAR  X_REF    double[4,4]  -          reference pose; preloaded at `on`, it is the start
    Local    RISE             double       m/s^2      how fast the speed may change
             TURNRISE         double       rad/s^2    how fast the speed of turning may change
             LEASH            double       m          how far the reference may be from the tool
             LOW              double[3]    m          lower corner of the box, in the world
             HIGH             double[3]    m          upper corner of the box, in the world
    Get/Set  speed, in m/s, of the reference / -
    Source   dissertation §6.2.2.3
    """

    V_REF = InVar("double[6]", "m/s,rad/s", "wanted speed, along the axes of the world")
    BUTTONS = InVar("int", "-", "not 0: it comes to rest")
    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    RISE = Local("double", "m/s^2", "how fast the speed may change", default=0.5, low=1e-3)
    TURNRISE = Local("double", "rad/s^2", "how fast the speed of turning may change", default=2.0, low=1e-3)
    LEASH = Local("double", "m", "how far the reference may be from the tool", default=0.05, low=1e-3)
    LOW = Local("double[3]", "m", "lower corner of the box, in the world", default=(-2.0, -2.0, -2.0))
    HIGH = Local("double[3]", "m", "upper corner of the box, in the world", default=(2.0, 2.0, 2.0))

    def on(self, inputs):
        self.X_REF = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()
        self._limited = LimitedRate(np.zeros(6), [self.RISE] * 3 + [self.TURNRISE] * 3)

    def cycle(self):
        wanted = np.where(np.isfinite(self.V_REF), self.V_REF, 0.0) if not self.BUTTONS else np.zeros(6)
        self._limited.follow(wanted, self.dt)
        speed = self._limited.value
        here = self.X_REF[:3, 3].copy()
        there = np.clip(here + self.dt * speed[:3], np.minimum(self.LOW, here), np.maximum(self.HIGH, here))
        if self._away(there) <= max(self.LEASH, self._away(here)):
            self.X_REF[:3, 3] = there
        self.X_REF[:3, :3] = rotation_exp(self.dt * speed[3:]) @ self.X_REF[:3, :3]

    def get(self, name):
        return float(np.linalg.norm(self._limited.value[:3])) if name == "speed" else super().get(name)

    def _away(self, place):
        return float(np.linalg.norm(place - self.X_MEZ[:3, 3]))
