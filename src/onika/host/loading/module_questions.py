"""What is asked of module code before it lives: the questions, whoever answers them."""

from collections.abc import Iterable
from typing import Any, Protocol

from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault
from onika.words.reason import Reason


class ModuleQuestions(Protocol):
    """Where module code is executed to learn of it: a process of its own."""

    def sheet(self, code: Code) -> ModuleSheet | Fault:
        """The sheet of a module's class."""
        ...

    def cost_ns(self, code: Code) -> int:
        """How long the module takes to load; 0 where nothing is known of it."""
        ...

    def expect(self, codes: tuple[Code, ...]) -> None:
        """These modules will be asked about."""
        ...

    def constants(self, code: Code, local: tuple[tuple[str, tuple[str, ...]], ...]) -> dict[str, Any] | Fault:
        """A robot module's constants from its LOCAL lines; empty for any other."""
        ...

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files."""
        ...

    def world_faults(self, world: str) -> tuple[Fault, ...]:
        """All that is wrong with the files of a world, and left out for that; nothing where it is made of none."""
        ...

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        ...

    def is_simulated(self, world: str) -> bool | Fault:
        """Whether a world is simulated: nothing outside the program moves."""
        ...

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[Reason | None] | Fault:
        """Why each target is out of reach, or None."""
        ...

    def poses(
        self, code: Code, constants: dict[str, Any], targets: list[list[Any]]
    ) -> list[list[float]] | Fault | None:
        """The Cartesian targets that joint targets are for a robot module; None: it knows of no poses."""
        ...

    def postures(
        self, code: Code, constants: dict[str, Any], poses: list[list[float]]
    ) -> list[list[float] | Reason] | Fault | None:
        """Joint values for Cartesian targets, each nearest to those before it, or why there are none."""
        ...

    def fits(self, code: Code, constants: dict[str, Any], device: str) -> Reason | Fault:
        """Why a device is not the one that a hardware module means; NOTHING: nothing is wrong."""
        ...

    def company(self, world: str, devices: tuple[str, ...], *, is_of_flow: bool = False) -> tuple[Reason, ...] | Fault:
        """Why these devices of a world cannot be used together, or are odd in one flow; none: nothing is said."""
        ...
