"""Servo of another site, whose Q_REF is what is measured and whose Q_MEZ is what is wanted."""

from onika.module import InConst, InVar, Module, OutVar


class Stiff(Module):
    """Spring and damper towards the wanted position.

    u = SPRING (Q_MEZ - Q_REF) + DAMPER (VEL_CMD - VEL_ACT)

    Kind     general, periodic, 100..1000 Hz
    Ports    INCONST  N_AX     int           -          number of axes
             INCONST  SPRING   double[N_AX]  N m/rad    stiffness
             INCONST  DAMPER   double[N_AX]  N m s/rad  damping
             INVAR    Q_MEZ    double[N_AX]  rad        where they shall be, in spite of its name
             INVAR    VEL_CMD  double[N_AX]  rad/s      how fast
             INVAR    Q_REF    double[N_AX]  rad        where the axes are, in spite of its name
             INVAR    VEL_ACT  double[N_AX]  rad/s      how fast they are
             OUTVAR   EFFORT   double[N_AX]  N m        the torque
    Errors   no command        Q_MEZ was not written since the hardware held: only brakes until it is
    """

    N_AX = InConst("int", "-", "number of axes")
    SPRING = InConst("double[N_AX]", "N m/rad", "stiffness")
    DAMPER = InConst("double[N_AX]", "N m s/rad", "damping")
    Q_MEZ = InVar("double[N_AX]", "rad", "where they shall be, in spite of its name")
    VEL_CMD = InVar("double[N_AX]", "rad/s", "how fast")
    Q_REF = InVar("double[N_AX]", "rad", "where the axes are, in spite of its name")
    VEL_ACT = InVar("double[N_AX]", "rad/s", "how fast they are")
    EFFORT = OutVar("double[N_AX]", "N m", "the torque")

    def on(self, inputs):
        self._stale = None if self.continues("Q_MEZ") else self.Q_MEZ.copy()
        self.cycle()

    def cycle(self):
        if self._stale is not None and (self._stale == self.Q_MEZ).all():
            self.EFFORT = -self.DAMPER * self.VEL_ACT
            return
        self._stale = None
        self.EFFORT = self.SPRING * (self.Q_MEZ - self.Q_REF) + self.DAMPER * (self.VEL_CMD - self.VEL_ACT)
