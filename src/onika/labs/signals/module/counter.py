"""A counter of events."""

from onika.module import Input, InVar, Module, OutVar, finish


class Counter(Module):
    """Waits until something has happened so many times: each rise of EVENT from 0 counts once.

    What is already there at `on` does not count.

    Kind     trigger, periodic, 1..1000 Hz
    Ports    INVAR   EVENT  int  -  not 0 while it happens
             OUTVAR  COUNT  int  -  how often it has happened since `on`
    Input    count          int  -  1..1e+06
    Finish   flow 0, loop FALSE, as soon as it has happened count times
    Get/Set  left, how often it has still to happen / -
    """

    trigger = True

    EVENT = InVar("int", "-", "not 0 while it happens")
    COUNT = OutVar("int", "-", "how often it has happened since `on`")

    count = Input("int", "-", "how often", low=1, high=1_000_000)

    def on(self, inputs):
        self._wanted, self._was = int(inputs.count), bool(self.EVENT)
        self.COUNT = 0

    def cycle(self):
        is_there = bool(self.EVENT)
        count = self.COUNT + int(is_there and not self._was)
        self.COUNT = count
        self._was = is_there
        return finish() if count >= self._wanted else None

    def get(self, name):
        if name == "left":
            return self._wanted - self.COUNT
        return super().get(name)
