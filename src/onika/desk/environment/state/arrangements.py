"""How the tasks of open libraries and the icons of open dictionaries are arranged, by their folders (D24)."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.state.model import Model
from onika.store.folder_arrangement import FolderArrangement
from onika.store.opened_text import Faults
from onika.store.site import Site
from onika.words.fault import Refusal

Arrangements = Mapping[str, tuple[str, ...]]


def with_arrangements(model: Model, site: Site) -> tuple[Model, Faults]:
    """With the arrangements as their files are now, and what is wrong with these; the same model if all is as was."""
    arrangements: dict[str, tuple[str, ...]] = {}
    faults: dict[str, Faults] = {}
    for folder in _folders(model):
        place = FolderArrangement.of(folder, site.own)
        if not isinstance(place, Refusal):
            names, faults_of_file = place.names()
            faults[str(place.file)] = faults_of_file
            if names:
                arrangements[str(folder)] = names
    wrong = tuple(fault for faults_of_file in faults.values() for fault in faults_of_file)
    return (model if arrangements == model.arrangements else replace(model, arrangements=arrangements)), wrong


def _folders(model: Model) -> list[Path]:
    libraries = [library.base.path / "module" for library in model.libraries.libraries]
    return [*libraries, *(dictionary.base.path / "dict" for dictionary in model.dictionaries)]
