"""A choice by the lamp."""

from onika.module import InVar, Local, Module, finish


class LampLit(Module):
    """Whether the lamp is lit, for conditional applications and for loops that go on while it is dark.

    Kind     trigger, periodic, 10..1000 Hz
    Ports    INVAR    LAMP  int     -  1 while the lamp is lit, else 0
    Local    LOOK           double  s  how long is looked: whoever watches the lamp needs time to be sure
    Finish   flow 1, loop FALSE as soon as it is lit; flow 0, loop TRUE where it is dark after LOOK
    Source   dissertation §4.4.7.2, §4.4.7.3, §6.2.3
    """

    trigger = True

    LAMP = InVar("int", "-", "1 while the lamp is lit, else 0")

    LOOK = Local("double", "s", "how long is looked: whoever watches the lamp needs time to be sure", default=0.4)

    def on(self, inputs):
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely

    def cycle(self):
        self._time += self.dt
        if self.LAMP:
            return finish(flow=1)
        if self._time >= self.LOOK:
            return finish(loop=True)
        return None
