"""Everything that is open in an environment, as one value."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

from onika.desk.environment.run_state.review_session import ReviewSession
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.clipboard import Clipboard
from onika.desk.environment.state.dictionary import Dictionary
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import History
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.state.restoration import OwnHistory
from onika.desk.environment.state.settings import Settings
from onika.model.application import Step
from onika.model.button import Button
from onika.model.configuration import Configuration
from onika.model.preferences import Preferences
from onika.model.rules.iconify import ActionType
from onika.model.syntax import Syntax
from onika.wire import view
from onika.words.fault import Refusal


@dataclass(frozen=True, slots=True)
class Model:
    """What is open, what was copied, what the user prefers, and what is known of the runtime."""

    libraries: OpenLibraries = field(default_factory=OpenLibraries)
    documents: Mapping[str, Document] = field(default_factory=lambda: MappingProxyType({}))
    """By their ids, in the order in which they were opened."""
    opened: int = 0
    """How many documents were ever opened: ids are never used again."""
    clipboard: Clipboard = field(default_factory=Clipboard)
    """The tasks that were cut or copied last (C22)."""
    preferences: Preferences = field(default_factory=Preferences)
    settings: Settings = field(default_factory=Settings)
    buttons: tuple[Button, ...] = ()
    runs: Mapping[str, view.ButtonView] = field(default_factory=dict)
    """The commands of buttons that run or ran."""
    files: Mapping[str, view.ConfigurationFile] = field(default_factory=dict)
    """The configurations that could be opened, by path."""
    runtime: view.RuntimeView = field(default_factory=view.RuntimeView)
    job_types: tuple[str, ...] = ()
    edges: Mapping[str, Any] = field(default_factory=dict)
    syntax: Syntax | None = None
    applications: Mapping[str, OpenApplication] = field(default_factory=lambda: MappingProxyType({}))
    """By their ids, in the order in which they were opened."""
    application_files: Mapping[str, view.ApplicationFile] = field(default_factory=dict)
    """The applications that could be opened, by path."""
    sources: Mapping[str, Configuration | ActionType | tuple[Refusal, ...] | None] = field(default_factory=dict)
    """By path: configurations, and the types that applications have as icons, as their files say; None: at fault."""
    dictionaries: tuple[Dictionary, ...] = ()
    search: tuple[Path, ...] = ()
    """The search path, as far as names are looked for by it here."""
    arrangements: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """How tasks and icons are arranged: their names in order, by the path of the folder that has them."""
    own_copies: Mapping[str, str] = field(default_factory=dict)
    """Files that stand before shipped ones, by path, with the name of the laboratory of those."""
    touched: Mapping[str, int] = field(default_factory=dict)
    """Files of modules and tasks that were written, by path, with a number that grows: who shows one reads it again."""
    limits: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    """Constants that bound the values of targets, as far as a runtime has told them."""
    icon_clipboard: tuple[Step, ...] = ()
    """The steps that were cut or copied last."""
    flow_pictures: tuple[str, str] = ("", "")
    """Those of the start and end icons, 1024 digits each."""
    cycles_us: Mapping[str, float] = field(default_factory=dict)
    """The mean time of a cycle in microseconds, by the digest of the code, as a runtime has measured it (X13)."""
    own: OwnHistory = field(default_factory=History)
    """What was changed outside of open files, to be taken back (X10)."""
    run: Run | None = None
    """The run of an application that goes on now, or the last one."""
    review_session: ReviewSession | None = None
    """The recorded run that is looked at."""
    keeping: view.KeepingView | None = None
    """The test that is being kept, or was last."""
    performed: int = 0
    """How many runs there were."""
    people: int = 0

    def with_document(self, document: Document) -> "Model":
        """With a document in its newest form."""
        return replace(self, documents={**self.documents, document.id: document})

    def with_application(self, application: OpenApplication) -> "Model":
        """With an application in its newest form."""
        return replace(self, applications={**self.applications, application.id: application})

    @property
    def open_files(self) -> tuple[Document | OpenApplication, ...]:
        """All that is open: configurations, then applications."""
        return *self.documents.values(), *self.applications.values()

    @property
    def next_step(self) -> int:
        """The number of what is done next: larger than that of every step of what is open."""
        return 1 + max(history.newest for history in (self.own, *(file.history for file in self.open_files)))

    def file(self, doc: str) -> Document | OpenApplication | None:
        """The open file of this id."""
        return self.documents.get(doc) or self.applications.get(doc)

    def with_file(self, file: Document | OpenApplication) -> "Model":
        """With an open file in its newest form."""
        if isinstance(file, Document):
            return self.with_document(file)
        return self.with_application(file)

    def without(self, doc: str) -> "Model":
        """With one document less."""
        return replace(self, documents={key: document for key, document in self.documents.items() if key != doc})

    def libraries_of(self, document: Document) -> OpenLibraries:
        """The libraries as a document sees them: with what its configuration says otherwise than the files."""
        return self.libraries.within(document.content.configuration)

    def blank_name(self) -> str:
        """The name of the next new configuration or application (C21)."""
        taken = {file.name for file in self.open_files}
        number = 1
        while f"Untitled-{number}" in taken:
            number += 1
        return f"Untitled-{number}"

    def blank(self) -> Configuration:
        """A new configuration."""
        return Configuration(self.blank_name())
