"""Everything that is open in an environment, as one value (house decision 5)."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from onika.desk.environment.copied import Copied
from onika.desk.environment.document import Document
from onika.desk.environment.habits import Habits
from onika.desk.environment.shelf import Shelf
from onika.model.button import Button
from onika.model.configuration import Configuration
from onika.model.preferences import Preferences
from onika.wire import view


@dataclass(frozen=True, slots=True)
class Model:
    """What is open, what was copied, what the user prefers, and what is known of the runtime."""

    shelf: Shelf = field(default_factory=Shelf)
    documents: Mapping[str, Document] = field(default_factory=lambda: MappingProxyType({}))
    """By their ids, in the order in which they were opened."""
    opened: int = 0
    """How many documents were ever opened: ids are never used again."""
    buffer: Copied = field(default_factory=Copied)
    """What was cut or copied last (C22)."""
    preferences: Preferences = field(default_factory=Preferences)
    habits: Habits = field(default_factory=Habits)
    buttons: tuple[Button, ...] = ()
    runs: Mapping[str, view.ButtonView] = field(default_factory=dict)
    """The commands of buttons that run or ran."""
    files: Mapping[str, view.ConfigurationFile] = field(default_factory=dict)
    """The configurations that could be opened, by path."""
    runtime: view.RuntimeView = field(default_factory=view.RuntimeView)
    job_types: tuple[str, ...] = ()
    edges: Mapping[str, Any] = field(default_factory=dict)
    people: int = 0

    def with_document(self, document: Document) -> "Model":
        """With a document in its newest form."""
        return replace(self, documents={**self.documents, document.id: document})

    def without(self, doc: str) -> "Model":
        """With one document less."""
        return replace(self, documents={key: one for key, one in self.documents.items() if key != doc})

    def blank_name(self) -> str:
        """The name of the next new configuration (C21)."""
        taken = {one.name for one in self.documents.values()}
        number = 1
        while f"Untitled-{number}" in taken:
            number += 1
        return f"Untitled-{number}"

    def blank(self) -> Configuration:
        """A new configuration."""
        return Configuration(self.blank_name())
