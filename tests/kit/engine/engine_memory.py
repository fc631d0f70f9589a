"""The memory of an engine: everything that may change in it, taken out, put back and compared."""

from collections import Counter, deque
from collections.abc import Iterator
from enum import Enum
from types import FunctionType
from typing import Any

from onika.engine.engine import Engine
from onika.engine.meeting import Meetings
from onika.engine.program import FlowProgram
from onika.engine.step import ActionStep

_FIXED = {"revision", "_ranks", "_places", "_names", "_parties", "_steps", "_spawn_order", "_passive", "program"}
"""What never changes, or only counts."""

Memory = list[dict[str, Any]]


class EngineMemory:
    """Looks at every object of an engine, without knowing what they are for; so it forgets nothing that is added."""

    def __init__(self, engine: Engine) -> None:
        self._parts = list(_parts(engine))
        identities = {id(part) for part in self._parts}
        self._names = [
            [name for name, value in vars(part).items() if name not in _FIXED and not _is_fixed(value, identities)]
            for part in self._parts
        ]

    def take(self) -> Memory:
        """A copy of everything."""
        return [
            {name: _copied(vars(part)[name]) for name in names}
            for part, names in zip(self._parts, self._names, strict=True)
        ]

    def put_back(self, memory: Memory) -> None:
        """As it was when that was taken."""
        for part, values in zip(self._parts, memory, strict=True):
            vars(part).update({name: _copied(value) for name, value in values.items()})

    def key(self) -> tuple[Any, ...]:
        """Equal for engines that will do the same: meetings are counted from the last one on."""
        return tuple(
            _visits(part) if name == "_visits" else _frozen(vars(part)[name])
            for part, names in zip(self._parts, self._names, strict=True)
            for name in names
        )


def _parts(engine: Engine) -> Iterator[Any]:
    ahead: list[Any] = [engine]
    seen: set[int] = set()
    while ahead:
        value = ahead.pop()
        if id(value) in seen:
            continue
        seen.add(id(value))
        if isinstance(value, list | tuple):
            ahead += value
        elif _is_part(value):
            yield value
            ahead += vars(value).values()


def _is_part(value: Any) -> bool:
    is_known = type(value).__module__.startswith("onika.engine") and hasattr(value, "__dict__")
    return is_known and not isinstance(value, FlowProgram | Enum)


def _is_fixed(value: Any, parts: set[int]) -> bool:
    if isinstance(value, list | tuple) and value and id(value[0]) in parts:
        return True
    return id(value) in parts or isinstance(value, FunctionType | FlowProgram)


def _copied(value: Any) -> Any:
    if isinstance(value, Counter):
        return Counter(value)
    if isinstance(value, dict):
        return {key: _copied(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_copied(item) for item in value]
    if isinstance(value, deque):
        return deque(value, value.maxlen)
    return set(value) if isinstance(value, set) else value


def _frozen(value: Any) -> Any:
    if isinstance(value, dict):
        return tuple((key, _frozen(item)) for key, item in value.items())
    if isinstance(value, list | deque):
        return tuple(map(_frozen, value))
    if isinstance(value, ActionStep):
        return id(value)
    return frozenset(value) if isinstance(value, set) else value


def _visits(meetings: Meetings) -> tuple[Any, ...]:
    """How many visits each flow is ahead of the last one, for each tag."""
    parties, visits = meetings._parties, meetings._visits
    return tuple(
        (tag, tuple(visits[flow][tag] - min(visits[party][tag] for party in flows) for flow in flows))
        for tag, flows in parties.items()
    )
