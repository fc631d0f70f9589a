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

    def init(self):
        self._path, self._place = function("path", c_double, c_void_p), place(self.buffer("Q_REF"))

    def cycle(self):
        self._path(self.now, self._place)
""",
    "rate": """
from functools import partial
from beside.loop.blocks import path
from beside.loop.c_library import function, place
from onika.module import InVar, Module, OutVar

class Rate(Module):
    Q_REF = InVar("double[6]", "rad", "where the joint shall be")
    QD_REF = OutVar("double[6]", "rad/s", "how fast", name="Q^_REF")

    def init(self):
        self._old = path(self.now)
        places = map(place, (self.buffer("Q_REF"), self._old, self.buffer("QD_REF")))
        self.cycle = partial(function("derivative"), *places)

    def on(self, inputs):
        self._old[:] = path(self.now)
""",
    "control": """
from functools import partial
from beside.loop.c_library import function, place
from onika.module import InVar, Module, OutVar

class Control(Module):
    Q_REF = InVar("double[6]", "rad", "where the joint shall be")
    QD_REF = InVar("double[6]", "rad/s", "how fast", name="Q^_REF")
    Q_MEZ = InVar("double[6]", "rad", "where it is")
    QD_MEZ = InVar("double[6]", "rad/s", "how fast", name="Q^_MEZ")
    TAU_REF = OutVar("double[6]", "Nm", "what pushes it")

    def init(self):
        ports = map(self.buffer, ("Q_REF", "QD_REF", "Q_MEZ", "QD_MEZ", "TAU_REF"))
        self.cycle = partial(function("torque"), *map(place, ports))
""",
    "joint": """
from functools import partial
from beside.loop.c_library import function, place
from onika.module import InVar, Module, OutVar

class Joint(Module):
    TAU_REF = InVar("double[6]", "Nm", "what pushes it")
    Q_MEZ = OutVar("double[6]", "rad", "where it is")
    QD_MEZ = OutVar("double[6]", "rad/s", "how fast", name="Q^_MEZ")

    def init(self):
        ports = map(self.buffer, ("TAU_REF", "Q_MEZ", "QD_MEZ"))
        self.cycle = partial(function("moved"), *map(place, ports))
""",
}


def main() -> None:
    """The contestant."""
    library()  # where it cannot be made, that is told here
    serve(onika.__version__, measured(MODULES))


if __name__ == "__main__":
    main()
