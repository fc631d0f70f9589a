"""An arc of the tool."""

from onika.laws.arrival import Arrival
from onika.laws.frames import pose_of_nine
from onika.laws.path import quintic
from onika.laws.paths.arc import Arc
from onika.laws.sentence import sentence_of
from onika.module import AskAgain, Input, InVar, Local, Module, ModuleError, OutVar, finish


class Carc(Module):
    """Arc of the tool through a place to a target, on the circle through all three; it turns evenly to the target.

    How the tool points at the place on the way is not minded. It takes both durations together, and passes the place
    when it comes there.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR   X_MEZ  double[4,4]  -      measured pose; the start where no reference is in force
             OUTVAR  X_REF  double[4,4]  -      reference pose; preloaded at `on`, it is the start
    Local    SPEED          double       m/s    peak speed of the tool
             TURN           double       rad/s  peak speed of its turning
             SETTLE         double       s      how long the arm may take to come to rest
             AWAY           double       m      how far from its target the tool may come to rest
    Input    via            double[9]    -      where to pass: approach, normal, position (m) in the world
             first          double       s      0.1..600
             pose           double[9]    -      approach, normal, position (m) in the world
             second         double       s      0.1..600
    Finish   flow 0, loop FALSE, when t >= T and the tool stands at the target, or SETTLE later
    Errors   no pose   a pose whose vectors are no unit vectors, or not square: asks again, stays OFF
             no arc    the three places lie on a line, the first not between: asks again, stays OFF
             too fast  durations too short for SPEED and TURN: warns and takes as long as it needs
             blocked   the tool is further than AWAY from its target when its time is over: ERROR
    Get/Set  progress 0..1 / -
    Source   dissertation §4.2.1; Craig, Introduction to Robotics, §7.4
    """

    trigger = True

    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    SPEED = Local("double", "m/s", "peak speed of the tool", default=0.3, low=1e-3)
    TURN = Local("double", "rad/s", "peak speed of its turning", default=1.5, low=1e-3)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "m", "how far from its target the tool may come to rest", default=0.02, low=1e-3)

    via = Input("double[9]", "-", "where to pass: approach, normal, position (m) in the world")
    first = Input("double", "s", "how long it takes to about there", low=0.1, high=600.0)
    pose = Input("double[9]", "-", "approach, normal, position (m) in the world")
    second = Input("double", "s", "how long it takes from about there", low=0.1, high=600.0)

    def on(self, inputs):
        start = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()
        try:
            end = pose_of_nine(inputs.pose)
            self._arc = Arc(start, pose_of_nine(inputs.via)[:3, 3], end)
        except ValueError as wrong:
            raise AskAgain(sentence_of(wrong)) from None
        duration, shortest = inputs.first + inputs.second, self._arc.duration(self.SPEED, self.TURN)
        if duration < shortest * (1.0 - 1e-9):
            self.warn(
                "{duration:g} s is too short for the tool's speed; the motion takes {shortest:.2f} s",
                duration=duration,
                shortest=shortest,
            )
        self._time, self._duration = 0.0, max(duration, shortest)
        self._arrival = Arrival.of_tool(end, self.X_MEZ, self.SETTLE)
        self.X_REF = start

    def cycle(self):
        self._time += self.dt
        share, _ = quintic(self._time, self._duration)
        self._arc.at(share, out=self.X_REF)
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
