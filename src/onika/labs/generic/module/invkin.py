"""Inverse kinematics."""

import numpy as np

from onika.laws.inverse import inverse_for
from onika.laws.path import quintic
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class Invkin(Module):
    """Joint angles for a wanted pose of the tool: the posture nearest to the last one.

    At `on` the joints stay where they are; what the wanted pose differs from that is blended in, so nothing jumps.

    Kind     general, periodic, 50..1000 Hz
    Ports    INCONST  NDOF    int             -      number of joints
             INCONST  SCREW   double[NDOF,6]  -      axis and moment of each joint, at q = 0 in frame 0
             INCONST  PARENT  int[NDOF]       -      the joint that bears each joint; -1: the base
             INCONST  BASE    double[4,4]     -      frame 0 in the world
             INCONST  TOOL    double[4,4]     -      the tool at q = 0 in frame 0
             INCONST  QMIN    double[NDOF]    rad    lower joint limits
             INCONST  QMAX    double[NDOF]    rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]    rad/s  highest joint speeds
             INVAR    X_REF   double[4,4]     -      reference pose of the tool in the world
             INVAR    Q_MEZ   double[NDOF]    rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]    rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]    rad/s  reference speed
    Local    BLEND            double          s      how long the difference at the start is blended in
             STEP             double          rad    how large it may be
    Errors   no posture        the pose is out of reach: ERROR with the reason
             too far           the first pose is more than STEP away: ERROR
             too fast          a joint would pass Q^_MAX: ERROR
             no reference      X_REF was not written since the hardware held: stays where it is until it is
    Source   dissertation §3.2.1; Fu, Gonzalez & Lee, Robotics, §2.3
    """

    NDOF = InConst("int", "-", "number of joints")
    SCREW = InConst("double[NDOF,6]", "-", "axis and moment of each joint, at q = 0 in frame 0")
    PARENT = InConst("int[NDOF]", "-", "the joint that bears each joint; -1: the base")
    BASE = InConst("double[4,4]", "-", "frame 0 in the world")
    TOOL = InConst("double[4,4]", "-", "the tool at q = 0 in frame 0")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    X_REF = InVar("double[4,4]", "-", "reference pose of the tool in the world")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    BLEND = Local("double", "s", "how long the difference at the start is blended in", default=0.25)
    STEP = Local("double", "rad", "how large it may be", default=0.1, low=1e-6)

    def init(self):
        # postures far from the last one are not looked for: a cycle has no time for that, and the arm could not jump
        self._inverse = inverse_for(self.SCREW, self.BASE, self.TOOL, self.QMIN, self.QMAX, self.PARENT, starts=0)

    def on(self, inputs):
        # a pose from before the last hold is not followed: it is waited for until it changes
        self._stale = None if self.continues("X_REF") else self.X_REF.copy()
        self._posture = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        self._offset, self._time = None, 0.0
        self.Q_REF = self._posture
        self.Qd_REF = 0.0

    def cycle(self):
        if self._stale is not None and np.array_equal(self.X_REF, self._stale):
            return
        self._stale = None
        posture = self._inverse.nearest(self.X_REF, self._posture)
        if isinstance(posture, str):
            raise ModuleError(posture)
        if self._offset is None:
            self._offset = self._first_offset(posture)
        self._posture = posture
        self._time += self.dt
        wanted = posture
        if self._time < self.BLEND:
            wanted = posture + (1.0 - quintic(self._time, self.BLEND)[0]) * self._offset
        speed = (wanted - self.Q_REF) / self.dt
        if np.maximum.reduce(np.abs(speed) - self.Qd_MAX) > 0.0:
            self._too_fast(speed)
        self.Q_REF = wanted
        self.Qd_REF = speed

    def _first_offset(self, posture):
        offset = self.Q_REF - posture
        joint = int(np.abs(offset).argmax())
        if abs(offset[joint]) > self.STEP:
            raise ModuleError(
                "the arm does not stand where the motion begins: joint {joint} is {away:.3f} rad away, "
                "{step:g} rad are allowed",
                joint=joint + 1,
                away=abs(offset[joint]),
                step=self.STEP,
            )
        return offset

    def _too_fast(self, speed):
        joint = int((np.abs(speed) / self.Qd_MAX).argmax())
        raise ModuleError(
            "the motion is too fast for the arm: joint {joint} would turn at {speed:.2f} rad/s, "
            "and can turn at {limit:.2f} rad/s",
            joint=joint + 1,
            speed=abs(speed[joint]),
            limit=self.Qd_MAX[joint],
        )
