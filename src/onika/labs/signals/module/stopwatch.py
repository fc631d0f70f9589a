"""A stopwatch for events."""

from onika.module import InVar, Module, OutVar


class Stopwatch(Module):
    """How long the last event took, and how long after the one before it began; to the cycle.

    An event lasts from the cycle in which EVENT is not 0 any more than before to that in which it is 0 again.

    Kind     general, periodic, 1..1000 Hz
    Ports    INVAR   EVENT   int     -  not 0 while it happens
             OUTVAR  LASTED  double  s  how long the last event took; 0 before the end of the first
             OUTVAR  APART   double  s  from the beginning of the last but one to that of the last; 0 before
    Errors   late  what goes on already at `on` is not timed
    """

    EVENT = InVar("int", "-", "not 0 while it happens")
    LASTED = OutVar("double", "s", "how long the last event took; 0 before the end of the first")
    APART = OutVar("double", "s", "from the beginning of the last but one to that of the last; 0 before")

    def on(self, inputs):
        self._was = bool(self.EVENT)
        self._cycles, self._began = 0, None  # of what goes on already at `on` nobody knows when it began
        self.LASTED = self.APART = 0.0

    def cycle(self):
        self._cycles += 1
        is_there = bool(self.EVENT)
        if is_there and not self._was:
            if self._began is not None:
                self.APART = (self._cycles - self._began) * self.dt
            self._began = self._cycles
        elif self._was and not is_there and self._began is not None:
            self.LASTED = (self._cycles - self._began) * self.dt
        self._was = is_there
