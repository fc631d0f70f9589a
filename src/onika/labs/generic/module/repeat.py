"""The counter of loops."""

from onika.module import Input, Module, finish


class Repeat(Module):
    """Counts how often its job is done, for loops that are gone through so many times.

    Each number counts apart, so that loops within each other may use this job with different numbers. At the end of a
    loop (bottom test) the loop is gone through `count` times, at its beginning (top test) once less.

    Kind     trigger, periodic, 1..1000 Hz
    Input    count  int  -  1..1000000
    Finish   flow 0, loop TRUE until it was done count times, then loop FALSE, and it begins anew
    Get/Set  done, how often since it began / done: go on from there, 0 begins anew; both of the number used last
    Source   dissertation §4.4.7.3, §5.5.4
    """

    trigger = True

    count = Input("int", "-", "how often", low=1, high=1_000_000)

    def init(self):
        self._done = {}
        self._count = 0

    def on(self, inputs):
        self._count = int(inputs.count)

    def cycle(self):
        done = self._done.get(self._count, 0) + 1
        goes_on = done < self._count
        self._done[self._count] = done if goes_on else 0
        return finish(loop=goes_on)

    def get(self, name):
        if name == "done":
            return self._done.get(self._count, 0)
        return super().get(name)

    def set(self, name, value):
        if name != "done":
            super().set(name, value)
        else:
            self._done[self._count] = int(value)
