"""Any arm that takes torques."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.arm_reach import DescribedArm
from onika.module import InVar, Local, Module, ModuleError, OutConst, OutVar


class ArmTau(DescribedArm, Module):
    """Any arm whose drives take torques: where its joints are, and what is known of it.

    All that it publishes its device says of itself.
    Of a joint that slides the numbers are metres, its torque is a force in N, wherever units speak of angles.

    Kind     hardware, periodic, 100..1000 Hz
    Ports    OUTCONST NDOF     int              -      number of joints
             OUTCONST SCREW    double[NDOF,6]   -      axis and moment of each joint, at q = 0 in frame 0
             OUTCONST LINK     double[NDOF,13]  -      mass, centre, inertia, armature, friction of each link (SI)
             OUTCONST PARENT   int[NDOF]        -      the joint that bears each joint; -1: the base
             OUTCONST LOAD     double[4]        -      a load besides: mass kg, centre m, at q = 0 in frame 0
             OUTCONST QMIN     double[NDOF]     rad    lower joint limits
             OUTCONST QMAX     double[NDOF]     rad    upper joint limits
             OUTCONST Q^_MAX   double[NDOF]     rad/s  highest joint speeds
             OUTCONST TAUMAX   double[NDOF]     N m    highest joint torques
             OUTCONST BASE     double[4,4]      -      frame 0 in the world
             OUTCONST TOOL     double[4,4]      -      the tool at q = 0 in frame 0
             OUTCONST HOME     double[NDOF]     rad    where it begins, and goes back to
             OUTCONST ROBOT    string           -      kind of robot
             INVAR    TAU_REF  double[NDOF]     N m    wanted torque, clipped to TAUMAX
             OUTVAR   Q_MEZ    double[NDOF]     rad    measured position
             OUTVAR   Q^_MEZ   double[NDOF]     rad/s  measured speed
             OUTVAR   TAU_MEZ  double[NDOF]     N m    torque of the drive
    Local    STEP              double           1/s    share of TAUMAX that a switch may change it by in a second
    Errors   another device    the device is no such arm, or takes other commands: stays uninitialised
             tripped           the drive has tripped: ERROR; clear brings the drive back to hold
             panic button      it is pressed: ERROR; clear is refused until it is let go
    Source   dissertation §4.3.2, §4.4.4; decisions 5 and 46
    """

    hardware = True
    driven_by = "torque"

    NDOF = OutConst("int", "-", "number of joints")
    SCREW = OutConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    LINK = OutConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    PARENT = OutConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    LOAD = OutConst("double[4]", "-", "a load besides: mass kg, centre m, at q = 0 in frame 0")
    QMIN = OutConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = OutConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = OutConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    TAUMAX = OutConst("double[NDOF]", "N m", "highest joint torques")
    BASE = OutConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = OutConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    HOME = OutConst("double[NDOF]", "rad", "where it begins, and goes back to")
    ROBOT = OutConst("string", "-", "kind of robot")
    TAU_REF = InVar("double[NDOF]", "N m", "wanted torque, clipped to TAUMAX", step=("dt", "STEP", "TAUMAX"))
    Q_MEZ = OutVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = OutVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_MEZ = OutVar("double[NDOF]", "N m", "torque of the drive")

    STEP = Local("double", "1/s", "share of TAUMAX that a switch may change it by in a second", default=50.0, low=0.1)

    def init(self):
        if reason := self.fits(None, self.device.identity):
            raise ModuleError(reason)
        self.state_constants()
        self._arm = ArmModel(self.SCREW, self.LINK, self.PARENT, self.LOAD, self.BASE)
        self._command = np.zeros(self.NDOF)
        self.held("TAU_REF")  # the model of the arm is built with its first use: here, not in a cycle

    def on(self, inputs):
        self._read()

    def cycle(self):
        self._read()
        self.device.write(np.clip(self.TAU_REF, -self.TAUMAX, self.TAUMAX, out=self._command))

    def hold(self):
        self._read()
        self.device.hold()

    def held(self, name):
        return self._arm.bias(self.Q_MEZ, np.zeros(self.NDOF))

    def off(self):
        self.device.hold()

    def clear(self):
        self.clear_drive()

    def _read(self):
        n = self.NDOF
        values = self.device.read()
        self.Q_MEZ, self.Qd_MEZ, self.TAU_MEZ = values[:n], values[n : 2 * n], values[2 * n :]
        self.check_drive()
