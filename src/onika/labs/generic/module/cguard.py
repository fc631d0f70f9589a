"""Straight line of the tool that ends where it meets something."""

import numpy as np

from onika.laws.arrival import Arrival
from onika.laws.frames import pose_of_nine
from onika.laws.path import StraightLine, quintic
from onika.laws.sentence import sentence_of
from onika.module import AskAgain, Input, InVar, Local, Module, ModuleError, OutVar, finish

QUIET = 0.05  # s: how long the force is looked at from which pressing is counted
EASED = 0.5  # share of the limit at which what was met is pressed on no more than that
TURNS = 0.02
BACK = 0.2  # share of its pace with which it goes back


class Cguard(Module):
    """Straight line of the tool to the target, no further than what it meets: there it presses with so much at most.

    Where the tool is pressed harder than the limits it goes back on its way until it is pressed half as hard, and is
    done. Forces count from those that it feels when it begins, so that what it carries is no obstacle. How far a limit
    is passed depends on SPEED, and on how stiff arm and obstacle are: it is one of a motion, not of safety.

    Kind     trigger, periodic, 50..1000 Hz
    Ports    INVAR    X_MEZ  double[4,4]  -      measured pose; the start where no reference is in force
             INVAR    F_MEZ  double[6]    N,N m  force on the tool and torque about it, along the axes of the world
             OUTVAR   X_REF  double[4,4]  -      reference pose; preloaded at `on`, it is the start
    Local    SPEED           double       m/s    peak speed of the tool
             TURN            double       rad/s  peak speed of its turning
             SETTLE          double       s      how long the arm may take to come to rest
             AWAY            double       m      how far from its target the tool may come to rest
    Input    pose            double[9]    -      approach, normal, position (m) in the world
             duration        double       s      0.1..600
             force           double       N      10..200
             torque          double       N m    2..50
    Finish   flow 1, loop FALSE, where it has met something; flow 0, loop FALSE, when t >= T and the tool stands at
             the target, or SETTLE later
    Errors   no pose           approach or normal no unit vector, or not square: asks again, stays OFF
             too fast          duration too short for SPEED and TURN: warns and takes as long as it needs
             blocked           the tool is further than AWAY from its target when its time is over: ERROR
             something is met  warns: where, and how hard it pressed
    Get/Set  progress 0..1 / -
    Source   dissertation §4.4.2.1; Craig, Introduction to Robotics, §7.4
    """

    trigger = True

    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    F_MEZ = InVar("double[6]", "N,N m", "force on the tool and torque about it, along the axes of the world")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    SPEED = Local("double", "m/s", "peak speed of the tool", default=0.02, low=1e-3)
    TURN = Local("double", "rad/s", "peak speed of its turning", default=0.2, low=1e-3)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "m", "how far from its target the tool may come to rest", default=0.02, low=1e-3)

    pose = Input("double[9]", "-", "approach, normal, position (m) in the world")
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)
    force = Input("double", "N", "how hard it may press", low=10.0, high=200.0, default=30.0)
    torque = Input("double", "N m", "how hard it may twist", low=2.0, high=50.0, default=10.0)

    def on(self, inputs):
        try:
            end = pose_of_nine(inputs.pose)
        except ValueError as wrong:
            raise AskAgain(sentence_of(wrong)) from None
        start = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()
        self._line = StraightLine(start, end)
        shortest = self._line.duration(self.SPEED, self.TURN)
        if inputs.duration < shortest * (1.0 - 1e-9):
            self.warn(
                "{duration:g} s is too short for a speed at which force is felt; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._time, self._duration = 0.0, max(inputs.duration, shortest)
        self._force, self._torque = inputs.force, inputs.torque
        self._at_first, self._looks, self._has_met, self._pace = np.zeros(6), 0, False, 1.0
        self._arrival = Arrival.of_tool(end, self.X_MEZ, self.SETTLE)
        self.X_REF = start

    def cycle(self):
        pressed = self._pressed()
        if pressed >= 1.0 and not self._has_met:
            self._meet()
        if self._has_met:
            return self._ease(pressed)
        self._time += self.dt
        self._line.at(quintic(self._time, self._duration)[0], out=self.X_REF)
        is_over = self._arrival.is_over(self._time - self._duration, self.X_MEZ, self.dt)
        if not is_over:
            return None
        if why := self._arrival.tool_short(self.X_MEZ, self.AWAY):
            raise ModuleError(why)
        return finish()

    def get(self, name):
        if name == "progress":
            return min(self._time / self._duration, 1.0)
        return super().get(name)

    def _pressed(self):
        """How hard the tool is pressed, as a share of what it may be; 0 as long as it is only looked at."""
        if self._looks * self.dt < QUIET:
            self._looks += 1
            self._at_first += (self.F_MEZ - self._at_first) / self._looks
            return 0.0
        felt = self.F_MEZ - self._at_first
        return max(float(np.linalg.norm(felt[:3])) / self._force, float(np.linalg.norm(felt[3:])) / self._torque)

    def _meet(self):
        self._has_met = True
        felt = self.F_MEZ - self._at_first
        x, y, z = self.X_MEZ[:3, 3] * 100.0
        self.warn(
            "the tool met something at x = {x:.1f}, y = {y:.1f}, z = {z:.1f} cm, "
            "with {force:.0f} N and {torque:.0f} N m",
            x=float(x),
            y=float(y),
            z=float(z),
            force=float(np.linalg.norm(felt[:3])),
            torque=float(np.linalg.norm(felt[3:])),
        )

    def _ease(self, pressed):
        """Slower, and back on its way until it presses no harder than EASED, or is where it began."""
        if self._time <= 0.0 or (self._pace <= -BACK and pressed <= EASED):
            return finish(flow=1)
        self._pace = max(self._pace - (1.0 + BACK) * self.dt / TURNS, -BACK)
        self._time = max(self._time + self._pace * self.dt, 0.0)
        self._line.at(quintic(self._time, self._duration)[0], out=self.X_REF)
        return None
