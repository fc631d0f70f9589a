"""Any arm without forces."""

from onika.laws.arm_identity import arm_constants
from onika.laws.arm_reach import ArmReach
from onika.module import InVar, Module, ModuleError, OutConst, OutVar


class ArmSim(ArmReach, Module):
    """Any arm in a world without forces: it is where the reference says. In place of `arm_pos`, nothing else changed.

    All that it publishes its device says of itself; nothing is felt, nothing collides.
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
             INVAR    Q_REF    double[NDOF]     rad    reference position; followed within QMIN..QMAX and Q^_MAX
             OUTVAR   Q_MEZ    double[NDOF]     rad    measured position
             OUTVAR   Q^_MEZ   double[NDOF]     rad/s  measured speed
             OUTVAR   TAU_MEZ  double[NDOF]     N m    none: 0
    Errors   another device    the device is no arm without forces: stays uninitialised
             tripped           the drive has tripped: ERROR; clear brings the drive back to hold
             panic button      it is pressed: ERROR; clear is refused until it is let go
    Source   dissertation §4.3.2, §4.4.4; decisions 5 and 46
    """

    hardware = True

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
    Q_REF = InVar(
        "double[NDOF]", "rad", "reference position; followed within QMIN..QMAX and Q^_MAX", step=(4.0, "dt", "Q^_MAX")
    )
    Q_MEZ = OutVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = OutVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_MEZ = OutVar("double[NDOF]", "N m", "none: 0")

    @classmethod
    def constants(cls, local, identity):
        """Everything that is known of an arm, by the names of the OUTCONSTs, as its device says it."""
        return arm_constants(identity)

    def init(self):
        self.state_constants()
        published, taken = len(self.device.sheet.state) - 2, len(self.device.sheet.command)
        if (published, taken) != (self.NDOF, self.NDOF):
            raise ModuleError(
                "expected an arm without forces that publishes and takes {count} numbers, "
                "found one that publishes {published} and takes {taken}",
                count=self.NDOF,
                published=published,
                taken=taken,
            )

    def on(self, inputs):
        self.Q_MEZ = self.device.read()
        self.check_drive()
        self.Qd_MEZ, self.TAU_MEZ = 0.0, 0.0

    def cycle(self):
        self._read()
        self.device.write(self.Q_REF)

    def hold(self):
        self._read()
        self.device.hold()

    def held(self, name):
        return self.Q_MEZ

    def off(self):
        self.device.hold()

    def clear(self):
        self.clear_drive()

    def _read(self):
        place = self.device.read()
        self.Qd_MEZ = (place - self.Q_MEZ) / self.dt
        self.Q_MEZ = place
        self.check_drive()
