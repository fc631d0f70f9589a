"""What a user prefers: sizes, shown connections, window places and status columns (dissertation §A.5)."""

from dataclasses import dataclass

STATUS_COLUMNS = (
    "rmod",
    "rtpu",
    "tid",
    "S",
    "crit",
    "state",
    "cycle",
    "miss",
    "ref-F",
    "ref-T",
    "mez-F",
    "mez-T",
    "ptime",
    "tot-C",
    "tick",
    "min-U",
    "max-U",
    "avg-U",
    "min-C",
    "max-C",
    "avg-C",
    "warn",
)
"""Every column the status view can show (requirement A11)."""


@dataclass(frozen=True, slots=True)
class WindowCorner:
    """The upper left corner of a window, in pixels."""

    x: int
    y: int


@dataclass(frozen=True, slots=True)
class Window:
    """The corner of a window and the size of its scrollable part, in pixels."""

    x: int
    y: int
    height: int
    width: int


@dataclass(frozen=True, slots=True)
class Preferences:
    """What a `.onika` file says; lengths are pixels unless said otherwise."""

    line_length: int = 12
    """Characters of a task's name before it wraps."""
    min_size: int = 64
    """Least height of a task icon."""
    min_pin_separation: int = 18
    step_size: int = 6
    """How much an icon grows at a time until its pins are far enough apart."""
    pin_length: int = 12
    connection_separation: int = 6
    show_inconst: bool = False
    show_outconst: bool = False
    show_invar: bool = True
    show_outvar: bool = True
    locus_size: int = 4
    """Radius of a locus."""
    hit_tolerance: int = 5
    shows_period: bool = False
    """Whether rates are shown as periods rather than frequencies."""
    library: Window = Window(0, 0, 480, 320)
    canvas: Window = Window(330, 0, 640, 960)
    status: WindowCorner = WindowCorner(0, 520)
    variables: WindowCorner = WindowCorner(330, 680)
    dictionary: Window = Window(0, 0, 480, 320)
    workspace: Window = Window(330, 0, 640, 960)
    main: WindowCorner = WindowCorner(0, 760)
    buttons: WindowCorner = WindowCorner(160, 760)
    status_columns: tuple[str, ...] = ("rmod", "rtpu", "state", "cycle", "miss", "ref-F", "mez-F", "avg-U", "warn")
