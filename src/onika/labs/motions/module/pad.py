"""A pad in somebody's hand."""

import numpy as np

from onika.laws.signals.dead_man import DeadMan
from onika.laws.signals.push import strength
from onika.module import InConst, InVar, Local, Module, OutVar

COUNT, HELD, SCALE, FRAME, BUTTON, MOVING, TURNING = 0, 1, 2, 3, 4, 5, 8


class Pad(Module):
    """Makes the speed of a tool from what a person pushes: a pad, a joystick, keys, or the tool in the view.

    Pushes come over a line, with a count. They mean a speed while the dead-man is held and for MOST after the last of
    them; after a second without any the dead-man has to be let go first. The person says along whose axes the speed is
    meant, and what share of SPEED and TURN it has.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  BASE     double[4,4]  -          frame 0 in the world
             INVAR    PAD      double[11]   -          count, held, scale, frame (0 world, 1 tool, 2 base), button, axes
             INVAR    X_MEZ    double[4,4]  -          measured pose of the tool
             OUTVAR   V_REF    double[6]    m/s,rad/s  wanted speed of the tool and of its turning, in the world
             OUTVAR   BUTTONS  int          -          1 while the button is pressed
    Local    ZONE              double       -          how far from its middle a push counts as let go
             CURVE             double       -          share of the third power: the more, the finer near the middle
             SPEED             double       m/s        the highest speed
             TURN              double       rad/s      the highest speed of turning
             MOST              double       s          how old the last push may be
    Errors   no number         an axis that is NaN or infinite counts as let go
    Get/Set  held, whether the dead-man counts / -
    Source   dissertation §4.5.2, §6.2.2.3
    """

    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    PAD = InVar("double[11]", "-", "count, held, scale, frame (0 world, 1 tool, 2 base), button, axes")
    X_MEZ = InVar("double[4,4]", "-", "measured pose of the tool")
    V_REF = OutVar("double[6]", "m/s,rad/s", "wanted speed of the tool and of its turning, in the world")
    BUTTONS = OutVar("int", "-", "1 while the button is pressed")

    ZONE = Local("double", "-", "how far from its middle a push counts as let go", default=0.1, low=0.0, high=0.9)
    CURVE = Local(
        "double", "-", "share of the third power: the more, the finer near the middle", default=0.5, low=0.0, high=1.0
    )
    SPEED = Local("double", "m/s", "the highest speed", default=0.1, low=0.0, high=2.0)
    TURN = Local("double", "rad/s", "the highest speed of turning", default=0.5, low=0.0, high=6.0)
    MOST = Local("double", "s", "how old the last push may be", default=0.1, low=0.02, high=0.2)

    def on(self, inputs):
        self._dead_man = DeadMan(self.MOST, self.PAD[COUNT])
        self._is_held = False
        self.V_REF = 0.0
        self.BUTTONS = 0

    def cycle(self):
        pad = self.PAD
        self._is_held = self._dead_man.is_held(pad[COUNT], pad[HELD] == 1.0, self.dt)
        self.BUTTONS = int(self._dead_man.is_fresh and pad[BUTTON] == 1.0)
        share = np.clip(pad[SCALE], 0.0, 1.0) if self._is_held and np.isfinite(pad[SCALE]) else 0.0
        turned = {1.0: self.X_MEZ, 2.0: self.BASE}.get(float(pad[FRAME]), np.eye(4))[:3, :3]
        self.V_REF[:3] = share * self.SPEED * (turned @ strength(pad[MOVING:TURNING], self.ZONE, self.CURVE))
        self.V_REF[3:] = share * self.TURN * (turned @ strength(pad[TURNING:], self.ZONE, self.CURVE))

    def get(self, name):
        return int(self._is_held) if name == "held" else super().get(name)
