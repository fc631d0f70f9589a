"""A choice by what is measured."""

from onika.module import InConst, Input, InVar, Local, Module, ModuleError, finish


class Compare(Module):
    """Whether an element of a measured vector is above a level, for conditional applications and loops.

    Kind     trigger, periodic, 1..1000 Hz
    Ports    INCONST  NDOF   int           -    number of elements
             INVAR    Y      double[NDOF]  rad  what is measured
    Local    ELEMENT         int           -    which element, from 1
    Input    level           double        rad  any
    Finish   flow 1, loop TRUE where the element is above the level, else flow 0, loop FALSE
    Errors   no such element  ELEMENT is not within 1..NDOF: stays uninitialised
    Source   dissertation §4.4.7.2, §4.4.7.3
    """

    trigger = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is measured")

    ELEMENT = Local("int", "-", "which element, from 1", default=1)

    level = Input("double", "rad", "above which flow 1 is taken")

    def init(self):
        if not 1 <= self.ELEMENT <= self.NDOF:
            raise ModuleError(f"expected ELEMENT from 1 to {self.NDOF}, found {self.ELEMENT}")

    def on(self, inputs):
        self._level = inputs.level

    def cycle(self):
        is_above = bool(self.Y[self.ELEMENT - 1] > self._level)
        return finish(flow=int(is_above), loop=is_above)
