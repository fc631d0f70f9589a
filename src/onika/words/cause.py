"""Faults by their causes: what follows from another fault stands behind that, not beside it (requirement B07)."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class FaultGroup:
    """A fault that follows from no other one that is there, and those that follow from it."""

    fault: Fault
    consequences: tuple[Fault, ...] = ()


def by_cause(faults: Iterable[Fault]) -> tuple[FaultGroup, ...]:
    """Each fault once, as a cause or behind its first one; causes that have consequences come first, else as given."""
    every = tuple(dict.fromkeys(faults))
    at: dict[Place, list[Fault]] = {}
    for fault in every:
        at.setdefault(fault.place, []).append(fault)
    behind: dict[Fault, list[Fault]] = {}
    for fault in every:
        first = _first(fault, at)
        following = behind.setdefault(first, [])
        following += [fault] if first != fault else []
    causes = [FaultGroup(fault, tuple(following)) for fault, following in behind.items()]
    return tuple(sorted(causes, key=lambda cause: not cause.consequences))


def causes_first(faults: Iterable[Fault]) -> list[Fault]:
    """The same faults, each behind what it follows from."""
    return [fault for cause in by_cause(faults) for fault in (cause.fault, *cause.consequences)]


def _first(fault: Fault, at: Mapping[Place, list[Fault]]) -> Fault:
    """That from which a fault follows in the end: itself, where nothing of that is there; of a circle its first."""
    path = [fault]
    while True:
        earlier = [cause for place in path[-1].because for cause in at.get(place, ()) if cause != path[-1]]
        cause = next((cause for cause in earlier if cause not in path), None)
        if cause is None:
            circle = path[path.index(earlier[0]) :] if earlier else path[-1:]
            return min(circle)
        path.append(cause)
