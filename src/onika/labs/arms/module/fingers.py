"""Brings a gripper to an opening."""

from onika.module import Input, InVar, Local, Module, OutVar, finish

STILL = 0.002  # m/s


class Fingers(Module):
    """Brings a gripper to the opening of its target, with a force at most, and waits until it stands still.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR    GRIP_MEZ   double[3]  m,m/s,N  opening, its speed, force on a finger
             OUTVAR   OPEN_REF   double     m        wanted opening
             OUTVAR   FORCE_REF  double     N        highest force on a finger
    Local    FORCE               double     N        how hard it may press
             LEAST               double     s        how long it takes at least: fingers have to begin
             MOST                double     s        how long it takes at most
    Input    level               double     m        0..1
    Finish   flow 0, loop FALSE, at a standstill or after MOST
    Source   dissertation §6.2
    """

    trigger = True

    GRIP_MEZ = InVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")
    OPEN_REF = OutVar("double", "m", "wanted opening")
    FORCE_REF = OutVar("double", "N", "highest force on a finger")

    FORCE = Local("double", "N", "how hard it may press", default=10.0, low=0.1)
    LEAST = Local("double", "s", "how long it takes at least: fingers have to begin", default=0.2, low=0.0)
    MOST = Local("double", "s", "how long it takes at most", default=3.0, low=0.0)

    level = Input("double", "m", "how far it is to be open", low=0.0, high=1.0)

    def on(self, inputs):
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely
        self.OPEN_REF, self.FORCE_REF = inputs.level, self.FORCE

    def cycle(self):
        self._time += self.dt
        still = abs(self.GRIP_MEZ[1]) < STILL
        return finish() if self._time >= self.MOST or (still and self._time >= self.LEAST) else None
