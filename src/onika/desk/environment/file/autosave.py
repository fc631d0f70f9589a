"""When what is not saved is kept for a recovery: soon after the last act, never all the time; sans I/O."""

from collections.abc import Mapping
from dataclasses import dataclass

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication

Kept = Document | OpenApplication
"""What is kept: configurations and applications, which have different ids."""

REST_S = 0.3
"""After the last act."""

APART_S = 2.0
"""From one time to the next; who never rests is kept as often."""


@dataclass(frozen=True, slots=True)
class UnsavedChange:
    """The document that is to be kept under an id from now on; None: none any more."""

    doc: str
    document: Kept | None


class Autosave:
    """Told of every model by `look`; when it is `due_s`, `take` gives what is to be written."""

    def __init__(self) -> None:
        self._open: Mapping[str, Kept] = {}
        self._unsaved: dict[str, Kept] = {}
        self._kept: dict[str, Kept] = {}
        self._first_s: float | None = None
        self._last_s = 0.0
        self._taken_s = float("-inf")

    def look(self, model: Model, now_s: float) -> None:
        """The model has changed, or may have."""
        every: dict[str, Kept] = {file.id: file for file in model.open_files}
        before, self._unsaved = self._unsaved, self._to_keep(every)
        self._open = every
        if not self._changed():
            self._first_s = None
        elif self._first_s is None:
            self._first_s = self._last_s = now_s
        elif not _are_alike(before, self._unsaved):
            self._last_s = now_s

    @property
    def due_s(self) -> float | None:
        """When something is to be written; None: nothing is."""
        if self._first_s is None:
            return None
        return max(self._taken_s + APART_S, min(self._last_s + REST_S, self._first_s + APART_S))

    def take(self, now_s: float) -> tuple[UnsavedChange, ...]:
        """What is to be written where it is due, and counts as written."""
        due_s = self.due_s
        if due_s is not None and due_s <= now_s:
            return self.take_all(now_s)
        return ()

    def take_all(self, now_s: float) -> tuple[UnsavedChange, ...]:
        """What is to be written, due or not: at the end."""
        changes = tuple(UnsavedChange(doc, self._unsaved.get(doc)) for doc in self._changed())
        self._kept = dict(self._unsaved)
        self._first_s = None
        self._taken_s = now_s if changes else self._taken_s
        return changes

    def _to_keep(self, documents: Mapping[str, Kept]) -> dict[str, Kept]:
        """The documents that are not saved; those that are as they were need no second look."""
        rescued = {}
        for doc, document in documents.items():
            is_known = self._open.get(doc) is document
            if doc in self._unsaved if is_known else document.is_unsaved:
                rescued[doc] = document
        return rescued

    def _changed(self) -> list[str]:
        """The documents of which something else is to be kept than is."""
        new = (
            doc
            for doc, state in self._unsaved.items()
            if doc not in self._kept or not _is_alike(self._kept[doc], state)
        )
        return [*(doc for doc in self._kept if doc not in self._unsaved), *new]


def _are_alike(kepts: Mapping[str, Kept], other: Mapping[str, Kept]) -> bool:
    return kepts.keys() == other.keys() and all(_is_alike(kepts[doc], other[doc]) for doc in kepts)


def _is_alike(kept: Kept, other: Kept) -> bool:
    """Whether the same is kept of both: what lives and what was done before does not count."""
    is_of_one_file = kept.opened is other.opened and kept.base == other.base
    return is_of_one_file and kept.value == other.value
