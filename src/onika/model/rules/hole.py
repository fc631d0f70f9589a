"""What is missing at the holes of an application: targets of some type, or else an action (readings 32 and 33)."""

from collections.abc import Iterator
from dataclasses import dataclass

from onika.model.application import Action, Hole, wanted_targets
from onika.model.rules.outline import Outline, Passage
from onika.model.syntax import Syntax, same_type
from onika.words.fault import Fault
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class OpenHole:
    """A hole, and the types of the targets that are missing in it; none where an action is."""

    passage: Passage
    position: int
    types: tuple[str, ...]


def holes(outline: Outline, syntax: Syntax) -> Iterator[OpenHole]:
    """The holes of an application in order."""
    for passage in outline.passages:
        missing: dict[int, list[str]] = {}
        for action in passage.actions:
            wanted = wanted_targets(action.icon.onikon, syntax)
            for position, kind in zip(action.positions, wanted, strict=False):
                missing.setdefault(position, []).append(kind)
        for position, step in enumerate(passage.flow.steps):
            if isinstance(step, Hole):
                yield OpenHole(passage, position, tuple(missing.get(position, ())))


def open_types(outline: Outline, syntax: Syntax) -> tuple[str, ...]:
    """The types of the targets missing in all flows together, each once, in the order of their holes."""
    names: dict[str, str] = {}
    for hole in holes(outline, syntax):
        for kind in hole.types:
            names.setdefault(kind.lower(), kind)
    return tuple(names.values())


def faults(outline: Outline, syntax: Syntax) -> Iterator[Fault]:
    """Every hole of an application that is run by itself; of a nested one those that no target can fill."""
    for hole in holes(outline, syntax):
        step = hole.passage.flow.steps[hole.position]
        if not outline.is_nested:
            yield outline.fault(step, Reason.of("rules.hole_open", at=outline.at(hole.passage, hole.position)))
        elif not hole.types:
            yield outline.fault(step, Reason.of("rules.hole_for_action", at=outline.at(hole.passage, hole.position)))


def fillings(outline: Outline, inner: Outline, use: tuple[Passage, Action], syntax: Syntax) -> Iterator[Fault]:
    """Whether the targets of the action at `use` fill the holes of the application `inner` it runs (requirement D09).

    A target fills every hole of its type; one that fills none is noted.
    """
    passage, action = use
    wanted = wanted_targets(action.icon.onikon, syntax)
    missing = open_types(inner, syntax)
    at, name = outline.at(passage, action.position), inner.application.name
    for kind in missing:
        if not any(same_type(kind, type_name) for type_name in wanted):
            yield outline.fault(action.icon, Reason.of("rules.filling_missing", kind=kind, application=name, at=at))
    for number, kind in enumerate(wanted):
        if not any(same_type(kind, type_name) for type_name in missing):
            unused = Reason.of("rules.filling_unused", application=name, kind=kind, at=at)
            yield outline.note(action.icon, unused, Reason.of("rules.not_used"))
        elif any(same_type(kind, type_name) for type_name in wanted[:number]):
            twice = Reason.of("rules.filling_twice", application=name, kind=kind, at=at)
            yield outline.note(action.icon, twice, Reason.of("rules.first_fills"))
