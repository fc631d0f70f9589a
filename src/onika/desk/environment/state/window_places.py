"""Where the windows of §A.5 stand: a page shapes its panels after them, and keeps them as it is shaped (G01)."""

from collections.abc import Mapping
from dataclasses import asdict, fields
from typing import Any

from onika.model.preferences import Preferences, Window, WindowCorner
from onika.words.reason import Reason

_USUAL = Preferences()
_MOST = 20_000
"""Pixels: what is farther away is on no screen."""

WINDOWS = tuple(
    field.name for field in fields(Preferences) if isinstance(getattr(_USUAL, field.name), WindowCorner | Window)
)
"""The names of the preferences that are places."""


def chosen_places(preferences: Preferences) -> dict[str, dict[str, int]]:
    """The places that somebody has chosen, by window: those that are not as they are from the beginning."""
    return {
        name: asdict(getattr(preferences, name))
        for name in WINDOWS
        if getattr(preferences, name) != getattr(_USUAL, name)
    }


def places_of(values: Any) -> dict[str, Window | WindowCorner]:
    """Places by window, as a page says them; raises ValueError where they are none."""
    if not isinstance(values, Mapping):
        raise ValueError(Reason.of("run.places_form", windows=WINDOWS))
    return {str(name): _place(name, value) for name, value in values.items()}


def _place(name: Any, value: Any) -> Window | WindowCorner:
    if name not in WINDOWS:
        raise ValueError(Reason.of("run.places_form", windows=WINDOWS))
    kind: type[Window | WindowCorner] = type(getattr(_USUAL, name))
    names = tuple(field.name for field in fields(kind))
    if not isinstance(value, Mapping) or set(value) != set(names) or not all(map(_is_pixels, value.values())):
        raise ValueError(Reason.of("run.place_form", window=name, names=names, most=_MOST))
    return kind(**{part: int(value[part]) for part in names})


def _is_pixels(value: Any) -> bool:
    is_whole = isinstance(value, int) or (isinstance(value, float) and value.is_integer())
    return is_whole and not isinstance(value, bool) and 0 <= value <= _MOST
