"""Everything that a page shows."""

from typing import Any

from msgspec import field

from onika.wire.view.application import ApplicationFile, ApplicationView
from onika.wire.view.class_seat import ClassSeatView
from onika.wire.view.dictionary import DictionaryView, OnikonView, TypeView
from onika.wire.view.document import DocumentView
from onika.wire.view.library import LibraryView, TaskView
from onika.wire.view.replay import ReplayView
from onika.wire.view.review import KeepingView, ReviewView
from onika.wire.view.run import RunView
from onika.wire.view.runtime import RuntimeView
from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason


class ButtonView(View, frozen=True):
    """A button of the user's own, and the command behind it."""

    command: str
    order: int
    spawns_terminal: bool = False
    is_running: bool = False
    output: str = ""
    code: int | None = None


class ConfigurationFile(View, frozen=True):
    """A configuration that could be opened."""

    name: str
    base: str
    path: str
    tasks: int = 0


class Tree(View, frozen=True):
    """Everything."""

    libraries: dict[str, LibraryView] = field(default_factory=dict)
    tasks: dict[str, TaskView] = field(default_factory=dict)
    own_copies: dict[str, str] = field(default_factory=dict)
    """Files that stand before shipped ones, by path, with the name of the laboratory of those."""
    module_sentences: dict[str, dict[str, dict[str, str]]] = field(default_factory=dict)
    """What modules of open libraries say in other languages: translations by module, language and sentence."""
    touched: dict[str, int] = field(default_factory=dict)
    """Files of modules and tasks that were written, by path, with a number that grows."""
    documents: dict[str, DocumentView] = field(default_factory=dict)
    files: dict[str, ConfigurationFile] = field(default_factory=dict)
    loads: dict[str, float] = field(default_factory=dict)
    """By task of a library: the share of a processing unit that it would take, as far as it was measured (X13)."""
    clipboard: str = ""
    """What is in the buffer, in words."""
    runtime: RuntimeView = RuntimeView()
    """That of the first station."""
    stations: dict[str, RuntimeView] = field(default_factory=dict)
    """Those of all other stations, by name (requirement F02)."""
    preferences: dict[str, Any] = field(default_factory=dict)
    buttons: dict[str, ButtonView] = field(default_factory=dict)
    job_types: tuple[str, ...] = ()
    edges: dict[str, tuple[str, tuple[tuple[int, int], ...]]] = field(default_factory=dict)
    """Of each edge of the syntax definition: its colour and its vertices."""
    applications: dict[str, ApplicationView] = field(default_factory=dict)
    application_files: dict[str, ApplicationFile] = field(default_factory=dict)
    dictionaries: dict[str, DictionaryView] = field(default_factory=dict)
    onikons: dict[str, OnikonView] = field(default_factory=dict)
    """The icons of all open dictionaries, by their names."""
    types: dict[str, TypeView] = field(default_factory=dict)
    """Those of the syntax definition, by their names."""
    pictures: dict[str, str] = field(default_factory=dict)
    """The digits of each, row by row, by their keys; those of the start and end icons are `start` and `end`."""
    icon_clipboard: Reason = NOTHING
    """The icons in the buffer, in words."""
    own_undo: Reason = NOTHING
    """What was changed last outside of open files, and would be taken back (X10); empty: nothing."""
    own_redo: Reason = NOTHING
    run: RunView | None = None
    beside: dict[str, RunView] = field(default_factory=dict)
    """Runs that were begun before it and went on beside it, by their numbers."""
    review: ReviewView | None = None
    keeping: KeepingView | None = None
    replay: ReplayView | None = None
    """The session that is replayed here; None: what is shown happens now (H08)."""
    people: int = 0
    """How many browsers look at this."""
    class_seat: ClassSeatView | None = None
    """The seat of a class that this is (X25)."""
