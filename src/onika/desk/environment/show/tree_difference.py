"""The difference of two trees as a patch: the places that changed, with what stands there now.

What is the default of its field travels as nothing, as it does in a snapshot, which leaves out what is that very value:
a page that watched holds what a new one holds.
"""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import msgspec
from msgspec import NODEFAULT, Struct, structs

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
        yield from _fields(path, before, after)
    elif isinstance(after, dict) and isinstance(before, dict):
        yield from (((*path, key), None) for key in before if key not in after)
        for key, value in after.items():
            if key not in before:
                yield (*path, key), _plain(value)
            elif before[key] is not value:
                yield from _walk((*path, key), before[key], value)
    elif before != after:
        yield path, _plain(after)


def _fields(path: tuple[str, ...], before: Struct, after: Struct) -> Iterator[Change]:
    """The same of two structs of one type, field by field."""
    defaults = _defaults(type(after))
    for field in after.__struct_fields__:
        default = defaults.get(field, NODEFAULT)
        old, new = getattr(before, field), getattr(after, field)
        if old is new:
            continue
        if new is default:
            yield (*path, field), None
        elif old is default:
            yield (*path, field), _plain(new)
        else:
            yield from _walk((*path, field), old, new)


@cache
def _defaults(kind: type[Struct]) -> Mapping[str, Any]:
    """By field, what it is when nothing is said; those of maps and structs, whose parts travel alone, are left out."""
    fields = ((field.name, field.default) for field in structs.fields(kind))
    return {name: default for name, default in fields if isinstance(default, Reason) or not isinstance(default, Struct)}


def _plain(value: Any) -> Any:
    """As it travels; a list or struct that is to be nothing has been told apart by its key already."""
    return msgspec.to_builtins(value)
