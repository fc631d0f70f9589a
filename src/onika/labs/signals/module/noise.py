"""A measured vector with noise."""

from onika.laws.finite import FiniteValues
from onika.laws.onset import Onset
from onika.module import InConst, InVar, Local, Module, OutVar


class Noise(Module):
    """A fault to try: what is measured is noisy, every element by itself.

    Normally distributed, without memory. The numbers follow the seed of the run: the same run is as noisy again.

    Kind     passive, periodic, 20..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what is measured
             OUTVAR   Z     double[NDOF]  rad  what its readers get; always finite
    Local    SIGMA  double  rad  standard deviation of the noise
             AFTER  double  s    when it begins, counted from `on`
    Errors   no number  what is NaN or infinite leaves the number before
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")
    Z = OutVar("double[NDOF]", "rad", "what its readers get; always finite")

    SIGMA = Local("double", "rad", "standard deviation of the noise", default=0.01, low=0.0, high=10.0)
    AFTER = Local("double", "s", "when it begins, counted from `on`", default=1.0, low=0.0, high=3600.0)

    def on(self, inputs):
        self._sound = FiniteValues(self.NDOF)
        self._sound.take(self.Z)
        self._onset = Onset(self.AFTER)
        self.Z = self._sound.take(self.Y)

    def cycle(self):
        self.Z = self._sound.take(self.Y)
        if self._onset.has_come(self.dt):
            self.Z += [self.random.gauss(0.0, self.SIGMA) for _ in range(self.NDOF)]
