"""Names that stand twice on a search path, told together: a copied folder repeats all (requirements B08, D15)."""

from collections.abc import Iterable
from pathlib import Path

from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_KEY = "store.name_twice"
_FEW = 3
"""Names that are told each by itself; where there are more, so many of them are named."""


def folded(faults: Iterable[Fault]) -> list[Fault]:
    """The same faults; in place of those of many names that a folder repeats of another one, a single one."""
    every = list(faults)
    repeated: dict[tuple[Path, object], list[Fault]] = {}
    for fault in every:
        if fault.reason.key == _KEY:
            repeated.setdefault(_folders(fault), []).append(fault)
    many = {folders: notes for folders, notes in repeated.items() if len(notes) > _FEW}
    kept: list[Fault] = []
    for fault in every:
        notes = many.get(_folders(fault), []) if fault.reason.key == _KEY else []
        if not notes:
            kept.append(fault)
        elif fault is notes[0]:
            kept.append(_together(notes))
    return kept


def _folders(fault: Fault) -> tuple[Path, object]:
    """The folder that repeats a name, and that in which it stands first."""
    return Path(fault.place.file).parent, fault.reason.args["path"]


def _together(notes: list[Fault]) -> Fault:
    folder, first = _folders(notes[0])
    names = tuple(str(note.reason.args["name"]) for note in notes[:_FEW])
    reason = Reason.of("store.names_twice", count=len(notes), path=str(first), names=names)
    return Fault(Place(str(folder)), reason, notes[0].instead, is_note=True)
