"""What an act was given beside the things that it is about: typed words, places, choices (requirement H01).

They are written on a line of their own behind that of the act, `enter_values`: their names, and all of them as JSON.
What is as it would be without a word is not told; a long text or a picture is told by its length and its digest.
"""

from collections.abc import Mapping, Sequence
from hashlib import sha256
from typing import Any

import msgspec

from onika.wire import act

_PLACES = frozenset({"t", "doc", "step", "steps", "after", "test", "anchor"})
"""Told by the ids of the act's line."""

_UNTOLD = frozenset({"token", "secret", "stamp", "user", "to"})
"""A secret, what only the page knows of a text that it has read, and who somebody is."""

_LONGEST = 200
"""Letters of a value that is written out."""


def given(command: act.AnyAct, columns: Sequence[str], naming: Sequence[str]) -> dict[str, Any]:
    """The values of an act by the names of its fields, but for those that `columns` of its line tell already.

    naming  the fields that name things
    """
    names_there = {name for column in columns for name in column.split(",")}
    fields: Mapping[str, Any] = msgspec.to_builtins(command)
    return {
        name: _bounded(value)
        for name, value in fields.items()
        if name not in _PLACES | _UNTOLD and not (name in naming and _is_among(value, names_there))
    }


def written(values: Mapping[str, Any]) -> str:
    """The values as JSON on one line."""
    return msgspec.json.encode(values).decode()


def _is_among(value: Any, names_there: set[str]) -> bool:
    names = [value] if isinstance(value, str) else value
    return isinstance(names, list | tuple) and all(isinstance(name, str) and name in names_there for name in names)


def _bounded(value: Any) -> Any:
    text = value if isinstance(value, str) else msgspec.json.encode(value).decode()
    if len(text) <= _LONGEST:
        return value
    return {"length": len(text), "sha256": sha256(text.encode()).hexdigest()[:16]}
