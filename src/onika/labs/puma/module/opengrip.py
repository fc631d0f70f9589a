"""Opens the hand."""

from onika.module import InVar, Local, Module, OutVar, finish

STILL = 0.002  # m/s


class Opengrip(Module):
    """Opens the hand and waits until its fingers stand still.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR    GRIP_MEZ  double[3]  m,m/s,N  opening, its speed, force on a finger
             OUTVAR   GRIP      double     -        +1: fingers apart
    Local    LEAST              double     s        how long it takes at least: air needs time
             MOST               double     s        how long it takes at most
    Finish   flow 0, loop FALSE, when the fingers stand still after LEAST, or after MOST
    Source   dissertation §6.2
    """

    trigger = True

    GRIP_MEZ = InVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")
    GRIP = OutVar("double", "-", "+1: fingers apart")

    LEAST = Local("double", "s", "how long it takes at least: air needs time", default=0.2)
    MOST = Local("double", "s", "how long it takes at most", default=0.6)

    def on(self, inputs):
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely
        self.GRIP = 1.0

    def cycle(self):
        self._time += self.dt
        still = abs(self.GRIP_MEZ[1]) < STILL
        if self._time >= self.MOST or (still and self._time >= self.LEAST):
            return finish()
        return None
