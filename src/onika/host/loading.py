"""What is learnt of module code by executing it: sheets, constants, reach. Called in the loader's process only."""

from time import perf_counter_ns
from typing import Any

import numpy as np

from onika.host.worlds import open_world
from onika.runtime.binding import locals_of
from onika.runtime.code import line_in, load, told
from onika.runtime.sheet import sheet_of
from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place

Lines = tuple[tuple[str, tuple[str, ...]], ...]


class DirectLoading:
    """Executes module code in this process."""

    def sheet(self, code: Code) -> ModuleSheet | Fault:
        """The sheet of a module's class."""
        cls = load(code.source, code.path, code.module)
        if isinstance(cls, Fault):
            return cls
        try:
            return sheet_of(cls)
        except ValueError as wrong:
            return self._fault(code, "declarations that agree", wrong)

    def cost_ns(self, code: Code) -> int:
        """How long the module takes to load once more, when its libraries are there; the quickest of three times."""
        times = []
        for _ in range(3):
            began = perf_counter_ns()
            load(code.source, code.path, code.module)
            times.append(perf_counter_ns() - began)
        return min(times)

    def expect(self, codes: tuple[Code, ...]) -> None:
        """Answers are made at once, nothing is prepared."""

    def constants(self, code: Code, local: Lines) -> dict[str, Any] | Fault:
        """A robot module's constants from its LOCAL lines, as plain lists and numbers."""
        cls = load(code.source, code.path, code.module)
        if isinstance(cls, Fault):
            return cls
        try:
            found = cls.constants(locals_of(cls, dict(local)))
            return {name: _plain(value) for name, value in found.items()}
        except Exception as wrong:
            return self._fault(code, "constants from the LOCAL lines", wrong)

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        try:
            return tuple(sheet.name for sheet in open_world(world).devices())
        except Exception as wrong:
            return Fault(Place(world), str(wrong), world, "no device of it is used")

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[str | None] | Fault:
        """Why each target is out of reach, or None."""
        cls = load(code.source, code.path, code.module)
        if isinstance(cls, Fault):
            return cls
        try:
            return list(cls.resolve(constants, list(targets)))
        except Exception as wrong:
            return self._fault(code, "an answer about the reach of targets", wrong)

    def _fault(self, code: Code, expected: str, wrong: Exception) -> Fault:
        place = Place(code.path, line_in(code.path, wrong))
        return Fault(place, expected, told(wrong), f"module {code.module} is not used")


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(one) for one in value]
    return value
