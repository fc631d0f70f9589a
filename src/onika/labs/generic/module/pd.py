"""Joint servo."""

import numpy as np

from onika.module import InConst, InVar, Local, Module, OutVar


class Pd(Module):
    """Joint servo: stiffness towards the reference position, damping towards the reference speed.

    tau = STIFF KP (q_ref - q) + DAMP KD (qd_ref - qd)

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  NDOF    int           -          number of joints
             INCONST  KP      double[NDOF]  N m/rad    stiffness
             INCONST  KD      double[NDOF]  N m s/rad  damping
             INVAR    Q_REF   double[NDOF]  rad        reference position
             INVAR    Q^_REF  double[NDOF]  rad/s      reference speed
             INVAR    Q_MEZ   double[NDOF]  rad        measured position
             INVAR    Q^_MEZ  double[NDOF]  rad/s      measured speed
             OUTVAR   TAU_PD  double[NDOF]  N m        the torque
    Local    STIFF   double        -          share of KP, for tuning; 1 is the robot's own stiffness
             DAMP    double        -          share of KD, for tuning; 1 is the robot's own damping
    Errors   no reference      Q_REF was not written since the hardware held: only brakes until it is
    Source   dissertation §3.2.1; Craig, Introduction to Robotics, §9.4
    """

    NDOF = InConst("int", "-", "number of joints")
    KP = InConst("double[NDOF]", "N m/rad", "stiffness")
    KD = InConst("double[NDOF]", "N m s/rad", "damping")
    Q_REF = InVar("double[NDOF]", "rad", "reference position")
    Qd_REF = InVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_PD = OutVar("double[NDOF]", "N m", "the torque")

    STIFF = Local(
        "double", "-", "share of KP, for tuning; 1 is the robot's own stiffness", default=1.0, low=0.1, high=2.0
    )
    DAMP = Local("double", "-", "share of KD, for tuning; 1 is the robot's own damping", default=1.0, low=0.1, high=2.0)

    def on(self, inputs):
        # a reference from before the last hold would tear the arm away: it is not followed until it is written anew
        self._stale = None if self.continues("Q_REF") else self.Q_REF.copy()
        self._pull, self._brake = np.zeros(self.NDOF), np.zeros(self.NDOF)
        # a port's array stays the same while the task lives: taken once, it is quicker at hand
        self._place = self.Q_REF, self.Q_MEZ, self.STIFF * self.KP
        self._damping = self.DAMP * self.KD
        self._speed = self.Qd_REF, self.Qd_MEZ, self._damping
        self.cycle()

    def cycle(self):
        if self._stale is not None and np.array_equal(self.Q_REF, self._stale):
            self.TAU_PD = -self._damping * self.Qd_MEZ
            return
        self._stale = None
        pull, brake = self._pull, self._brake
        wanted, measured, stiffness = self._place
        np.subtract(wanted, measured, out=pull)
        np.multiply(pull, stiffness, out=pull)
        wanted, measured, damping = self._speed
        np.subtract(wanted, measured, out=brake)
        np.multiply(brake, damping, out=brake)
        np.add(pull, brake, out=self.TAU_PD)
