"""Joint servo with an integral."""

import numpy as np

from onika.module import InConst, InVar, Local, Module, OutVar


class Pid(Module):
    """Joint servo as `pd`, which also adds up what is left of the error: no load leaves the joint beside its reference.

    tau = KP (q_ref - q) + KD (qd_ref - qd) + i,  di/dt = RATE KP (q_ref - q), held within MOST TAUMAX

    While the whole torque is beyond TAUMAX the sum does not grow further that way.

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  NDOF    int           -          number of joints
             INCONST  KP      double[NDOF]  N m/rad    stiffness
             INCONST  KD      double[NDOF]  N m s/rad  damping
             INCONST  TAUMAX  double[NDOF]  N m        highest joint torques
             INVAR    Q_REF   double[NDOF]  rad        reference position
             INVAR    Q^_REF  double[NDOF]  rad/s      reference speed
             INVAR    Q_MEZ   double[NDOF]  rad        measured position
             INVAR    Q^_MEZ  double[NDOF]  rad/s      measured speed
             OUTVAR   TAU_PD  double[NDOF]  N m        the torque
    Local    RATE             double        1/s        share of KP that is added up in a second
             MOST             double        -          share of TAUMAX that the sum may come to
    Errors   no reference  Q_REF was not written since the hardware held: only brakes until it is, and adds nothing up
    Source   Craig, Introduction to Robotics, §9.7; Åström & Hägglund, PID Controllers, §3.5
    """

    NDOF = InConst("int", "-", "number of joints")
    KP = InConst("double[NDOF]", "N m/rad", "stiffness")
    KD = InConst("double[NDOF]", "N m s/rad", "damping")
    TAUMAX = InConst("double[NDOF]", "N m", "highest joint torques")
    Q_REF = InVar("double[NDOF]", "rad", "reference position")
    Qd_REF = InVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Qd_MEZ = InVar("double[NDOF]", "rad/s", "measured speed", name="Q^_MEZ")
    TAU_PD = OutVar("double[NDOF]", "N m", "the torque")

    RATE = Local("double", "1/s", "share of KP that is added up in a second", default=1.0, low=0.0, high=20.0)
    MOST = Local("double", "-", "share of TAUMAX that the sum may come to", default=0.2, low=0.0, high=1.0)

    def on(self, inputs):
        # a reference from before the last hold would tear the arm away: it is not followed until it is written anew
        self._stale = None if self.continues("Q_REF") else self.Q_REF.copy()
        self._sum = np.zeros(self.NDOF)
        self._servo(0.0)

    def cycle(self):
        self._servo(self.dt)

    def _servo(self, dt):
        """The torque, after the error was added up for so long."""
        brake = self.KD * (self.Qd_REF - self.Qd_MEZ)
        if self._stale is not None and np.array_equal(self.Q_REF, self._stale):
            self.TAU_PD = -self.KD * self.Qd_MEZ
            return
        self._stale = None
        pull = self.KP * (self.Q_REF - self.Q_MEZ)
        whole = pull + brake + self._sum
        has_room = (np.abs(whole) <= self.TAUMAX) | (pull * whole < 0.0)
        most = self.MOST * self.TAUMAX
        self._sum = np.clip(self._sum + np.where(has_room, self.RATE * dt * pull, 0.0), -most, most)
        self.TAU_PD = pull + brake + self._sum
