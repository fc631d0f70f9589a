"""A question of a task to its user: what it needs to know before it goes on."""

from typing import Any

from msgspec import Struct

from onika.words.reason import Reason


class Item(Struct, frozen=True):
    """One value or vector that is asked for."""

    name: str
    type: str
    count: int
    unit: str
    meaning: str
    default: tuple[Any, ...] | None
    low: tuple[float, ...] | None
    high: tuple[float, ...] | None


class Asked(Struct, frozen=True, tag=True):
    """A task waits for user input."""

    subsystem: str
    task: str
    reason: Reason
    items: tuple[Item, ...]
    at_s: float
