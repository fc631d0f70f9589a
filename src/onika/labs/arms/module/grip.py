"""Any gripper, in metres and newtons."""

import math

from onika.module import InVar, Module, ModuleError, OutVar


class Grip(Module):
    """Any gripper whose device takes an opening and a force: how far it is open, how fast, how hard it presses.

    Kind     hardware, periodic, 40..1000 Hz
    Ports    INVAR    OPEN_REF   double     m        wanted opening
             INVAR    FORCE_REF  double     N        highest force on a finger
             OUTVAR   GRIP_MEZ   double[3]  m,m/s,N  opening, its speed, force on a finger
    Errors   another device      the device takes other commands: stays uninitialised
             tripped             the drive has tripped: ERROR; clear brings the drive back to hold
    Source   dissertation §6.2
    """

    hardware = True

    OPEN_REF = InVar("double", "m", "wanted opening", step=math.inf)
    FORCE_REF = InVar("double", "N", "highest force on a finger", step=math.inf)
    GRIP_MEZ = OutVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")

    def init(self):
        published, taken = len(self.device.sheet.state) - 2, len(self.device.sheet.command)
        if (published, taken) != (3, 2):
            raise ModuleError(
                "expected a gripper that publishes 3 numbers and takes 2, "
                "found a device that publishes {published} and takes {taken}",
                published=published,
                taken=taken,
            )

    def on(self, inputs):
        self._read()

    def cycle(self):
        self._read()
        self.device.write((self.OPEN_REF, self.FORCE_REF))

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
