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
from onika.desk.environment.state.measuring import MeasuringSubsystem
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
from onika.words.reason import Reason

_NO_RUNTIME = view.RuntimeView()


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
    """That of the station in focus."""
    station: str = ""
    """The station in focus, about which something is decided or told; empty: the first one, as between any two acts."""
    stations: Mapping[str, view.RuntimeView] = field(default_factory=lambda: {"": view.RuntimeView()})
    """The runtimes of all stations, by name, each as it was when it was in focus last (requirement F02)."""
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
    code_faults: Mapping[str, tuple[int, Reason] | None] = field(default_factory=dict)
    """The code that was looked through, by path: the first line that is wrong and why; None: it can be compiled."""
    limits: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    """Constants that bound the values of targets, as far as a runtime has told them."""
    icon_clipboard: tuple[Step, ...] = ()
    """The steps that were cut or copied last."""
    flow_pictures: tuple[str, str] = ("", "")
    """Those of the start and end icons, the digits of each."""
    cycles_us: Mapping[str, float] = field(default_factory=dict)
    """The mean time of a cycle in microseconds, by the digest of the code, as a runtime has measured it (X13)."""
    own: OwnHistory = field(default_factory=History)
    """What was changed outside of open files, to be taken back (X10)."""
    run: Run | None = None
    """The run of an application that was begun last."""
    beside: Mapping[int, Run] = field(default_factory=dict)
    """Runs that were begun before it and went on beside it, by their numbers."""
    review_session: ReviewSession | None = None
    """The recorded run that is looked at."""
    keeping: view.KeepingView | None = None
    """The test that is being kept, or was last."""
    measuring: MeasuringSubsystem | None = None
    """What lives for a moment to measure where an arm stands."""
    replay: view.ReplayView | None = None
    """The session that is replayed here."""
    performed: int = 0
    """How many runs there were."""
    people: int = 0
    class_seat: view.ClassSeatView | None = None
    """The seat of a class that this is (X25)."""

    def at(self, station: str) -> "Model":
        """The same with another station in focus; of one that is not known nothing is kept."""
        if station == self.station:
            return self
        return replace(self, station=station, runtime=self.runtime_at(station), stations=self.every_station)

    @property
    def every_station(self) -> Mapping[str, view.RuntimeView]:
        """The runtimes of all stations, by name, in the order in which they were connected; the first has none."""
        return {**self.stations, self.station: self.runtime} if self.station in self.stations else self.stations

    def runtime_at(self, station: str) -> view.RuntimeView:
        """The runtime of a station, whichever is in focus."""
        return self.every_station.get(station, _NO_RUNTIME)

    def with_station(self, name: str, runtime: view.RuntimeView) -> "Model":
        """With a station that is not in focus, new or in its newest form."""
        return replace(self, stations={**self.stations, name: runtime})

    def without_station(self, name: str) -> "Model":
        """With one station less that is not in focus."""
        return replace(self, stations={other: seen for other, seen in self.stations.items() if other != name})

    @property
    def documents_here(self) -> Mapping[str, Document]:
        """The configurations that are assigned to the station in focus, by their ids."""
        return {key: document for key, document in self.documents.items() if document.station == self.station}

    @property
    def going_here(self) -> tuple[Run, ...]:
        """The runs at the station in focus that are not over."""
        return tuple(run for run in self.runs_here if not run.is_over)

    @property
    def runs_here(self) -> tuple[Run, ...]:
        """The runs at the station in focus: the one that was begun last, then those beside it."""
        return tuple(run for run in self.every_run if run.is_at(self.station))

    def with_document(self, document: Document) -> "Model":
        """With a document in its newest form."""
        return replace(self, documents={**self.documents, document.id: document})

    def with_application(self, application: OpenApplication) -> "Model":
        """With an application in its newest form."""
        return replace(self, applications={**self.applications, application.id: application})

    @property
    def every_run(self) -> tuple[Run, ...]:
        """The run that was begun last, then those beside it."""
        return (*(() if self.run is None else (self.run,)), *self.beside.values())

    @property
    def going(self) -> tuple[Run, ...]:
        """The runs that are not over: several go on side by side."""
        return tuple(run for run in self.every_run if not run.is_over)

    def run_of(self, doc: str) -> Run | None:
        """The run of an application, the one that goes on before one that is over."""
        of_application = [run for run in self.every_run if run.doc == doc]
        return next((run for run in of_application if not run.is_over), next(iter(of_application), None))

    def run_in(self, subsystem: str) -> Run | None:
        """The run that goes on in a subsystem here; one that is about to begin may not have its place yet."""
        there = [run for run in self.going_here if subsystem in run.homes_at(self.station)]
        return next((run for run in there if run.view.state != "beginning"), next(iter(there), None))

    def with_run(self, run: Run) -> "Model":
        """With a run in its newest form."""
        if run.view.number in self.beside:
            return replace(self, beside={**self.beside, run.view.number: run})
        return replace(self, run=run)

    def without_run(self, run: Run) -> "Model":
        """With one run less that is shown."""
        beside = {number: other for number, other in self.beside.items() if number != run.view.number}
        is_last = self.run is not None and self.run.view.number == run.view.number
        return replace(self, run=None if is_last else self.run, beside=beside)

    def making_room(self) -> "Model":
        """With room for a run that begins: those that go on stand beside it, those that are over are not shown."""
        return replace(
            self, run=None, beside={run.view.number: run for run in sorted(self.going, key=lambda run: run.view.number)}
        )

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
