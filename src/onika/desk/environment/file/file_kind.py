"""What is different of configurations and applications as files: how they are read, written and taken over."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, Protocol, TypeVar

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults, OpenedText
from onika.store.site import Site
from onika.words.fault import Refusal
from onika.words.reason import Reason

READ_AGAIN = Reason.of("run.reading_again")

_T = TypeVar("_T")
_F = TypeVar("_F")


@dataclass(frozen=True, slots=True)
class FileReading(Generic[_T]):
    """A file as it was read; `is_partial`: as far as it could be."""

    base: BaseDirectory
    opened: OpenedText[_T]
    faults: Faults = ()
    is_partial: bool = False


class FileKind(Protocol[_F, _T]):
    """One kind of files: `_F` is an open one, `_T` what it holds."""

    def read(self, model: Model, path_or_name: str, outside: Services, /) -> FileReading[_T] | No:
        """A file by its path, or by its name on the search path."""
        ...

    def read_again(self, model: Model, base: BaseDirectory, name: str, /) -> FileReading[_T] | Faults:
        """A file of a base directory; the faults where it cannot be read."""
        ...

    def open(self, model: Model, reading: FileReading[_T], /) -> Done:
        """What was read is open beside the others; the value is its id."""
        ...

    def as_seen(self, model: Model, file: _F, /) -> _F:
        """The file as it is to be written, so that it says by itself what is seen of it here."""
        ...

    def elsewhere(self, model: Model, file: _F, path: Path, site: Site, /) -> tuple[Reason, ...]:
        """What another program that reads it there would find differently."""
        ...

    def loss(self, file: _F, path: Path, /) -> Reason:
        """What would be lost if it were saved there; empty: nothing."""
        ...

    def path(self, base: BaseDirectory, name: str, /) -> Path:
        """The file of a name in a base directory."""
        ...

    def write(self, base: BaseDirectory, name: str, file: _F, /, *, overwrites: bool) -> OpenedText[_T] | Refusal | No:
        """Write the file under a name."""
        ...

    def saved(self, model: Model, file: _F, opened: OpenedText[_T], base: Path, /) -> Done:
        """It was saved there; the value is the path."""
        ...

    def close(self, model: Model, file: _F, alive: str, /, *, discards: bool) -> Done | No:
        """It is open no more."""
        ...

    def reread(self, model: Model, file: _F, reading: FileReading[_T], /) -> Done:
        """What stands in the file now is taken over, as a step."""
        ...

    def refreshed(self, file: _F, reading: FileReading[_T], step: int, /) -> _F:
        """The same, with its step in the history under this number, where nothing that lives or runs is concerned."""
        ...

    def is_in_use(self, model: Model, file: _F, /) -> bool:
        """Whether something that lives or runs is of it."""
        ...

    def at_fault(self, faults: Faults, /) -> Reason:
        """What is said of a file that cannot be read any more."""
        ...


def place(path_or_name: str, kind: DocumentKind, outside: Services) -> tuple[BaseDirectory, str] | No:
    """The base directory and the name of a file; its ending is called as its folder."""
    folder = "appl" if kind is DocumentKind.APPLICATION else "conf"
    path = Path(path_or_name)
    if path.suffix == f".{folder}":
        if not path.is_file():
            key = "run.not_a_file" if path.exists() else "run.no_file_there"
            return No(Reason.of(key, path=str(path)))
        if path.absolute().parent.name != folder:
            return No(Reason.of("run.outside_folder", path=str(path), folder=folder))
        return BaseDirectory(path.absolute().parent.parent), path.stem
    bases = [base for base in outside.site.directories if path_or_name in names_of(base, kind)]
    if not bases:
        is_application = kind is DocumentKind.APPLICATION
        key = "run.none_on_path_application" if is_application else "run.none_on_path_configuration"
        return No(Reason.of(key, name=path_or_name))
    return bases[0], path_or_name


def names_of(base: BaseDirectory, kind: DocumentKind) -> Sequence[str]:
    """The files of a kind in a base directory."""
    if kind is DocumentKind.APPLICATION:
        return base.applications
    return base.configurations
