"""Six legs of a platform."""

import numpy as np

from onika.laws import reach
from onika.laws.arm_identity import axes_constants, driven_otherwise
from onika.module import InVar, Local, Module, ModuleError, OutConst, OutVar

LEGS = 6


class Legs(Module):
    """Six legs of a platform, whose drives take lengths and speeds.

    All that it publishes its device says of itself; between two commands the drives run on at the speed.
    Numbers are metres, forces N, wherever units speak of angles; six of them, so that no arm is taken for legs.

    Kind     hardware, periodic, 100..1000 Hz
    Ports    OUTCONST NDOF     int           -      number of joints
             OUTCONST QMIN     double[6]     rad    lower joint limits
             OUTCONST QMAX     double[6]     rad    upper joint limits
             OUTCONST Q^_MAX   double[6]  rad/s  highest joint speeds
             OUTCONST HOME     double[6]     rad    where it begins, and goes back to
             OUTCONST ROBOT    string        -      kind of robot
             INVAR    Q_REF    double[6]     rad    reference position; followed within QMIN..QMAX
             INVAR    Q^_REF   double[6]  rad/s  reference speed; followed within Q^_MAX
             OUTVAR   Q_MEZ    double[6]     rad    measured position
             OUTVAR   Q^_MEZ   double[6]  rad/s  measured speed
             OUTVAR   TAU_MEZ  double[6]  N m    torque of the drive
    Local    STEP              double        1/s    share of Q^_MAX that a switch may change the speed by in a second
    Errors   another device    the device is no such thing, or takes other commands: stays uninitialised
             tripped           the drive has tripped: ERROR; clear brings the drive back to hold
             panic button      it is pressed: ERROR; clear is refused until it is let go
    Source   dissertation §4.3.2, §4.5.3; decisions 5 and 46
    """

    hardware = True

    NDOF = OutConst("int", "-", "number of joints")
    QMIN = OutConst("double[6]", "rad", "lower joint limits")
    QMAX = OutConst("double[6]", "rad", "upper joint limits")
    Qd_MAX = OutConst("double[6]", "rad/s", "highest joint speeds", name="Q^_MAX")
    HOME = OutConst("double[6]", "rad", "where it begins, and goes back to")
    ROBOT = OutConst("string", "-", "kind of robot")
    Q_REF = InVar("double[6]", "rad", "reference position; followed within QMIN..QMAX", step=(4.0, "dt", "Q^_MAX"))
    Qd_REF = InVar(
        "double[6]", "rad/s", "reference speed; followed within Q^_MAX", name="Q^_REF", step=("dt", "STEP", "Q^_MAX")
    )
    Q_MEZ = OutVar("double[6]", "rad", "measured position")
    Qd_MEZ = OutVar("double[6]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_MEZ = OutVar("double[6]", "N m", "torque of the drive")

    STEP = Local(
        "double", "1/s", "share of Q^_MAX that a switch may change the speed by in a second", default=50.0, low=0.1
    )

    @classmethod
    def constants(cls, local, identity):
        """Everything that is known of the axes, by the names of the OUTCONSTs, as its device says it."""
        return axes_constants(identity)

    @classmethod
    def resolve(cls, constants, targets):
        """Why a joint target lies beyond a limit; None for what can be reached."""
        return reach.beyond_limits(constants, targets)

    @classmethod
    def fits(cls, constants, local_values):
        """Why the device that says this of itself takes other commands."""
        return driven_otherwise(local_values, "position")

    def init(self):
        if reason := self.fits(None, self.device.identity):
            raise ModuleError(reason)
        if len(self.device.sheet.command) != 2 * LEGS:
            raise ModuleError(
                "expected {legs} legs, found {found}", legs=LEGS, found=len(self.device.sheet.command) // 2
            )
        self.state_constants()
        self._command = np.zeros(2 * self.NDOF)

    def on(self, inputs):
        self._read()

    def cycle(self):
        self._read()
        n, command = self.NDOF, self._command
        np.clip(self.Q_REF, self.QMIN, self.QMAX, out=command[:n])
        np.clip(self.Qd_REF, -self.Qd_MAX, self.Qd_MAX, out=command[n:])
        self.device.write(command)

    def hold(self):
        self._read()
        self.device.hold()

    def held(self, name):
        return self.Q_MEZ if name == "Q_REF" else np.zeros(self.NDOF)

    def off(self):
        self.device.hold()

    def clear(self):
        self.clear_drive()

    def _read(self):
        n = self.NDOF
        values = self.device.read()
        self.Q_MEZ, self.Qd_MEZ, self.TAU_MEZ = values[:n], values[n : 2 * n], values[2 * n :]
        self.check_drive()
