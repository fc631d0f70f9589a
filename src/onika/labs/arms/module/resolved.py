"""Joint references for a wanted speed of the tool."""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.resolved_rate import ResolvedRate
from onika.module import InConst, InVar, Local, Module, OutVar


class ResolvedMotion(Module):
    """Joint references for a wanted speed of the tool: resolved motion rate control of any arm.

    Near singular postures it is slower than wanted, at limits it stops what would pass them, and where a joint would be
    too fast the tool is slowed down in its direction. Joints that the tool does not feel go home.

    Kind     general, periodic, 50..1000 Hz
    Ports    INCONST  NDOF    int             -          number of joints
             INCONST  SCREW   double[NDOF,6]  -          axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -          the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -          frame 0 in the world
             INCONST  TOOL    double[4,4]     -          the tool at q = 0 in frame 0
             INCONST  QMIN    double[NDOF]    rad        lower joint limits
             INCONST  QMAX    double[NDOF]    rad        upper joint limits
             INCONST  Q^_MAX  double[NDOF]    rad/s      highest joint speeds
             INCONST  HOME    double[NDOF]    rad        where it begins, and goes back to
             INVAR    V_REF   double[6]       m/s,rad/s  wanted speed of the tool and of its turning, in the world
             INVAR    Q_MEZ   double[NDOF]    rad        measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]    rad        reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]    rad/s      reference speed
    Local    SPEED            double          -          share of Q^_MAX that a joint may have
             HOMING           double          1/s        how quick joints that the tool does not feel go home; 0: never
    Errors   no reference     V_REF was not written since the hardware held: stays where it is until it is
    Source   Whitney 1969; Nakamura & Hanafusa 1986; Maciejewski & Klein 1988
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    HOME = InConst("double[NDOF]", "rad", "where it begins, and goes back to")
    V_REF = InVar("double[6]", "m/s,rad/s", "wanted speed of the tool and of its turning, in the world")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    SPEED = Local("double", "-", "share of Q^_MAX that a joint may have", default=0.6, low=0.01, high=1.0)
    HOMING = Local(
        "double",
        "1/s",
        "how quick joints that the tool does not feel go home; 0: never",
        default=0.5,
        low=0.0,
        high=10.0,
    )

    def init(self):
        arm = ArmModel(self.SCREW, parent=self.PARENT, base=self.BASE, tool=self.TOOL)
        self._rate = ResolvedRate(arm, self.QMIN, self.QMAX, self.SPEED * self.Qd_MAX, self.HOME, self.HOMING)
        self._rate.speeds(
            self.HOME, np.zeros(6), self.dt
        )  # the model is built with its first use: here, not in a cycle

    def on(self, inputs):
        # a speed from before the last hold is not followed: it is waited for until it changes
        self._stale = None if self.continues("V_REF") else self.V_REF.copy()
        self.Q_REF = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self.Qd_REF = 0.0

    def cycle(self):
        if self._stale is not None and np.array_equal(self.V_REF, self._stale):
            return
        self._stale = None
        speeds = self._rate.speeds(self.Q_REF, self.V_REF, self.dt)
        self.Q_REF += self.dt * speeds
        self.Qd_REF = speeds
