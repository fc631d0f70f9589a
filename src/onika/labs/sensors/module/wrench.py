"""Force and torque at a sensor."""

from onika.module import Local, Module, ModuleError, OutVar

WRENCH = 6  # three forces and three torques


class Wrench(Module):
    """Force and torque that act on a sensor, in its frame: the weight of what hangs there, and what presses on it.

    Force and torque sensors of a model (MuJoCo's) say what holds against it: SIGN -1.

    Kind     general, periodic, 10..1000 Hz
    Ports    OUTVAR  F_RAW  double[6]  N,N m  force and torque, with the weight of what hangs there
    Local    SIGN           int        -      1: the device says what acts on it; -1: what it holds against that
    Errors   another device  the device does not publish six numbers: stays uninitialised
    """

    F_RAW = OutVar("double[6]", "N,N m", "force and torque, with the weight of what hangs there")

    SIGN = Local(
        "int",
        "-",
        "1: the device says what acts on it; -1: what it holds against that",
        default=1,
        low=-1,
        high=1,
    )

    def init(self):
        if not self.SIGN:
            raise ModuleError("SIGN: expected 1 or -1, found 0")
        published = len(self.device.sheet.state) - 2
        if published != WRENCH:
            raise ModuleError(
                "expected a device that publishes the {expected} numbers of a wrench, "
                "found one that publishes {published}",
                expected=WRENCH,
                published=published,
            )

    def on(self, inputs):
        self.F_RAW = self.SIGN * self.device.read()

    def cycle(self):
        self.F_RAW = self.SIGN * self.device.read()
