"""A measured vector that is never written again."""

from onika.laws.finite import FiniteValues
from onika.laws.onset import Onset
from onika.module import InConst, InVar, Local, Module, OutVar, off


class LostLink(Module):
    """A fault to try: the link to what is measured is lost, and nothing is written any more.

    The task goes off by itself. Its readers go on with what stood there last, unless one of them notices.

    Kind     passive, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what is measured
             OUTVAR   Z     double[NDOF]  rad  what its readers get; always finite
    Local    AFTER  double  s  when it begins, counted from `on`
    Errors   no number  what is NaN or infinite leaves the number before
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")
    Z = OutVar("double[NDOF]", "rad", "what its readers get; always finite")

    AFTER = Local("double", "s", "when it begins, counted from `on`", default=1.0, low=0.0, high=3600.0)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._sound.take(self.Z)
        self._onset = Onset(self.AFTER)
        self.Z = self._sound.take(self.Y)

    def cycle(self):
        if self._onset.has_come(self.dt):
            return off()
        self.Z = self._sound.take(self.Y)
        return None
