"""The PUMA 560 behind its drive."""

import math
from types import SimpleNamespace

import numpy as np

from onika.laws import puma560
from onika.laws.frames import pose_of_nine, rotation_of_rpy
from onika.laws.inverse import inverse_for
from onika.module import InVar, Local, Module, ModuleError, OutConst, OutVar


class Puma(Module):
    """The PUMA 560: torques to its six joints, their angles back, and everything that is known of it.

    Kind     hardware, periodic, 100..1000 Hz
    Ports    OUTCONST NDOF     int             -          number of joints
             OUTCONST DH       double[NDOF,4]  -          a m, alpha rad, d m, theta offset rad
             OUTCONST DYN      double[NDOF,9]  -          mass, centre, inertia, armature, friction of each link (SI)
             OUTCONST LOAD     double[4]       -          the hand: mass kg, centre m in the last frame
             OUTCONST QMIN     double[NDOF]    rad        lower joint limits
             OUTCONST QMAX     double[NDOF]    rad        upper joint limits
             OUTCONST Q^_MAX   double[NDOF]    rad/s      highest joint speeds
             OUTCONST TAUMAX   double[NDOF]    N m        highest joint torques
             OUTCONST KP       double[NDOF]    N m/rad    stiffness of the joint servo
             OUTCONST KD       double[NDOF]    N m s/rad  damping of the joint servo
             OUTCONST BASE     double[4,4]     -          frame 0 in the world
             OUTCONST TOOL     double[4,4]     -          point between the fingers in the last frame
             OUTCONST ROBOT    string          -          kind of robot
             INVAR    TAU_REF  double[NDOF]    N m        wanted torque, clipped to TAUMAX
             OUTVAR   Q_MEZ    double[NDOF]    rad        measured position
    Local    BASE              double[4]       m, deg     x, y, z and turn about z of frame 0 in the world
    Errors   another robot     the device is no such robot, or stands elsewhere than BASE says: stays uninitialised
             tripped           the drive has tripped: ERROR; clear brings the drive back to hold
             panic button      it is pressed: ERROR; clear is refused until it is let go
    Source   dissertation §4.3.2, §6.2; Fu, Gonzalez & Lee 1987; Armstrong, Khatib & Burdick 1986
    """

    hardware = True

    NDOF = OutConst("int", "-", "number of joints")
    DH = OutConst("double[NDOF,4]", "-", "a m, alpha rad, d m, theta offset rad")
    DYN = OutConst("double[NDOF,9]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    LOAD = OutConst("double[4]", "-", "the hand: mass kg, centre m in the last frame")
    QMIN = OutConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = OutConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = OutConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    TAUMAX = OutConst("double[NDOF]", "N m", "highest joint torques")
    KP = OutConst("double[NDOF]", "N m/rad", "stiffness of the joint servo")
    KD = OutConst("double[NDOF]", "N m s/rad", "damping of the joint servo")
    BASE_POSE = OutConst("double[4,4]", "-", "frame 0 in the world", name="BASE")
    TOOL = OutConst("double[4,4]", "-", "point between the fingers in the last frame")
    ROBOT = OutConst("string", "-", "kind of robot")
    TAU_REF = InVar("double[NDOF]", "N m", "wanted torque, clipped to TAUMAX")
    Q_MEZ = OutVar("double[NDOF]", "rad", "measured position")

    BASE = Local("double[4]", "m, deg", "x, y, z and turn about z of frame 0 in the world")

    @classmethod
    def constants(cls, local):
        """Everything that is known of the robot, by the names of its OUTCONSTs."""
        x, y, z, degrees = local.BASE
        base = np.eye(4)
        base[:3, :3] = rotation_of_rpy(0.0, 0.0, math.radians(degrees))
        base[:3, 3] = x, y, z
        names = ("NDOF", "DH", "DYN", "LOAD", "QMIN", "QMAX", "TAUMAX", "KP", "KD", "TOOL", "ROBOT")
        return {"BASE": base, "Q^_MAX": puma560.QDMAX} | {name: getattr(puma560, name) for name in names}

    @classmethod
    def resolve(cls, constants, targets):
        """Why a joint target lies beyond a limit or a pose has no posture; None for what can be reached."""
        frames = (constants[name] for name in ("DH", "BASE", "TOOL", "QMIN", "QMAX"))
        inverse = inverse_for(*frames)
        asked = {"joint object": _why_no_posture, "cartesian object": _why_no_pose}
        return [asked[kind](constants, inverse, values) if kind in asked else None for kind, values in targets]

    def init(self):
        known = self.constants(SimpleNamespace(BASE=self.BASE))
        for attribute, declared in self.declared_ports.items():
            if isinstance(declared, OutConst):
                setattr(self, attribute, known[declared.name or attribute])
        said = self.device.identity
        if said["ROBOT"] != puma560.ROBOT:
            raise ModuleError(f"expected a {puma560.ROBOT} behind the device, found a {said['ROBOT']}")
        if not np.allclose(said["BASE"], known["BASE"].ravel(), atol=1e-6):
            raise ModuleError(f"expected the robot at BASE {self.BASE}, found its frame 0 at {said['BASE']}")
        self._torque, self._highest, self._lowest = np.zeros(self.NDOF), self.TAUMAX.copy(), -self.TAUMAX

    def on(self, inputs):
        self.Q_MEZ = self.device.read()
        self._see_drive()

    def cycle(self):
        self.Q_MEZ = self.device.read()
        self._see_drive()
        torque = np.minimum(self.TAU_REF, self._highest, out=self._torque)
        self.device.write(np.maximum(torque, self._lowest, out=torque))

    def hold(self):
        self.Q_MEZ = self.device.read()
        self._see_drive()
        self.device.hold()

    def off(self):
        self.device.hold()

    def clear(self):
        self.device.read()
        if self.device.is_pressed:
            raise ModuleError("panic button pressed: let it go, then clear")
        self.device.clear()

    def _see_drive(self):
        if not self.device.is_held:
            return  # as nearly always: one look is enough
        if self.device.is_pressed:
            raise ModuleError("panic button pressed; the drive holds until it is let go and cleared")
        if self.device.is_tripped:
            raise ModuleError("the drive has tripped: it heard nothing for too long; clear brings it back to hold")


def _why_no_posture(constants, inverse, values):
    n = constants["NDOF"]
    if len(values) < n:
        return f"expected {n} joint values, found {len(values)}"
    for k, (q, low, high) in enumerate(zip(values, constants["QMIN"], constants["QMAX"], strict=False), 1):
        if not low <= q <= high:
            return f"joint {k} at {q:.2f} rad is beyond {low if q < low else high:.2f}"
    return None


def _why_no_pose(constants, inverse, values):
    try:
        found = inverse.nearest(pose_of_nine(values[:9]), [0.0] * constants["NDOF"])
    except ValueError as wrong:
        return str(wrong)
    return found if isinstance(found, str) else None
