"""What was done to an open file, so that it can be taken back and done again (requirement X10)."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Generic, TypeVar

from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.configuration import Configuration
from onika.model.task import Task
from onika.store.opened_text import OpenedText
from onika.words.reason import Reason

_KEPT = 500


_C = TypeVar("_C")

Edits = Mapping[str, Task | None]
"""Tasks as they were changed in this session, by name; None: as its file says."""


@dataclass(frozen=True, slots=True)
class FileState:
    """The file that a document is tied to, as it was read or saved last, and its base directory."""

    opened: OpenedText[Configuration] | None
    base: Path | None


@dataclass(frozen=True, slots=True)
class UndoStep(Generic[_C]):
    """One thing that was done: what is open before and after it, and the tasks of the libraries it changed."""

    label: Reason
    by: str
    before: _C
    after: _C
    number: int = 0
    """Of two steps, also of two histories, the larger was done, taken back or done again later."""
    edits_before: Edits = field(default_factory=dict)
    edits_after: Edits = field(default_factory=dict)
    libraries_before: OpenLibraries | None = None
    """The tasks that the loci of `before` were settled with; None: those of now."""
    libraries_after: OpenLibraries | None = None
    file_before: FileState | None = None
    """Where a step changed what file the document is tied to: the file before it; None: the same all along."""
    file_after: FileState | None = None


@dataclass(frozen=True, slots=True)
class History(Generic[_C]):
    """The steps of a document, oldest first, and those taken back, the next to be done again last."""

    past: tuple[UndoStep[_C], ...] = ()
    future: tuple[UndoStep[_C], ...] = ()

    @property
    def last(self) -> UndoStep[_C] | None:
        """What Undo takes back."""
        return self.past[-1] if self.past else None

    @property
    def next(self) -> UndoStep[_C] | None:
        """What Redo does again."""
        return self.future[-1] if self.future else None

    def done(self, step: UndoStep[_C]) -> "History[_C]":
        """With one more step; what was taken back is gone."""
        return History((*self.past, step)[-_KEPT:])

    def undone(self, number: int) -> "History[_C]":
        """With the last step taken back, under a new number; raises IndexError where there is none."""
        return History(self.past[:-1], (*self.future, replace(self.past[-1], number=number)))

    def redone(self, number: int) -> "History[_C]":
        """With the next step done again, under a new number; raises IndexError where there is none."""
        return History((*self.past, replace(self.future[-1], number=number)), self.future[:-1])

    @property
    def newest(self) -> int:
        """The largest number of its steps; 0: it has none."""
        return max((step.number for step in (self.last, self.next) if step is not None), default=0)
