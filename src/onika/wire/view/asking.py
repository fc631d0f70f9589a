"""What a task asks, and why it is in ERROR, as a page shows it."""

from typing import Any

from msgspec import field

from onika.wire.view.view import Remedy, View
from onika.words.reason import NOTHING, Reason


class AskItem(View, frozen=True):
    """One value or vector that a task asks for."""

    name: str
    type: str
    count: int
    unit: str
    meaning: str
    default: tuple[Any, ...] | None = None
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None


class AskView(View, frozen=True):
    """What a task waits to be told before it comes on."""

    items: tuple[AskItem, ...]
    reason: Reason = NOTHING
    """Why it asks again."""
    present: dict[str, tuple[float, ...]] = field(default_factory=dict)
    """What "take the present position" would fill in, by item."""


class ErrorView(View, frozen=True):
    """Why a task is in ERROR, and the ways out."""

    text: Reason
    entry: str = ""
    path: str = ""
    line: int = 0
    traceback: str = ""
    at_s: float = 0.0
    values: dict[str, Any] = field(default_factory=dict)
    remedies: tuple[Remedy, ...] = ()
