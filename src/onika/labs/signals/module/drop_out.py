"""A measured vector of which some are lost."""

from onika.laws.finite import FiniteValues
from onika.laws.onset import Onset
from onika.module import InConst, InVar, Local, Module, OutVar


class DropOut(Module):
    """A fault to try: now and then nothing is measured for a while, and what was measured before stands.

    When, is drawn from the seed of the run: the same run loses the same again.

    Kind     passive, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what is measured
             OUTVAR   Z     double[NDOF]  rad  what its readers get; always finite
    Local    SHARE  double  -  share of the cycles at which values begin to be lost
             LASTS  double  s  how long they are lost then, a cycle at least
             AFTER  double  s  when it begins, counted from `on`
    Errors   no number  what is NaN or infinite leaves the number before
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")
    Z = OutVar("double[NDOF]", "rad", "what its readers get; always finite")

    SHARE = Local(
        "double", "-", "share of the cycles at which values begin to be lost", default=0.02, low=0.0, high=1.0
    )
    LASTS = Local("double", "s", "how long they are lost then, a cycle at least", default=0.05, low=0.0, high=600.0)
    AFTER = Local("double", "s", "when it begins, counted from `on`", default=1.0, low=0.0, high=3600.0)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._sound.take(self.Z)
        self._onset, self._lost = Onset(self.AFTER), 0
        self.Z = self._sound.take(self.Y)

    def cycle(self):
        is_faulty = self._onset.has_come(self.dt)
        if is_faulty and self._lost == 0 and self.random.random() < self.SHARE:
            self._lost = max(round(self.LASTS / self.dt), 1)
        if self._lost > 0:
            self._lost -= 1
            return
        self.Z = self._sound.take(self.Y)
