"""Any base that drives."""

import numpy as np

from onika.laws.arm_identity import driven_otherwise
from onika.laws.frames import as_array
from onika.module import InVar, Local, Module, ModuleError, OutConst, OutVar


class Base(Module):
    """Any base that drives, on wheels or on slides: how fast it is to go, how fast it goes, where it is.

    Speeds are those of its body: forward, to the left, and turning to the left. What it cannot do is left out.

    Kind     hardware, periodic, 40..1000 Hz
    Ports    OUTCONST V_MAX   double[3]  m/s,m/s,rad/s  highest speeds; 0 where it cannot go
             INVAR    V_BASE  double[3]  m/s,m/s,rad/s  wanted speeds; followed within V_MAX
             OUTVAR   W_MEZ   double[3]  m/s,m/s,rad/s  speeds as its wheels or slides tell them
             OUTVAR   P_TRUE  double[3]  m,m,rad        where it is in the world: x, y and turn
    Local    STEP             double[3]  m/s^2,m/s^2,rad/s^2  how fast a switch may change the speeds
    Errors   another device    the device is no such base: stays uninitialised
             tripped           the drive has tripped: ERROR; clear brings the drive back to hold
             panic button      it is pressed: ERROR; clear is refused until it is let go
    Source   dissertation §4.5.3; decision 5
    """

    hardware = True

    V_MAX = OutConst("double[3]", "m/s,m/s,rad/s", "highest speeds; 0 where it cannot go")
    V_BASE = InVar("double[3]", "m/s,m/s,rad/s", "wanted speeds; followed within V_MAX", step=("dt", "STEP"))
    W_MEZ = OutVar("double[3]", "m/s,m/s,rad/s", "speeds as its wheels or slides tell them")
    P_TRUE = OutVar("double[3]", "m,m,rad", "where it is in the world: x, y and turn")

    STEP = Local(
        "double[3]", "m/s^2,m/s^2,rad/s^2", "how fast a switch may change the speeds", default=(10.0, 10.0, 40.0)
    )

    @classmethod
    def constants(cls, local, identity):
        """Its highest speeds, as its device says them."""
        if "V_MAX" not in identity:
            raise ValueError(driven_otherwise(identity, "twist"))
        return {"V_MAX": as_array(identity["V_MAX"], (3,))}

    @classmethod
    def fits(cls, constants, local_values):
        """Why the device that says this of itself is no base."""
        return driven_otherwise(local_values, "twist")

    def init(self):
        if reason := self.fits(None, self.device.identity):
            raise ModuleError(reason)
        self.state_constants()

    def on(self, inputs):
        self._read()

    def cycle(self):
        self._read()
        self.device.write(np.clip(self.V_BASE, -self.V_MAX, self.V_MAX))

    def hold(self):
        self._read()
        self.device.hold()

    def held(self, name):
        return np.zeros(3)

    def off(self):
        self.device.hold()

    def clear(self):
        self.clear_drive()

    def _read(self):
        values = self.device.read()
        self.P_TRUE, self.W_MEZ = values[:3], values[3:]
        self.check_drive()
