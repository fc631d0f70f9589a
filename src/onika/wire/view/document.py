"""An open configuration, as a page shows it."""

from typing import Literal

from msgspec import field

from onika.wire.view.asking import AskView, ErrorView
from onika.wire.view.library import TaskView
from onika.wire.view.show import AnyShow
from onika.wire.view.view import Objection, Remedy, View
from onika.words.reason import NOTHING, Reason

State = Literal["", "OFF", "ON", "ASKING", "WAITING", "ERROR", "SPAWNING", "KILLING"]
"""A task's state; empty where nothing is connected."""


class PlacedView(View, frozen=True):
    """A task on a canvas."""

    x: int
    y: int
    in_left: bool = True
    hz: float = 0.0
    """Its rate here; 0: as the library says."""
    rtpu: str = "unknown"
    state: State = ""
    note: Reason = NOTHING
    """A word on its state: why it waits, what is being done."""
    is_missing: bool = False
    """Whether no open library knows it."""
    ask: AskView | None = None
    error: ErrorView | None = None
    warnings: int = 0


class LocusView(View, frozen=True):
    """Where the lines of a variable meet."""

    x: int
    y: int
    is_shown: bool = True
    line: Literal["live", "idle", "stale"] = "idle"
    is_constant: bool = False
    writers: tuple[str, ...] = ()
    readers: tuple[str, ...] = ()


class ProblemView(View, frozen=True):
    """Something wrong with a document, or worth knowing; `show` is where it is."""

    text: Reason
    level: Literal["fault", "warning", "note"]
    show: AnyShow | None = None
    remedies: tuple[Remedy, ...] = ()


class GroupView(View, frozen=True):
    """A supermodule: tasks that are handled as one, in their order of spawning and turning ON."""

    tasks: tuple[str, ...]


class KeptView(View, frozen=True):
    """A configuration that is kept alive beside the one that is shown (C32)."""

    order: int
    tasks: dict[str, State] = field(default_factory=dict)
    """The states of its tasks."""
    path: str = ""
    is_dirty: bool = False


class DocumentView(View, frozen=True):
    """An open configuration."""

    name: str
    order: int
    path: str = ""
    base: str = ""
    is_dirty: bool = False
    is_moved: bool = False
    """Whether only its looks have changed since it was saved (C06)."""
    has_changed_on_disk: bool = False
    undo: Reason = NOTHING
    """What Undo would take back; empty: nothing."""
    redo: Reason = NOTHING
    tasks: dict[str, PlacedView] = field(default_factory=dict)
    loci: dict[str, LocusView] = field(default_factory=dict)
    groups: dict[str, GroupView] = field(default_factory=dict)
    """The supermodules, by their names (C17)."""
    kept: dict[str, KeptView] = field(default_factory=dict)
    """The configurations that one act switches to, by their names."""
    own: dict[str, TaskView] = field(default_factory=dict)
    """Tasks that are otherwise here than in the library, or have another name, as they are here."""
    greyed: dict[str, tuple[Objection, ...]] = field(default_factory=dict)
    """Library tasks that may not be placed, Equations (2) and (3), each with all its reasons."""
    objections: dict[str, tuple[Objection, ...]] = field(default_factory=dict)
    """Those that could be placed and would not run: type, unit, load, device."""
    problems: dict[str, ProblemView] = field(default_factory=dict)
    connection: Literal["none", "connecting", "live", "lost"] = "none"
    subsystem: str = ""
    station: str = ""
    """Where it is turned on, or would be; empty: at the first station."""
    application: str = ""
    """What runs in the subsystem, which it only looks into; empty: it is connected by hand, or not at all."""
    has_ended: bool = False
    """Whether that application is over: it is a plain configuration again."""
    black_box: str = ""
    """The file on the runtime's machine in which the last seconds stand before something went wrong; empty: none."""
    recording: str = ""
    """The file on the runtime's machine into which it is being recorded; empty: it is not."""
    taken_by: str = ""
    """The application that has taken over what lived here, and after which it is put back; empty: none."""
    holder: str = ""
    is_held_here: bool = False
    offered_by: str = ""
    """The holder that would hand it over; empty: nobody does."""
    offered_to: str = ""
    """The session that may take it or decline."""
    is_offered_here: bool = False
    """Whether that is this environment."""
