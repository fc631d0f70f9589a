"""What is asked of module code before it lives: the questions, whoever answers them."""

from typing import Any, Protocol

from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault


class Loading(Protocol):
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

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        ...

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[str | None] | Fault:
        """Why each target is out of reach, or None."""
        ...
