"""Straight line of the tool that ends where a sensor's value passes a bound."""

from onika.laws.arrival import Arrival
from onika.laws.frames import pose_of_nine
from onika.laws.path import StraightLine, quintic
from onika.laws.sentence import sentence_of
from onika.module import AskAgain, Input, InVar, Local, Module, ModuleError, OutVar, finish

FALLS, RISES = "below", "above"


class Csense(Module):
    """Straight line of the tool to the target, no further than to where what a sensor measures passes a bound.

    There it slows down within BRAKE and is done. The bound is passed where the value is at LEVEL or beyond it, on its
    side; where that is so already, the tool stays.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR    X_MEZ  double[4,4]  -      measured pose; the start where no reference is in force
             INVAR    SENSE  double       -      what the sensor measures
             OUTVAR   X_REF  double[4,4]  -      reference pose; preloaded at `on`, it is the start
    Local    LEVEL           double       -      the bound, in the unit of the sensor
             SIDE            string       -      below: it ends where the value falls to LEVEL; above: where it rises
             SPEED           double       m/s    peak speed of the tool
             TURN            double       rad/s  peak speed of its turning
             BRAKE           double       s      how long it takes to stop
             SETTLE          double       s      how long the arm may take to come to rest
             AWAY            double       m      how far from its target the tool may come to rest
    Input    pose            double[9]    -      approach, normal, position (m) in the world
             duration        double       s      0.1..600
    Finish   flow 1, loop FALSE, where the bound is passed; flow 0, loop FALSE, when t >= T and the tool stands at the
             target, or SETTLE later
    Errors   no pose           approach or normal no unit vector, or not square: asks again, stays OFF
             too fast          duration too short for SPEED and TURN: warns and takes as long as it needs
             blocked           the tool is further than AWAY from its target when its time is over: ERROR
    Get/Set  progress 0..1 / -
    Source   dissertation §4.4.3.3; Craig, Introduction to Robotics, §7.4
    """

    trigger = True

    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    SENSE = InVar("double", "-", "what the sensor measures")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    LEVEL = Local("double", "-", "the bound, in the unit of the sensor")
    SIDE = Local("string", "-", "below: it ends where the value falls to LEVEL; above: where it rises", default=FALLS)
    SPEED = Local("double", "m/s", "peak speed of the tool", default=0.05, low=1e-3)
    TURN = Local("double", "rad/s", "peak speed of its turning", default=0.5, low=1e-3)
    BRAKE = Local("double", "s", "how long it takes to stop", default=0.1, low=0.0)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "m", "how far from its target the tool may come to rest", default=0.02, low=1e-3)

    pose = Input("double[9]", "-", "approach, normal, position (m) in the world")
    duration = Input("double", "s", "how long it takes", low=0.1, high=600.0)

    def init(self):
        if self.SIDE not in (FALLS, RISES):
            raise ModuleError("expected below or above after SIDE, found {side}", side=self.SIDE)

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
                "{duration:g} s is too short for the tool's speed; the motion takes {shortest:.2f} s",
                duration=inputs.duration,
                shortest=shortest,
            )
        self._time, self._duration = 0.0, max(inputs.duration, shortest)
        self._pace, self._is_passed = 1.0, False
        self._arrival = Arrival.of_tool(end, self.X_MEZ, self.SETTLE)
        self.X_REF = start

    def cycle(self):
        self._is_passed = self._is_passed or self._passes()
        if self._is_passed:
            return self._stop()
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

    def _passes(self):
        return self.SENSE <= self.LEVEL if self.SIDE == FALLS else self.SENSE >= self.LEVEL

    def _stop(self):
        """Slower along the line, until it stands."""
        self._pace -= self.dt / max(self.BRAKE, self.dt)
        if self._time <= 0.0 or self._pace <= 0.0:
            return finish(flow=1)
        self._time += self._pace * self.dt
        self._line.at(quintic(self._time, self._duration)[0], out=self.X_REF)
        return None
