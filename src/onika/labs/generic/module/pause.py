"""A pause."""

from onika.module import Input, Module, finish


class Pause(Module):
    """Waits. The drives of the arms hold by themselves meanwhile.

    Kind     trigger, periodic, 1..1000 Hz
    Input    duration  double  s  0..86400
    Finish   flow 0, loop FALSE, when the time is over, at its first cycle at the earliest
    Get/Set  left, in s / -
    Source   dissertation §4.4.6.1
    """

    trigger = True

    duration = Input("double", "s", "how long it takes", low=0.0, high=86_400.0)

    def on(self, inputs):
        self._duration = inputs.duration
        self._time = 0.5 * self.dt  # sums of periods are not exact: half a period decides safely

    def cycle(self):
        self._time += self.dt
        return finish() if self._time >= self._duration else None

    def get(self, name):
        if name == "left":
            return max(self._duration - self._time, 0.0)
        return super().get(name)
