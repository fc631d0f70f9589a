"""A port of a module: one state variable it reads or writes, and how (dissertation §4.2.2)."""

from enum import Enum

from msgspec import Struct

from onika.words.shape import Shape


class PortKind(Enum):
    """CONST is moved once, at initialisation; VAR at every cycle; BOTH is a first value, then every cycle."""

    INCONST = "INCONST"
    OUTCONST = "OUTCONST"
    INVAR = "INVAR"
    OUTVAR = "OUTVAR"
    INBOTH = "INBOTH"
    OUTBOTH = "OUTBOTH"

    @property
    def is_input(self) -> bool:
        """Whether the task reads the variable."""
        return self.value.startswith("IN")

    @property
    def at_init(self) -> bool:
        """Whether the variable is moved at initialisation."""
        return not self.value.endswith("VAR")

    @property
    def at_cycle(self) -> bool:
        """Whether the variable is moved at every cycle."""
        return not self.value.endswith("CONST")


class Port(Struct, frozen=True):
    """A port as its module's class declares it; `name` is the coded name, before aliases."""

    kind: PortKind
    name: str
    shape: Shape
    unit: str
    meaning: str
