"""The configurations that could be opened (requirement C06)."""

from collections.abc import Iterable
from pathlib import Path

from onika.files import conf
from onika.store.base_directory import BaseDirectory
from onika.store.opened import Faults
from onika.wire.view import ConfigurationFile


def listed(bases: Iterable[BaseDirectory]) -> tuple[dict[str, ConfigurationFile], Faults]:
    """Every configuration of these base directories by the path of its file; one that is at fault has no tasks."""
    found: dict[str, ConfigurationFile] = {}
    faults: list[Faults] = []
    for base in bases:
        for name in base.configurations:
            file, wrong = entry(base, name)
            found[file.path] = file
            faults.append(wrong)
    return found, tuple(fault for some in faults for fault in some)


def entry(base: BaseDirectory, name: str) -> tuple[ConfigurationFile, Faults]:
    """One configuration of a base directory."""
    configuration, faults = base.configuration(name)
    tasks = len(configuration.placed) if configuration else 0
    return ConfigurationFile(name, str(base.path), str(base.configuration_file(name)), tasks), faults


def is_configuration(path: Path) -> bool:
    """Whether a path is one where a base directory has its configurations."""
    return path.suffix == conf.ENDING and path.parent.name == "conf"
