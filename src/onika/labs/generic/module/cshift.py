"""Straight line of the tool from where it is."""

import numpy as np

from onika.laws.arrival import Arrival
from onika.laws.path import PEAK, quintic
from onika.module import Input, InVar, Local, Module, ModuleError, OutVar, finish


class Cshift(Module):
    """Straight line of the tool by so much from where it is; it points where it pointed.

    p(t) = p0 + s d, s of fifth order in t / T

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR    X_MEZ  double[4,4]  -    measured pose; the start where no reference is in force
             OUTVAR   X_REF  double[4,4]  -    reference pose; preloaded at `on`, it is the start
    Local    SPEED           double       m/s  peak speed of the tool
             SETTLE          double       s    how long the arm may take to come to rest
             AWAY            double       m    how far from its target the tool may come to rest
    Input    shift           double[3]    m    -2..2
             duration        double       s    0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the tool stands at the target, or SETTLE later
    Errors   too fast        duration too short for SPEED: warns and takes as long as it needs
             blocked         the tool is further than AWAY from its target when its time is over: ERROR
    Get/Set  progress 0..1 / -
    Source   dissertation §4.2.1, §4.4.3; Craig, Introduction to Robotics, §7.4
    """

    trigger = True

    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    SPEED = Local("double", "m/s", "peak speed of the tool", default=0.3, low=1e-3)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "m", "how far from its target the tool may come to rest", default=0.02, low=1e-3)

    shift = Input(
        "double[3]", "m", "how far from where it is, along the axes of the world: x, y, z", low=-2.0, high=2.0
    )
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def on(self, inputs):
        start = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()
        self._from, self._way = start[:3, 3].copy(), np.array(inputs.shift)
        end = start.copy()
        end[:3, 3] += self._way
        shortest = PEAK * float(np.linalg.norm(self._way)) / self.SPEED
        if inputs.duration < shortest * (1.0 - 1e-9):
            self.warn(
                "{duration:g} s is too short for the tool's speed; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._time, self._duration = 0.0, max(inputs.duration, shortest)
        self._arrival = Arrival.of_tool(end, self.X_MEZ, self.SETTLE)
        self.X_REF = start

    def cycle(self):
        self._time += self.dt
        share, _ = quintic(self._time, self._duration)
        self.X_REF[:3, 3] = self._from + share * self._way
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
