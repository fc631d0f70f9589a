"""An open file, a configuration or an application: its past, the file it came from, and which kind it is."""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field, replace
from enum import Enum
from pathlib import Path
from typing import ClassVar, Generic, Self, TypeVar

from onika.desk.environment.state.history import History
from onika.store.opened_text import OpenedText

_T = TypeVar("_T")
_C = TypeVar("_C")


class DocumentKind(Enum):
    """What an open file is; the value is what users call it."""

    CONFIGURATION = "configuration"
    APPLICATION = "application"

    def id(self, number: int) -> str:
        """The id of the open file of this number, which says the kind also when the file is closed."""
        return f"{self.value[0]}{number}"

    @classmethod
    def of(cls, doc: str) -> "DocumentKind":
        """The kind of the open file that has, or had, an id."""
        if doc[:1] == cls.APPLICATION.value[0]:
            return cls.APPLICATION
        return cls.CONFIGURATION


@dataclass(frozen=True, slots=True)
class OpenFile(ABC, Generic[_T, _C]):
    """A file holds a `_T`; what is done to it changes a `_C`."""

    kind: ClassVar[DocumentKind]
    id: str
    history: History[_C] = field(default_factory=History, kw_only=True)
    opened: OpenedText[_T] | None = field(default=None, kw_only=True)
    """The file as it was read or saved last; None: it has none yet."""
    base: Path | None = field(default=None, kw_only=True)
    """The base directory of its file, or the one it is meant for."""
    has_changed_on_disk: bool = field(default=False, kw_only=True)

    @property
    @abstractmethod
    def name(self) -> str:
        """What it is called."""

    @property
    @abstractmethod
    def value(self) -> _T:
        """What its file would hold if it were saved now."""

    @property
    @abstractmethod
    def is_dirty(self) -> bool:
        """Whether it has changed in more than its looks since it was saved."""

    @property
    def is_unsaved(self) -> bool:
        """Whether it has changed since it was saved, in its looks too."""
        return self.is_dirty

    def differing(self, has_changed_on_disk: bool) -> Self:
        """With what is known of its file; itself where that was known."""
        if has_changed_on_disk == self.has_changed_on_disk:
            return self
        return replace(self, has_changed_on_disk=has_changed_on_disk)

    def seen(self, text: str) -> Self:
        """With what its file was seen to hold, which the next save overwrites."""
        if self.opened is None:
            return self
        return replace(self, opened=replace(self.opened, text=text))
