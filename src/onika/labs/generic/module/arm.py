"""An arm behind its drive."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.arm_identity import driven_otherwise
from onika.laws.arm_reach import ArmReach
from onika.laws.robot import published, unlike
from onika.laws.robots import robot_of
from onika.module import InVar, Local, Module, ModuleError, OutConst, OutVar


class Arm(ArmReach, Module):
    """An arm: torques to its joints, where they are back, and everything that is known of it.

    Of a joint that slides the numbers are metres, its torque is a force in N, wherever units speak of angles.

    Kind     hardware, periodic, 100..1000 Hz
    Ports    OUTCONST NDOF     int              -          number of joints
             OUTCONST SCREW    double[NDOF,6]   -          axis and moment of each joint, at q = 0 in frame 0
             OUTCONST LINK     double[NDOF,13]  -          mass, centre, inertia, armature, friction of each link (SI)
             OUTCONST PARENT   int[NDOF]        -          the joint that bears each joint; -1: the base
             OUTCONST LOAD     double[4]        -          the hand: mass kg, centre m, at q = 0 in frame 0
             OUTCONST QMIN     double[NDOF]     rad        lower joint limits
             OUTCONST QMAX     double[NDOF]     rad        upper joint limits
             OUTCONST Q^_MAX   double[NDOF]     rad/s      highest joint speeds
             OUTCONST TAUMAX   double[NDOF]     N m        highest joint torques
             OUTCONST KP       double[NDOF]     N m/rad    stiffness of the joint servo
             OUTCONST KD       double[NDOF]     N m s/rad  damping of the joint servo
             OUTCONST BASE     double[4,4]      -          frame 0 in the world
             OUTCONST TOOL     double[4,4]      -          point between the fingers, at q = 0 in frame 0
             OUTCONST HOME     double[NDOF]     rad        where it begins, and goes back to
             OUTCONST ROBOT    string           -          kind of robot
             INVAR    TAU_REF  double[NDOF]     N m        wanted torque, clipped to TAUMAX
             OUTVAR   Q_MEZ    double[NDOF]     rad        measured position
    Local    ROBOT             string           -          whose constants: puma560 or adept_one
             BASE              double[4]        m, deg     x, y, z and turn about z of frame 0 in the world
             STEP              double           1/s        share of TAUMAX that a switch may change it by in a second
    Errors   another robot     the device is no such robot, or stands elsewhere than BASE says: stays uninitialised
             tripped           the drive has tripped: ERROR; clear brings the drive back to hold
             panic button      it is pressed: ERROR; clear is refused until it is let go
    Source   dissertation §4.3.2, §4.4.4, §6.2; each robot's own stand in `onika.laws`: `puma560`, `adept_one`
    """

    hardware = True

    NDOF = OutConst("int", "-", "number of joints")
    SCREW = OutConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    LINK = OutConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    PARENT = OutConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    LOAD = OutConst("double[4]", "-", "the hand: mass kg, centre m, at q = 0 in frame 0")
    QMIN = OutConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = OutConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = OutConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    TAUMAX = OutConst("double[NDOF]", "N m", "highest joint torques")
    KP = OutConst("double[NDOF]", "N m/rad", "stiffness of the joint servo")
    KD = OutConst("double[NDOF]", "N m s/rad", "damping of the joint servo")
    BASE_POSE = OutConst("double[4,4]", "-", "frame 0 in the world", name="BASE")
    TOOL = OutConst("double[4,4]", "-", "point between the fingers, at q = 0 in frame 0")
    HOME = OutConst("double[NDOF]", "rad", "where it begins, and goes back to")
    ROBOT_KIND = OutConst("string", "-", "kind of robot", name="ROBOT")
    TAU_REF = InVar("double[NDOF]", "N m", "wanted torque, clipped to TAUMAX", step=("dt", "STEP", "TAUMAX"))
    Q_MEZ = OutVar("double[NDOF]", "rad", "measured position")

    ROBOT = Local("string", "-", "whose constants: puma560 or adept_one")
    BASE = Local("double[4]", "m, deg", "x, y, z and turn about z of frame 0 in the world")
    STEP = Local("double", "1/s", "share of TAUMAX that a switch may change it by in a second", default=50.0, low=0.1)

    @classmethod
    def constants(cls, local, identity):
        """Everything that is known of the robot, by the names of its OUTCONSTs."""
        return published(robot_of(local.ROBOT), *local.BASE)

    @classmethod
    def fits(cls, constants, local_values):
        """Why the device that says this of itself is another robot, or stands elsewhere."""
        other = unlike(constants["ROBOT"], constants, local_values)
        return other or (driven_otherwise(local_values, "torque") if "DRIVE" in local_values else None)

    def init(self):
        if reason := self.fits(self.state_constants(), self.device.identity):
            raise ModuleError(reason)
        self._arm = ArmModel(self.SCREW, self.LINK, self.PARENT, self.LOAD, self.BASE_POSE)
        self._torque, self._highest, self._lowest = np.zeros(self.NDOF), self.TAUMAX.copy(), -self.TAUMAX
        self.held("TAU_REF")  # the model of the arm is built with its first use: here, not in a cycle

    def on(self, inputs):
        self.Q_MEZ = self.device.read()
        self.check_drive()

    def cycle(self):
        self.Q_MEZ = self.device.read()
        self.check_drive()
        torque = np.minimum(self.TAU_REF, self._highest, out=self._torque)
        self.device.write(np.maximum(torque, self._lowest, out=torque))

    def hold(self):
        self.Q_MEZ = self.device.read()
        self.check_drive()
        self.device.hold()

    def held(self, name):
        return self._arm.bias(self.Q_MEZ, np.zeros(self.NDOF), out=np.zeros(self.NDOF))

    def off(self):
        self.device.hold()

    def clear(self):
        self.clear_drive()
