"""The configurations and applications that could be opened, with what icons need to know of them (C06, D01)."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.desk.environment.state.model import Model
from onika.files import appl, conf
from onika.model.application import Icon, every_flow
from onika.model.configuration import Configuration
from onika.model.rules.iconify import ActionType, application_type
from onika.model.syntax import Syntax
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults
from onika.wire.view import ApplicationFile, ConfigurationFile
from onika.words.fault import Refusal

Source = Configuration | ActionType | tuple[Refusal, ...] | None
"""A configuration, the type that an application has as an icon or why it has none; None: its file is at fault."""


@dataclass(frozen=True, slots=True)
class FileIndex:
    """Files by their paths; one that is at fault is listed with nothing in it."""

    files: Mapping[str, ConfigurationFile] = field(default_factory=dict)
    applications: Mapping[str, ApplicationFile] = field(default_factory=dict)
    sources: Mapping[str, Source] = field(default_factory=dict)
    faults: Faults = ()

    def beside(self, model: Model) -> Model:
        """The model with these files beside the others; the same one where nothing is new."""
        return _with(
            model,
            {**model.files, **self.files},
            {**model.application_files, **self.applications},
            {**model.sources, **self.sources},
        )

    def and_(self, other: "FileIndex") -> "FileIndex":
        """These files and others."""
        return FileIndex(
            {**self.files, **other.files},
            {**self.applications, **other.applications},
            {**self.sources, **other.sources},
            (*self.faults, *other.faults),
        )


def listed(bases: Iterable[BaseDirectory], syntax: Syntax | None) -> FileIndex:
    """Every configuration and application of these base directories."""
    listed = FileIndex()
    for base in bases:
        for name in base.configurations:
            listed = listed.and_(configuration(base, name))
        for name in base.applications:
            listed = listed.and_(application(base, name, syntax))
    return listed


def configuration(base: BaseDirectory, name: str) -> FileIndex:
    """One configuration of a base directory."""
    path = str(base.configuration_file(name))
    read, faults = base.configuration(name)
    file = ConfigurationFile(name, str(base.path), path, len(read.placed) if read else 0)
    return FileIndex({path: file}, sources={path: read}, faults=faults)


def application(base: BaseDirectory, name: str, syntax: Syntax | None) -> FileIndex:
    """One application of a base directory."""
    path = str(base.application_file(name))
    read, faults = base.application(name, syntax) if syntax else (None, ())
    if read is None or syntax is None:
        file = ApplicationFile(name, str(base.path), path)
        return FileIndex(applications={path: file}, sources={path: None}, faults=faults)
    steps = (step for _, flow in every_flow(read) for step in flow.steps)
    file = ApplicationFile(name, str(base.path), path, len(read.flows), sum(isinstance(step, Icon) for step in steps))
    return FileIndex(applications={path: file}, sources={path: application_type(read, syntax)}, faults=faults)


def without(model: Model, paths: Iterable[str]) -> Model:
    """The model without the files of these paths."""
    gone = frozenset(paths)
    files = {path: file for path, file in model.files.items() if path not in gone}
    applications = {
        path: application_file for path, application_file in model.application_files.items() if path not in gone
    }
    return _with(
        model, files, applications, {path: source for path, source in model.sources.items() if path not in gone}
    )


def of_base(model: Model, base: str) -> tuple[str, ...]:
    """The paths of what is listed of a base directory."""
    configurations = (file.path for file in model.files.values() if file.base == base)
    return (
        *configurations,
        *(
            application_file.path
            for application_file in model.application_files.values()
            if application_file.base == base
        ),
    )


def again(path: Path, syntax: Syntax | None) -> FileIndex | None:
    """A file of a base directory as it is now; None where there is none of that path any more."""
    base = BaseDirectory(path.parent.parent)
    if is_configuration(path):
        if path.stem in base.configurations:
            return configuration(base, path.stem)
        return None
    if path.stem in base.applications:
        return application(base, path.stem, syntax)
    return None


def is_configuration(path: Path) -> bool:
    """Whether a path is one where a base directory has its configurations."""
    return path.suffix == conf.ENDING and path.parent.name == "conf"


def is_application(path: Path) -> bool:
    """Whether a path is one where a base directory has its applications."""
    return path.suffix == appl.ENDING and path.parent.name == "appl"


def _with(
    model: Model,
    files: Mapping[str, ConfigurationFile],
    applications: Mapping[str, ApplicationFile],
    sources: Mapping[str, Source],
) -> Model:
    """Parts that are as they were are the same objects."""
    files = model.files if files == model.files else files
    applications = model.application_files if applications == model.application_files else applications
    sources = model.sources if sources == model.sources else sources
    if files is model.files and applications is model.application_files and sources is model.sources:
        return model
    return replace(model, files=files, application_files=applications, sources=sources)
