"""Drives a base to a place."""

import numpy as np

from onika.laws.paths.base_drive import BaseDrive
from onika.module import Input, InVar, Local, Module, ModuleError, OutVar, finish


class Gopose(Module):
    """Drives a base to a place: it turns towards it, goes there, and turns as it is wanted.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INVAR    P_MEZ   double[3]  m,m,rad        where the base believes to be: x, y and turn
             OUTVAR   V_BASE  double[3]  m/s,m/s,rad/s  wanted speeds: forward, to the left, turning
    Local    SPEED            double     m/s            highest speed
             TURN             double     rad/s          highest rate of turning
             RISE             double     m/s^2          highest change of the speed
             TURNRISE         double     rad/s^2        highest change of the rate of turning
             NEAR             double     m              how near to its place it comes
             NEARTURN         double     rad            how near to its turn it comes
             MOST             double     s              how long it may take
    Input    place            double[3]  m,m,rad        -1000..1000
    Finish   flow 0, loop FALSE, when the base stands at its place
    Errors   too long          it is not there after MOST: ERROR
    Get/Set  away, in m, from its place / -
    Source   dissertation §4.5.3
    """

    trigger = True

    P_MEZ = InVar("double[3]", "m,m,rad", "where the base believes to be: x, y and turn")
    V_BASE = OutVar("double[3]", "m/s,m/s,rad/s", "wanted speeds: forward, to the left, turning")

    SPEED = Local("double", "m/s", "highest speed", default=0.4, low=1e-3)
    TURN = Local("double", "rad/s", "highest rate of turning", default=1.2, low=1e-3)
    RISE = Local("double", "m/s^2", "highest change of the speed", default=0.6, low=1e-3)
    TURNRISE = Local("double", "rad/s^2", "highest change of the rate of turning", default=3.0, low=1e-3)
    NEAR = Local("double", "m", "how near to its place it comes", default=0.005, low=1e-4)
    NEARTURN = Local("double", "rad", "how near to its turn it comes", default=0.01, low=1e-4)
    MOST = Local("double", "s", "how long it may take", default=120.0, low=0.1)

    place = Input("double[3]", "m,m,rad", "where to go: x, y and turn", low=-1e3, high=1e3)

    def on(self, inputs):
        start = self.V_BASE.copy() if self.continues("V_BASE") else np.zeros(3)
        self._drive = BaseDrive(
            inputs.place, start, (self.SPEED, self.RISE), (self.TURN, self.TURNRISE), (self.NEAR, self.NEARTURN)
        )
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely
        self.V_BASE = start

    def cycle(self):
        self._time += self.dt
        self.V_BASE = self._drive.twist(self.P_MEZ, self.dt)
        if self._drive.is_there:
            return finish()
        if self._time >= self.MOST:
            raise ModuleError(
                "the base did not come to its place in {most:g} s: it is {away:.2f} m away from there",
                most=self.MOST,
                away=self._drive.away(self.P_MEZ),
            )
        return None

    def get(self, name):
        return self._drive.away(self.P_MEZ) if name == "away" else super().get(name)
