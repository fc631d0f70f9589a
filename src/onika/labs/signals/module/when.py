"""A wait for a level."""

from onika.module import Input, InVar, Local, Module, ModuleError, finish

SIDES = ("above", "below")


class When(Module):
    """Waits until a number is above a level, or below it, and gives up after a while.

    Kind     trigger, periodic, 1..1000 Hz
    Ports    INVAR  SIGNAL  double  -  what is waited for
    Local    SIDE           string  -  above or below: on which side of the level it is to be
             PATIENCE       double  s  how long is waited
    Input    level          double  -  -1e+09..1e+09
    Finish   flow 1, loop FALSE as soon as it is there; flow 0, loop TRUE after PATIENCE
    Errors   no side  SIDE is neither above nor below: stays uninitialised
    Source   dissertation §4.4.7.2, §4.4.7.3
    """

    trigger = True

    SIGNAL = InVar("double", "-", "what is waited for")

    SIDE = Local("string", "-", "above or below: on which side of the level it is to be", default="above")
    PATIENCE = Local("double", "s", "how long is waited", default=10.0, low=0.0, high=86_400.0)

    level = Input("double", "-", "what it is compared with", low=-1e9, high=1e9)

    def init(self):
        if self.SIDE not in SIDES:
            raise ModuleError("SIDE: expected above or below, found {found}", found=self.SIDE)

    def on(self, inputs):
        self._level, self._sign = inputs.level, 1.0 if self.SIDE == "above" else -1.0
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely

    def cycle(self):
        self._time += self.dt
        beyond = self._sign * (self.SIGNAL - self._level)
        if beyond > 0.0:
            return finish(flow=1)
        return finish(loop=True) if self._time >= self.PATIENCE else None
