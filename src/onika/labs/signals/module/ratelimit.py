"""A limit of speed."""

from onika.laws.signals.limited_rate import LimitedRate
from onika.module import InConst, InVar, Local, Module, OutVar


class Ratelimit(Module):
    """Follows joint positions, whatever they are called, no faster than FASTEST.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -      number of elements
             INVAR    Y     double[NDOF]  rad    what comes in
             OUTVAR   Z     double[NDOF]  rad    what follows it; preloaded at `on`, it goes on from there
             OUTVAR   Z^    double[NDOF]  rad/s  how fast that goes
    Local    FASTEST        double        rad/s  how fast each element may go
    Errors   no number  what is NaN or infinite is not followed
    """

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what comes in")
    Z = OutVar("double[NDOF]", "rad", "what follows it; preloaded at `on`, it goes on from there")
    Zd = OutVar("double[NDOF]", "rad/s", "how fast that goes", name="Z^")

    FASTEST = Local("double", "rad/s", "how fast each element may go", default=1.0, low=1e-6, high=1e6)

    def on(self, inputs):
        self._limited = LimitedRate(self.Z if self.continues("Z") else self.Y, self.FASTEST)
        self.Z = self._limited.value
        self.Zd = 0.0

    def cycle(self):
        self.Zd = self._limited.follow(self.Y, self.dt)
        self.Z = self._limited.value
