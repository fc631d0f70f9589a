"""The two-finger hand behind its valves."""

import math

from onika.laws.device import no_hand
from onika.module import InVar, Module, OutVar


class Gripper(Module):
    """The two-finger hand, driven by compressed air: open, close, and what the fingers do.

    Kind     hardware, periodic, 40..1000 Hz
    Ports    INVAR    GRIP      double     -        +1 opens, -1 closes, 0 changes nothing
             OUTVAR   GRIP_MEZ  double[3]  m,m/s,N  opening, its speed, force on a finger
    Errors   tripped           the drive has tripped: ERROR; clear brings the drive back to hold
    Source   dissertation §6.2
    """

    hardware = True

    GRIP = InVar("double", "-", "+1 opens, -1 closes, 0 changes nothing", step=math.inf)
    GRIP_MEZ = OutVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")

    @classmethod
    def fits(cls, constants, local_values):
        """Why the device that says this of itself is no hand."""
        return no_hand(local_values)

    def on(self, inputs):
        self._read()

    def cycle(self):
        self._read()
        self.device.write((self.GRIP,))

    def hold(self):
        self._read()
        self.device.hold()

    def off(self):
        self.device.hold()

    def clear(self):
        self.clear_drive()

    def _read(self):
        self.GRIP_MEZ = self.device.read()
        self.check_drive()
