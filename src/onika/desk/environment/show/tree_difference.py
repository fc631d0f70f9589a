"""The difference of two trees as a patch: the places that changed, with what stands there now."""

from collections.abc import Iterator
from typing import Any

import msgspec
from msgspec import Struct

from onika.wire.page import Change
from onika.words.reason import Reason


def difference(before: Any, after: Any) -> list[Change]:
    """What turns `before` into `after`; values that are one object are not looked into."""
    return list(_walk((), before, after))


def _walk(path: tuple[str, ...], before: Any, after: Any) -> Iterator[Change]:
    if before is after:
        return
    is_parted = not isinstance(after, Reason)  # a sentence is replaced whole, never a word of it
    if is_parted and isinstance(after, Struct) and type(before) is type(after):
        for field in after.__struct_fields__:
            old, new = getattr(before, field), getattr(after, field)
            if old is not new:
                yield from _walk((*path, field), old, new)
    elif isinstance(after, dict) and isinstance(before, dict):
        yield from (((*path, key), None) for key in before if key not in after)
        for key, value in after.items():
            if key not in before:
                yield (*path, key), _plain(value)
            elif before[key] is not value:
                yield from _walk((*path, key), before[key], value)
    elif before != after:
        yield path, _plain(after)


def _plain(value: Any) -> Any:
    """As it travels; a list or struct that is to be nothing has been told apart by its key already."""
    return msgspec.to_builtins(value)
