"""A choice by how far the hand is open."""

from onika.module import Input, InVar, Local, Module, OutVar, finish


class Wider(Module):
    """Whether the hand is open wider than a level, for conditional applications and for loops that go on while it is.

    Kind     trigger, periodic, 10..1000 Hz
    Ports    INVAR    GRIP_MEZ  double[3]  m,m/s,N  opening, its speed, force on a finger
             OUTVAR   GRIP      double     -        as it was: what is held stays held
    Local    LOOK               double     s        how long is looked
    Input    level              double     m        0..1
    Finish   flow 1, loop TRUE where the opening is above the level, else flow 0, loop FALSE, after LOOK
    Source   dissertation §4.4.7.2, §4.4.7.3
    """

    trigger = True

    GRIP_MEZ = InVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")
    GRIP = OutVar("double", "-", "as it was: what is held stays held")

    LOOK = Local("double", "s", "how long is looked", default=0.1)

    level = Input("double", "m", "above which flow 1 is taken", low=0.0, high=1.0)

    def on(self, inputs):
        self._level = inputs.level
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely

    def cycle(self):
        self._time += self.dt
        if self._time < self.LOOK:
            return None
        is_wider = bool(self.GRIP_MEZ[0] > self._level)
        return finish(flow=int(is_wider), loop=is_wider)
