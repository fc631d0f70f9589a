"""A choice by what is in the hand."""

from onika.module import InVar, Local, Module, OutVar, finish

PRESSED = 5.0  # N, on a finger


class Holds(Module):
    """Whether the hand holds something, for conditional applications and for loops that go on while it does.

    Kind     trigger, periodic, 10..1000 Hz
    Ports    INVAR    GRIP_MEZ  double[3]  m,m/s,N  opening, its speed, force on a finger
             OUTVAR   GRIP      double     -        as it was: what is held stays held
    Local    THIN               double     m        fingers nearer to each other hold nothing
             LOOK               double     s        how long is looked
    Finish   flow 1, loop TRUE where something between the fingers presses on them, else flow 0, loop FALSE, after LOOK
    Source   dissertation §4.4.7.2, §4.4.7.3
    """

    trigger = True

    GRIP_MEZ = InVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")
    GRIP = OutVar("double", "-", "as it was: what is held stays held")

    THIN = Local("double", "m", "fingers nearer to each other hold nothing", default=0.005)
    LOOK = Local("double", "s", "how long is looked", default=0.1)

    def on(self, inputs):
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely

    def cycle(self):
        self._time += self.dt
        if self._time < self.LOOK:
            return None
        opening, _, force = self.GRIP_MEZ
        holds = bool(opening > self.THIN and force > PRESSED)
        return finish(flow=int(holds), loop=holds)
