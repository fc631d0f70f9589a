"""The frame of a speed."""

import numpy as np

from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar

FRAMES = ("tool", "base", "world")


class TwistFrame(Module):
    """Turns a wanted speed, meant along the axes of the tool or of the arm's base, into one along those of the world.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  BASE   double[4,4]  -          frame 0 in the world
             INVAR    V_REF  double[6]    m/s,rad/s  wanted speed, along the axes of FRAME
             INVAR    X_MEZ  double[4,4]  -          measured pose of the tool
             OUTVAR   V_OUT  double[6]    m/s,rad/s  the same speed, along the axes of the world
    Local    FRAME           string       -          tool, base or world: along whose axes the speed is meant
    Errors   no frame  FRAME is none of tool, base and world: stays uninitialised
    """

    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    V_REF = InVar("double[6]", "m/s,rad/s", "wanted speed, along the axes of FRAME")
    X_MEZ = InVar("double[4,4]", "-", "measured pose of the tool")
    V_OUT = OutVar("double[6]", "m/s,rad/s", "the same speed, along the axes of the world")

    FRAME = Local("string", "-", "tool, base or world: along whose axes the speed is meant", default="tool")

    def init(self):
        if self.FRAME not in FRAMES:
            raise ModuleError("FRAME: expected tool, base or world, found {found}", found=self.FRAME)

    def on(self, inputs):
        self.V_OUT = 0.0

    def cycle(self):
        turned = {"tool": self.X_MEZ, "base": self.BASE, "world": np.eye(4)}[self.FRAME][:3, :3]
        self.V_OUT[:3] = turned @ self.V_REF[:3]
        self.V_OUT[3:] = turned @ self.V_REF[3:]
