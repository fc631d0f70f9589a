"""Where a base believes to be."""

from onika.laws.planar import advanced
from onika.module import InVar, Local, Module, OutVar


class Odometry(Module):
    """Where a base believes to be, by adding up how far its wheels went.

    x += dt (cos(turn) v - sin(turn) u), turn += dt w, along the arc of each period

    It begins at START and goes on where it was, whenever it is off and on again. Wheels that slip lead it astray.

    Kind     general, periodic, 20..1000 Hz
    Ports    INVAR   W_MEZ  double[3]  m/s,m/s,rad/s  speeds as its wheels or slides tell them
             OUTVAR  P_MEZ  double[3]  m,m,rad        where it believes to be: x, y and turn
    Local    START          double[3]  m,m,rad        where it stands at first
    Source   Borenstein, Everett & Feng, Where am I?, 1996, §1.1
    """

    W_MEZ = InVar("double[3]", "m/s,m/s,rad/s", "speeds as its wheels or slides tell them")
    P_MEZ = OutVar("double[3]", "m,m,rad", "where it believes to be: x, y and turn")

    START = Local("double[3]", "m,m,rad", "where it stands at first", default=(0.0, 0.0, 0.0))

    def init(self):
        self._place = self.START

    def take(self, old):
        self._place = old._place
        self.P_MEZ = self._place

    def on(self, inputs):
        self.P_MEZ = self._place

    def cycle(self):
        self._place = advanced(self._place, self.W_MEZ, self.dt)
        self.P_MEZ = self._place
