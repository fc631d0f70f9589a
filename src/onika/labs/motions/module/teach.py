"""A path, taught by leading the arm."""

import os
from pathlib import Path

import numpy as np

from onika.laws.paths.taught_path import path_text
from onika.laws.signals.new_press import NewPress
from onika.module import InConst, Input, InVar, Local, Module, ModuleError, finish


class PathTeaching(Module):
    """Writes down where the arm is while somebody leads it, until a button is pressed; `jplay` plays it.

    Times count from `on`. The file is written whole when it ends, or not at all. A button that is pressed already at
    `on` counts once it was let go.

    Kind     trigger, periodic, 5..1000 Hz
    Ports    INCONST  NDOF     int           -    number of joints
             INVAR    Q_MEZ    double[NDOF]  rad  measured position
             INVAR    BUTTONS  int           -    not 0: it ends here
    Local    SETTLE            double        s    how long it has to be pressed: what is led comes to rest
             MOST              double        s    how long it takes at most
    Input    file              string        -    file that the path is written to
    Finish   flow 0, loop FALSE, when BUTTONS has not been 0 for SETTLE, or after MOST
    Errors   no place  the file cannot be written: ERROR
    Get/Set  rows, how many are kept / -
    Source   dissertation §4.4, §6.2.2.3
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    BUTTONS = InVar("int", "-", "not 0: it ends here")

    SETTLE = Local("double", "s", "how long it has to be pressed: what is led comes to rest", default=0.5, low=0.0)
    MOST = Local("double", "s", "how long it takes at most", default=600.0, low=0.1, high=86_400.0)

    file = Input("string", "-", "file that the path is written to")

    def on(self, inputs):
        self._file, self._time = inputs.file, 0.0
        self._press, self._pressed = NewPress(bool(self.BUTTONS)), 0.0
        self._times, self._rows = [0.0], [self.Q_MEZ.copy()]

    def cycle(self):
        self._time += self.dt
        self._times.append(self._time)
        self._rows.append(self.Q_MEZ.copy())
        is_pressed = self._press.is_there(bool(self.BUTTONS))
        self._pressed = self._pressed + self.dt if is_pressed else 0.0
        rests = self._pressed > max(self.SETTLE - self.dt / 2.0, 0.0)
        if not rests and self._time < self.MOST - self.dt / 2.0:
            return None
        self._write()
        return finish()

    def get(self, name):
        return len(self._rows) if name == "rows" else super().get(name)

    def _write(self):
        place = Path(self._file)
        beside = place.with_name(f".{place.name}.{os.getpid()}")
        try:
            beside.write_text(path_text(self._times, np.array(self._rows)), encoding="utf-8")
            beside.replace(place)
        except OSError as wrong:
            raise ModuleError("{file} cannot be written: {why}", file=self._file, why=wrong.strerror or "") from None
