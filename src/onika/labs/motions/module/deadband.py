"""From a pad to a speed."""

import numpy as np

from onika.module import InVar, Local, Module, OutVar


class Deadband(Module):
    """Makes the speed of a tool from the axes of a pad: nothing near their middle, then finely, at their end all.

    v = sign(x) ((1 - CURVE) u + CURVE u^3),  u = (|x| - ZONE) / (1 - ZONE) held within 0..1

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   V_RAW  double[6]  -          axes of the pad, -1..1: three of moving, three of turning
             OUTVAR  V_REF  double[6]  m/s,rad/s  wanted speed of the tool and of its turning
    Local    ZONE           double     -          how far from its middle an axis counts as let go
             CURVE          double     -          share of the third power: the more, the finer near the middle
             SPEED          double     m/s        speed at the end of an axis
             TURN           double     rad/s      speed of turning at the end of an axis
    Errors   no number  an axis that is NaN or infinite counts as let go
    """

    V_RAW = InVar("double[6]", "-", "axes of the pad, -1..1: three of moving, three of turning")
    V_REF = OutVar("double[6]", "m/s,rad/s", "wanted speed of the tool and of its turning")

    ZONE = Local("double", "-", "how far from its middle an axis counts as let go", default=0.1, low=0.0, high=0.9)
    CURVE = Local(
        "double", "-", "share of the third power: the more, the finer near the middle", default=0.5, low=0.0, high=1.0
    )
    SPEED = Local("double", "m/s", "speed at the end of an axis", default=0.1, low=0.0, high=2.0)
    TURN = Local("double", "rad/s", "speed of turning at the end of an axis", default=0.5, low=0.0, high=6.0)

    def init(self):
        self._scale = np.array([self.SPEED] * 3 + [self.TURN] * 3)

    def on(self, inputs):
        self.V_REF = 0.0

    def cycle(self):
        axes = np.where(np.isfinite(self.V_RAW), self.V_RAW, 0.0)
        push = np.clip((np.abs(axes) - self.ZONE) / (1.0 - self.ZONE), 0.0, 1.0)
        self.V_REF = self._scale * np.sign(axes) * ((1.0 - self.CURVE) * push + self.CURVE * push**3)
