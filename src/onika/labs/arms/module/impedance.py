"""A spring and a damper at the tool."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.frames import rotation_log
from onika.module import InConst, InVar, Local, Module, OutVar


class Impedance(Module):
    """A spring and a damper between the tool and its reference, as joint torques; the weight is borne by `gravcomp`.

    tau = J^T (K (x_ref - x) - D J qd) - b qd, the spring's force at most MOST

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  NDOF    int             -      number of joints
             INCONST  SCREW   double[NDOF,6]  -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -      the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -      frame 0 in the world
             INCONST  TOOL    double[4,4]     -      the tool at q = 0 in frame 0
             INVAR    X_REF   double[4,4]     -      reference pose of the tool in the world
             INVAR    Q_MEZ   double[NDOF]    rad    measured position
             INVAR    Q^_MEZ  double[NDOF]    rad/s  measured speed
             OUTVAR   TAU_PD  double[NDOF]    N m    the torque
    Local    STIFF            double          N/m          stiffness of the place
             TURN             double          N m/rad      stiffness of the turning
             DAMP             double          N s/m        damping of the place
             DAMPTURN         double          N m s/rad    damping of the turning
             JOINTS           double          N m s/rad    damping of each joint, for those that the tool does not feel
             MOST             double          N            the spring pulls no harder, nor in N m turns
    Errors   no reference     X_REF was not written since the hardware held: only brakes until it is
    Source   Hogan, Impedance Control, 1985; Lynch & Park, Modern Robotics, §11.7
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    X_REF = InVar("double[4,4]", "-", "reference pose of the tool in the world")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_PD = OutVar("double[NDOF]", "N m", "the torque")

    STIFF = Local("double", "N/m", "stiffness of the place", default=400.0, low=0.0)
    TURN = Local("double", "N m/rad", "stiffness of the turning", default=20.0, low=0.0)
    DAMP = Local("double", "N s/m", "damping of the place", default=60.0, low=0.0)
    DAMPTURN = Local("double", "N m s/rad", "damping of the turning", default=2.0, low=0.0)
    JOINTS = Local(
        "double", "N m s/rad", "damping of each joint, for those that the tool does not feel", default=0.5, low=0.0
    )
    MOST = Local("double", "N", "the spring pulls no harder, nor in N m turns", default=40.0, low=0.0)

    def init(self):
        self._arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)
        self._damping = np.array([self.DAMP] * 3 + [self.DAMPTURN] * 3)
        self._arm.forward(np.zeros(self.NDOF))  # the model is built with its first use: here, not in a cycle

    def on(self, inputs):
        # a pose from before the last hold is not pulled at: it is waited for until it changes
        self._stale = None if self.continues("X_REF") else self.X_REF.copy()
        self.cycle()

    def cycle(self):
        jacobian = self._arm.jacobian(self.Q_MEZ)
        wrench = -self._damping * (jacobian @ self.Qd_MEZ)
        if self._stale is None or not np.array_equal(self.X_REF, self._stale):
            self._stale = None
            wrench += self._pull()
        self.TAU_PD = jacobian.T @ wrench - self.JOINTS * self.Qd_MEZ

    def _pull(self):
        pose, wanted = self._arm.forward(self.Q_MEZ), self.X_REF
        force = self.STIFF * (wanted[:3, 3] - pose[:3, 3])
        twist = self.TURN * rotation_log(wanted[:3, :3] @ pose[:3, :3].T)
        return np.concatenate([part * min(1.0, self.MOST / max(np.linalg.norm(part), 1e-9)) for part in (force, twist)])
