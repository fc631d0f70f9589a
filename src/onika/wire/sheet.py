"""The sheet of a module's class: what it declares, as plain data that travels (law 24)."""

from typing import Any

from msgspec import Struct


class PortSheet(Struct, frozen=True):
    """A declared port; `shape` as text."""

    kind: str
    name: str
    shape: str
    unit: str
    meaning: str


class InputSheet(Struct, frozen=True):
    """Declared user input; bounds are numbers or names of INCONSTs."""

    name: str
    shape: str
    unit: str
    meaning: str
    low: float | str | None
    high: float | str | None
    default: Any


class LocalSheet(Struct, frozen=True):
    """A declared parameter of the LOCAL block; without a default the line must be there."""

    name: str
    shape: str
    unit: str
    meaning: str
    default: Any
    low: float | None = None
    high: float | None = None


class ModuleSheet(Struct, frozen=True):
    """All that is known of a module without running it."""

    ports: tuple[PortSheet, ...]
    inputs: tuple[InputSheet, ...]
    locals: tuple[LocalSheet, ...]
    trigger: bool
    passive: bool
    hardware: bool
    crit: int
    doc: str
