"""Torque against friction, ahead of it."""

import numpy as np

from onika.module import InConst, InVar, Local, Module, OutVar


class FrictionAhead(Module):
    """Adds to a torque what friction will take of it at the wanted speed, so that the servo has less to do.

    tau_out = tau_in + b qd_ref + f tanh(qd_ref / EASE)

    It is the wanted speed that counts: friction that is made good with the measured one pushes light links ever faster.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF     int              -      number of joints
             INCONST  LINK     double[NDOF,13]  -      mass, centre, inertia, armature, friction of each link (SI)
             INVAR    Q^_REF   double[NDOF]     rad/s  reference speed
             INVAR    TAU_IN   double[NDOF]     N m    torque
             OUTVAR   TAU_OUT  double[NDOF]     N m    torque with what friction takes
    Local    VISCOUS           double           -      share of the viscous friction of LINK that is made good
             DRY               double           -      share of the dry friction of LINK that is made good
             EASE              double           rad/s  speed below which dry friction is taken to be less
    Source   Craig, Introduction to Robotics, §10.4
    """

    NDOF = InConst("int", "-", "number of joints")
    LINK = InConst("double[NDOF,13]", "-", "mass, centre, inertia, armature, friction of each link (SI)")
    Qd_REF = InVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")
    TAU_IN = InVar("double[NDOF]", "N m", "torque")
    TAU_OUT = OutVar("double[NDOF]", "N m", "torque with what friction takes")

    VISCOUS = Local(
        "double", "-", "share of the viscous friction of LINK that is made good", default=1.0, low=0.0, high=1.0
    )
    DRY = Local("double", "-", "share of the dry friction of LINK that is made good", default=0.8, low=0.0, high=1.0)
    EASE = Local("double", "rad/s", "speed below which dry friction is taken to be less", default=0.05, low=1e-4)

    def init(self):
        self._viscous, self._dry = self.VISCOUS * self.LINK[:, 11], self.DRY * self.LINK[:, 12]

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        speed = np.where(np.isfinite(self.Qd_REF), self.Qd_REF, 0.0)
        self.TAU_OUT = self.TAU_IN + self._viscous * speed + self._dry * np.tanh(speed / self.EASE)
