"""A choice by a number."""

import math
from bisect import bisect_right
from itertools import pairwise

from onika.module import InVar, Local, Module, ModuleError, finish


class Sorter(Module):
    """Takes a flow by a number: flow 0 below the first bound, flow 1 from there to the second, and so on.

    Kind     trigger, periodic, 1..1000 Hz
    Ports    INVAR  SIGNAL  double  -  by what is chosen
    Local    BOUNDS         line    -  numbers that rise, parted by blanks: where one flow ends and the next begins
    Finish   flow k, where k of the bounds are not above the number; loop TRUE for flow 0; at its first cycle
    Errors   no bounds  BOUNDS are no numbers that rise: stays uninitialised
             no number  SIGNAL is NaN: ERROR
    Source   dissertation §4.4.7.2
    """

    trigger = True

    SIGNAL = InVar("double", "-", "by what is chosen")

    BOUNDS = Local(
        "line", "-", "numbers that rise, parted by blanks: where one flow ends and the next begins", default="0"
    )

    def init(self):
        try:
            self._bounds = [float(word) for word in self.BOUNDS.split()]
        except ValueError:
            self._bounds = []
        if not self._bounds or not all(low < high for low, high in pairwise(self._bounds)):
            raise ModuleError("BOUNDS: expected numbers that rise, found {found}", found=self.BOUNDS)

    def cycle(self):
        number = self.SIGNAL
        if math.isnan(number):
            raise ModuleError("expected a number to choose by, found none")
        flow = bisect_right(self._bounds, number)
        return finish(flow=flow, loop=flow == 0)
