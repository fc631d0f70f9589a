"""Straight line of the tool that keeps what a sensor measures."""

import numpy as np

from onika.laws.frames import pose_of_nine
from onika.laws.path import StraightLine, quintic
from onika.laws.sentence import sentence_of
from onika.module import AskAgain, Input, InVar, Local, Module, ModuleError, OutVar, finish


class Cfollow(Module):
    """Straight line of the tool to the target; along AXIS it moves as a sensor wants it: the value stays at LEVEL.

    p(t) = p0 + s (I - a a^T) (p1 - p0) + h a,  dh/dt = GAIN (LEVEL - SENSE), at most RATE

    Along AXIS the target's own place counts for nothing; its turn, and its place across, do. AXIS is where a move makes
    the value grow: away from a surface whose distance is measured.

    Kind     trigger, periodic, 50..1000 Hz
    Ports    INVAR    X_MEZ  double[4,4]  -      measured pose; the start where no reference is in force
             INVAR    SENSE  double       -      what the sensor measures
             OUTVAR   X_REF  double[4,4]  -      reference pose; preloaded at `on`, it is the start
    Local    LEVEL           double       -      the value to keep, in the unit of the sensor
             AXIS            double[3]    -      along which the value grows, in the world; of any length but 0
             GAIN            double       -      speed along AXIS (m/s) for each unit by which the value is off
             RATE            double       m/s    peak speed along AXIS
             REACH           double       m      how far it may go along AXIS, either way
             CLOSE           double       -      how far the value may be off at the end, in the unit of the sensor
             SPEED           double       m/s    peak speed of the tool across AXIS
             TURN            double       rad/s  peak speed of its turning
             SETTLE          double       s      how long the value may take at the end to come to LEVEL
    Input    pose            double[9]    -      approach, normal, position (m) in the world
             duration        double       s      0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the value is within CLOSE of LEVEL; flow 1, loop FALSE, where it is not
             SETTLE later
    Errors   no pose           approach or normal no unit vector, or not square: asks again, stays OFF
             too fast          duration too short for SPEED and TURN: warns and takes as long as it needs
             led away          further along AXIS than REACH: ERROR
    Get/Set  progress 0..1 / -
    Source   dissertation §4.4.3.3; Craig, Introduction to Robotics, §7.4
    """

    trigger = True

    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    SENSE = InVar("double", "-", "what the sensor measures")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    LEVEL = Local("double", "-", "the value to keep, in the unit of the sensor")
    AXIS = Local(
        "double[3]", "-", "along which the value grows, in the world; of any length but 0", default=(0.0, 0.0, 1.0)
    )
    GAIN = Local("double", "-", "speed along AXIS (m/s) for each unit by which the value is off", default=5.0, low=0.0)
    RATE = Local("double", "m/s", "peak speed along AXIS", default=0.1, low=1e-3)
    REACH = Local("double", "m", "how far it may go along AXIS, either way", default=0.2, low=0.0)
    CLOSE = Local("double", "-", "how far the value may be off at the end, in the unit of the sensor", default=0.005)
    SPEED = Local("double", "m/s", "peak speed of the tool across AXIS", default=0.1, low=1e-3)
    TURN = Local("double", "rad/s", "peak speed of its turning", default=0.5, low=1e-3)
    SETTLE = Local("double", "s", "how long the value may take at the end to come to LEVEL", default=1.0, low=0.0)

    pose = Input("double[9]", "-", "approach, normal, position (m) in the world")
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def init(self):
        length = float(np.linalg.norm(self.AXIS))
        if not length > 0.0:
            raise ModuleError("expected a direction after AXIS, found 0 0 0")
        self._axis = np.asarray(self.AXIS) / length

    def on(self, inputs):
        try:
            end = pose_of_nine(inputs.pose)
        except ValueError as wrong:
            raise AskAgain(sentence_of(wrong)) from None
        start = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()
        end[:3, 3] -= self._axis * (self._axis @ (end[:3, 3] - start[:3, 3]))
        self._line = StraightLine(start, end)
        shortest = self._line.duration(self.SPEED, self.TURN)
        if inputs.duration < shortest * (1.0 - 1e-9):
            self.warn(
                "{duration:g} s is too short for the tool's speed; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._time, self._duration = 0.0, max(inputs.duration, shortest)
        self._height = 0.0
        self.X_REF = start

    def cycle(self):
        self._time += self.dt
        off = self.LEVEL - self.SENSE
        self._height += min(max(self.GAIN * off, -self.RATE), self.RATE) * self.dt
        if abs(self._height) > self.REACH:
            raise ModuleError(
                "the sensor led the tool {height:.1f} cm along its axis, expected {reach:.1f} cm at most",
                height=abs(self._height) * 100.0,
                reach=self.REACH * 100.0,
            )
        self._line.at(quintic(self._time, self._duration)[0], out=self.X_REF)
        self.X_REF[:3, 3] += self._height * self._axis
        late = self._time - self._duration
        if late >= 0.0 and abs(off) <= self.CLOSE:
            return finish()
        return finish(flow=1) if late >= self.SETTLE else None

    def get(self, name):
        if name == "progress":
            return min(self._time / self._duration, 1.0)
        return super().get(name)
