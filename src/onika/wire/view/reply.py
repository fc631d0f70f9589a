"""What acts are replied with, where that is more than a word."""

from msgspec import field

from onika.wire.view.view import View
from onika.words.reason import Reason


class TextView(View, frozen=True):
    """A text that can be edited, with its faults beside their lines."""

    path: str
    text: str
    stamp: str
    faults: tuple[tuple[int, Reason], ...] = ()
    is_read_only: bool = False


class LoadedView(View, frozen=True):
    """What a runtime says of a module's code that it has loaded; no faults: it is ready."""

    faults: tuple[tuple[int, Reason], ...] = ()
    """By the lines of the code; 0: the whole."""


class TwoTextsView(View, frozen=True):
    """A file of the user's own and the shipped one before which it stands."""

    path: str
    text: str
    shipped_path: str
    shipped_text: str


class SampledView(View, frozen=True):
    """Values of a variable that came, each at a time, at every cycle of the task that writes it."""

    variable: str
    last: int
    """The number of the last one, to be asked for what comes after it."""
    missed: int = 0
    """How many before these, and between them, were lost."""
    labels: tuple[str, ...] = ()
    """Of its elements, as columns of a table are called."""
    at_s: tuple[float, ...] = ()
    rows: tuple[tuple[float, ...], ...] = ()
    """At each time the elements."""
    reason: Reason | None = None
    """Why no more comes."""


class ReplacedView(View, frozen=True):
    """A text that can be brought back: where it was, and until when, in s since 1970."""

    number: int
    path: str
    moment_s: float
    lines: int
    is_there: bool = False
    """Whether the file holds just that now."""


class ParameterSetView(View, frozen=True):
    """A parameter set: tasks, each with the name of a parameter and its words."""

    name: str
    values: tuple[tuple[str, str, tuple[str, ...]], ...] = ()


class ParameterSetsView(View, frozen=True):
    """The parameter sets of a configuration, where they are kept, and its parameters as they are now."""

    path: str
    sets: tuple[ParameterSetView, ...] = ()
    present: tuple[tuple[str, str, tuple[str, ...]], ...] = ()


class DraftView(View, frozen=True):
    """The job that a configuration would make."""

    name: str
    type: str
    left_edge: str
    right_edge: str
    warnings: tuple[Reason, ...] = ()
    picture: str = ""
    """The one it has; empty: none yet."""
    description: str = ""
    path: str = ""


class CandidateView(View, frozen=True):
    """A task that could stand for another one; with `reasons` it cannot."""

    name: str
    description: str = ""
    more: tuple[str, ...] = ()
    """What it writes beyond the other one's outputs."""
    reasons: tuple[Reason, ...] = ()


class SeatView(View, frozen=True):
    """A task that a flow uses, who stands for it now, and who else could: those that can come first."""

    task: str
    taken_by: str
    """Empty: in each flow another one."""
    candidates: tuple[CandidateView, ...] = ()
    description: str = ""
    is_hardware: bool = False
    """Whether it has a device: the others are generic, and learn from it what robot it is."""


class WorldSeatView(View, frozen=True):
    """A world that the files of a flow's tasks name, and who stands for it now."""

    world: str
    taken_by: str
    """Empty: in each flow another one."""


class SeatsView(View, frozen=True):
    """The tasks of every flow that is not nested, by its subsystem; where there are several, those of all by ""."""

    flows: dict[str, tuple[SeatView, ...]] = field(default_factory=dict)
    worlds: dict[str, tuple[WorldSeatView, ...]] = field(default_factory=dict)
    """The worlds of the same flows."""


class PeekIcon(View, frozen=True):
    """An icon in small: the digits of its picture, and the keys of its edges."""

    picture: str
    left: str = ""
    right: str = ""


class PeekView(View, frozen=True):
    """What is in a file that could be opened, as much as a small drawing shows."""

    name: str
    tasks: dict[str, tuple[int, int, int, int]] = field(default_factory=dict)
    """Of a configuration: left, top, width and height of its boxes, by task."""
    wires: tuple[tuple[str, str], ...] = ()
    """Which task writes what another one reads in every cycle."""
    flows: tuple[tuple[PeekIcon, ...], ...] = ()
    """Of an application: the first icons of its first flows."""
