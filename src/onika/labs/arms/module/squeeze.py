"""Opens or closes a gripper with a force."""

from onika.module import Input, InVar, Local, Module, OutVar, finish

STILL = 0.002  # m/s
NEAR = 0.001  # m


class Squeeze(Module):
    """Brings a gripper to an opening, with a force at most, and tells whether it holds something.

    It waits until the fingers stand still. It holds something where they do so before they are as near to each other as
    was wanted, and press.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR    GRIP_MEZ   double[3]  m,m/s,N  opening, its speed, force on a finger
             OUTVAR   OPEN_REF   double     m        wanted opening
             OUTVAR   FORCE_REF  double     N        highest force on a finger
    Local    LEAST               double     s        how long it takes at least: fingers have to begin
             MOST                double     s        how long it takes at most
             PRESSED             double     N        what presses less is not held
    Input    opening             double     m        0..1
             force               double     N        0.1..10000
    Finish   flow 1, loop TRUE where it holds something, else flow 0, loop FALSE; at a standstill or after MOST
    Source   dissertation §4.4.7.2, §6.2
    """

    trigger = True

    GRIP_MEZ = InVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")
    OPEN_REF = OutVar("double", "m", "wanted opening")
    FORCE_REF = OutVar("double", "N", "highest force on a finger")

    LEAST = Local("double", "s", "how long it takes at least: fingers have to begin", default=0.2, low=0.0)
    MOST = Local("double", "s", "how long it takes at most", default=3.0, low=0.0)
    PRESSED = Local("double", "N", "what presses less is not held", default=1.0, low=0.0)

    opening = Input("double", "m", "how far it is to be open", low=0.0, high=1.0)
    force = Input("double", "N", "how hard it may press", low=0.1, high=10000.0)

    def on(self, inputs):
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely
        self._closes = inputs.opening < self.GRIP_MEZ[0]
        self.OPEN_REF, self.FORCE_REF = inputs.opening, inputs.force

    def cycle(self):
        self._time += self.dt
        opening, speed, force = self.GRIP_MEZ
        still = abs(speed) < STILL
        if self._time < self.MOST and not (still and self._time >= self.LEAST):
            return None
        holds = bool(self._closes and opening > self.OPEN_REF + NEAR and force >= self.PRESSED)
        return finish(flow=int(holds), loop=holds)
