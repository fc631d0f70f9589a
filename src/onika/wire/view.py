"""What a page shows, as plain values: the tree that every browser holds a copy of; the desk alone makes it.

Maps are keyed and have no order of their own: where order counts, a value says its place. Absent is "nothing".
"""

from typing import Any, Literal

from msgspec import Struct

from onika.wire.act import AnyAct

State = Literal["", "OFF", "ON", "ASKING", "WAITING", "ERROR", "SPAWNING", "KILLING"]
"""A task's state; empty where nothing is connected."""


class View(Struct, frozen=True, omit_defaults=True):
    """A part of what is shown."""


class Remedy(View, frozen=True):
    """A button beside a refusal: it sends `act`, or goes to what `show` names.

    show    `task:NAME`, `library:NAME`, `pin:TASK/PIN`, `locus:NAME`, `source:TASK`, `connect`, `problems`
    """

    label: str
    act: AnyAct | None = None
    show: str = ""


class Reason(View, frozen=True):
    """Why something is refused or worth a warning, in words, with what could be done, likeliest first (X01)."""

    text: str
    remedies: tuple[Remedy, ...] = ()


class PinView(View, frozen=True):
    """A pin of a task icon; `y` lies below the icon's upper edge."""

    name: str
    """The coded name."""
    svar: str
    kind: Literal["INCONST", "OUTCONST", "INVAR", "OUTVAR", "INBOTH", "OUTBOTH"]
    y: int
    shape: str = ""
    """As in `double[6]`; empty until the module's class was read."""
    unit: str = ""
    meaning: str = ""


class TaskView(View, frozen=True):
    """A task of a library, with what was changed of it in this session."""

    name: str
    module: str
    library: str
    order: int
    description: str
    width: int
    height: int
    pins: tuple[PinView, ...]
    type: str = "periodic"
    hz: float | None = None
    file_hz: float | None = None
    object_type: str = ""
    is_trigger: bool = False
    local: tuple[tuple[str, tuple[str, ...]], ...] = ()
    is_changed: bool = False
    """Whether it is no longer as its file says."""
    path: str = ""
    code: str = ""
    """The path of its module's code; empty: there is none."""


class LibraryView(View, frozen=True):
    """An open library."""

    name: str
    path: str
    order: int
    tasks: int
    faults: tuple[str, ...] = ()


class AskItem(View, frozen=True):
    """One value or vector that a task asks for."""

    name: str
    type: str
    count: int
    unit: str
    meaning: str
    default: tuple[Any, ...] | None = None
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None


class AskView(View, frozen=True):
    """What a task waits to be told before it comes on."""

    items: tuple[AskItem, ...]
    reason: str = ""
    """Why it asks again."""
    present: dict[str, tuple[float, ...]] = {}
    """What "take the present position" would fill in, by item."""


class ErrorView(View, frozen=True):
    """Why a task is in ERROR, and the ways out."""

    text: str
    entry: str = ""
    path: str = ""
    line: int = 0
    traceback: str = ""
    at_s: float = 0.0
    values: dict[str, Any] = {}
    remedies: tuple[Remedy, ...] = ()


class PlacedView(View, frozen=True):
    """A task on a canvas."""

    x: int
    y: int
    in_left: bool = True
    hz: float = 0.0
    """Its rate here; 0: as the library says."""
    rtpu: str = "unknown"
    state: State = ""
    note: str = ""
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
    """Something wrong with a document, or worth knowing; `show` as in `Remedy`."""

    text: str
    level: Literal["fault", "warning", "note"]
    show: str = ""
    remedies: tuple[Remedy, ...] = ()


class GroupView(View, frozen=True):
    """A supermodule: tasks that are handled as one, in their order of spawning and turning ON."""

    tasks: tuple[str, ...]


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
    undo: str = ""
    """What Undo would take back; empty: nothing."""
    redo: str = ""
    tasks: dict[str, PlacedView] = {}
    loci: dict[str, LocusView] = {}
    groups: dict[str, GroupView] = {}
    """The supermodules, by their names (C17)."""
    greyed: dict[str, tuple[Reason, ...]] = {}
    """Library tasks that may not be placed, Equations (2) and (3), each with all its reasons."""
    objections: dict[str, tuple[Reason, ...]] = {}
    """Those that could be placed and would not run: type, unit, load, device."""
    problems: dict[str, ProblemView] = {}
    connection: Literal["none", "connecting", "live", "lost"] = "none"
    subsystem: str = ""
    holder: str = ""
    is_held_here: bool = False


class UnitView(View, frozen=True):
    """A processing unit."""

    load: float = 0.0
    is_lost: bool = False


class RuntimeView(View, frozen=True):
    """The runtime of this environment."""

    state: Literal["none", "starting", "linked", "lost"] = "none"
    address: str = ""
    text: str = ""
    """Why it is lost."""
    is_virtual: bool = False
    is_stopped: bool = False
    stop_text: str = ""
    units: dict[str, UnitView] = {}
    worlds: dict[str, bool] = {}
    subsystems: dict[str, str] = {}
    """Names of those that live, with what holds them."""


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

    libraries: dict[str, LibraryView] = {}
    tasks: dict[str, TaskView] = {}
    documents: dict[str, DocumentView] = {}
    files: dict[str, ConfigurationFile] = {}
    clipboard: str = ""
    """What is in the buffer, in words."""
    runtime: RuntimeView = RuntimeView()
    preferences: dict[str, Any] = {}
    buttons: dict[str, ButtonView] = {}
    job_types: tuple[str, ...] = ()
    edges: dict[str, tuple[str, tuple[tuple[int, int], ...]]] = {}
    """Of each edge of the syntax definition: its colour and its vertices."""
    people: int = 0
    """How many browsers look at this."""


class TextView(View, frozen=True):
    """A text that can be edited, with its faults beside their lines."""

    path: str
    text: str
    stamp: str
    faults: tuple[tuple[int, str], ...] = ()
    is_read_only: bool = False


class DraftView(View, frozen=True):
    """The job that a configuration would make."""

    name: str
    type: str
    left_edge: str
    right_edge: str
    warnings: tuple[str, ...] = ()
    picture: str = ""
    """The one it has; empty: none yet."""
    description: str = ""
    path: str = ""
