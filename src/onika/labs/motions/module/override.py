"""A motion at a share of its speed."""

from onika.laws.signals.slowed_course import SlowedCourse
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class Override(Module):
    """Passes joint references on at a share of their time: the same path, as slowly as somebody wants, or at rest.

    The share is told while it runs (`share`), and changes evenly. What is not passed on yet is kept; where that is more
    than KEPT the motion goes on as fast as it comes. Who waits for the arm to arrive has to wait longer.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -      number of elements
             INVAR    Y     double[NDOF]  rad    references that come in
             OUTVAR   Z     double[NDOF]  rad    what they are at a share of their time; preloaded, it begins there
             OUTVAR   Z^    double[NDOF]  rad/s  how fast that goes
    Local    SHARE          double        -      share of their time at first, 0..1
             EASE           double        1/s    how fast the share may change
             KEPT           double        s      how much is kept at most
    Get/Set  share, behind in s / share
    Errors   no number      what is NaN or infinite is not followed
    Source   dissertation §4.4
    """

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "references that come in")
    Z = OutVar("double[NDOF]", "rad", "what they are at a share of their time; preloaded, it begins there")
    Zd = OutVar("double[NDOF]", "rad/s", "how fast that goes", name="Z^")

    SHARE = Local("double", "-", "share of their time at first, 0..1", default=1.0, low=0.0, high=1.0)
    EASE = Local("double", "1/s", "how fast the share may change", default=4.0, low=0.1, high=1e3)
    KEPT = Local("double", "s", "how much is kept at most", default=120.0, low=0.1, high=600.0)

    def init(self):
        self._share = self.SHARE

    def on(self, inputs):
        start = self.Z if self.continues("Z") else self.Y
        self._course = SlowedCourse(start, round(self.KEPT / self.dt), self.EASE)
        self.Z = self._course.value
        self.Zd = 0.0

    def cycle(self):
        self.Zd = self._course.follow(self.Y, self._share, self.dt)
        self.Z = self._course.value

    def get(self, name):
        if name == "share":
            return self._share
        return self._course.behind * self.dt if name == "behind" else super().get(name)

    def set(self, name, value):
        if name != "share":
            super().set(name, value)
            return
        share = float(value)
        if not 0.0 <= share <= 1.0:
            raise ModuleError("expected a share of 0 to 1, found {value}", value=value)
        self._share = share
