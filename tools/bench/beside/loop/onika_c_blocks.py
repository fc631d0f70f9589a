"""The loop in Onika with modules in C: each calls its function by ctypes, on the arrays of its ports."""

import onika
from beside.contestant import serve
from beside.loop.c_library import library
from beside.loop.onika_blocks import measured

MODULES = {
    "path": """
from ctypes import c_double, c_void_p
from beside.loop.c_library import function, place
from onika.module import Module, OutVar

class Path(Module):
    Q_REF = OutVar("double[6]", "rad", "where the joint shall be")

    def on(self, inputs):
        self._path, self._place = function("path", c_double, c_void_p), place(self.Q_REF)

    def cycle(self):
        self._path(self.now, self._place)
""",
    "rate": """
import numpy as np
from beside.loop.blocks import path
from beside.loop.c_library import function, place
from onika.module import InVar, Module, OutVar

class Rate(Module):
    Q_REF = InVar("double[6]", "rad", "where the joint shall be")
    QD_REF = OutVar("double[6]", "rad/s", "how fast", name="Q^_REF")

    def on(self, inputs):
        self._old = path(self.now)
        self._derivative = function("derivative")
        self._places = place(self.Q_REF), place(self._old), place(self.QD_REF)

    def cycle(self):
        self._derivative(*self._places)
""",
    "control": """
from beside.loop.c_library import function, place
from onika.module import InVar, Module, OutVar

class Control(Module):
    Q_REF = InVar("double[6]", "rad", "where the joint shall be")
    QD_REF = InVar("double[6]", "rad/s", "how fast", name="Q^_REF")
    Q_MEZ = InVar("double[6]", "rad", "where it is")
    QD_MEZ = InVar("double[6]", "rad/s", "how fast", name="Q^_MEZ")
    TAU_REF = OutVar("double[6]", "Nm", "what pushes it")

    def on(self, inputs):
        self._torque = function("torque")
        ports = (self.Q_REF, self.QD_REF, self.Q_MEZ, self.QD_MEZ, self.TAU_REF)
        self._places = tuple(map(place, ports))

    def cycle(self):
        self._torque(*self._places)
""",
    "joint": """
from beside.loop.c_library import function, place
from onika.module import InVar, Module, OutVar

class Joint(Module):
    TAU_REF = InVar("double[6]", "Nm", "what pushes it")
    Q_MEZ = OutVar("double[6]", "rad", "where it is")
    QD_MEZ = OutVar("double[6]", "rad/s", "how fast", name="Q^_MEZ")

    def on(self, inputs):
        self._moved = function("moved")
        self._places = place(self.TAU_REF), place(self.Q_MEZ), place(self.QD_MEZ)

    def cycle(self):
        self._moved(*self._places)
""",
}


def main() -> None:
    """The contestant."""
    library()  # where it cannot be made, that is told here
    serve(onika.__version__, measured(MODULES))


if __name__ == "__main__":
    main()
