"""A recorded run that is looked at, as a page shows it. Times are seconds of the run's own clock."""

from typing import Any, Literal

from msgspec import field

from onika.wire.view.application import RedirectView
from onika.wire.view.run import RunView
from onika.wire.view.subsystem import SubsystemView
from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason


class PassageView(View, frozen=True):
    """An action that was carried out; the last one of a run cut short has no end."""

    action: int
    """Its place in the plan of its flow."""
    name: str
    begin_s: float
    end_s: float | None = None
    step: int = 0
    """The step of the open application that it is; 0: none is."""


class RecordedFlowView(View, frozen=True):
    """A flow of a recorded run."""

    order: int
    passages: tuple[PassageView, ...] = ()


class RecordedVariableView(View, frozen=True):
    """A variable that was recorded, by `SUBSYSTEM/NAME`."""

    unit: str = ""
    labels: tuple[str, ...] = ()
    """Of its elements."""


class MarkView(View, frozen=True):
    """Something that happened, worth a mark at the time line: an error, a stop, a meeting, a command."""

    at_s: float
    kind: Literal["error", "stop", "meet", "command"]
    text: Reason


class RecordingView(View, frozen=True):
    """A recorded run."""

    path: str
    name: str
    """Of the application."""
    is_virtual: bool = False
    is_whole: bool = True
    """Else it was cut short, and ends where it was."""
    is_completed: bool = False
    cause: Reason = NOTHING
    """Why it ended before its time."""
    begin_s: float = 0.0
    end_s: float = 0.0
    flows: dict[str, RecordedFlowView] = field(default_factory=dict)
    """By their subsystems."""
    variables: dict[str, RecordedVariableView] = field(default_factory=dict)
    worlds: tuple[str, ...] = ()
    marks: tuple[MarkView, ...] = ()
    notes: tuple[Reason, ...] = ()
    """What is worth knowing: values that were lost, icons that are others now."""
    cannot_continue: Reason = NOTHING
    """Why it cannot be gone on from an instant of it; empty: it can."""
    doc: str = ""
    """The open application whose run it was; empty: it is not open."""
    began_at_s: float = 0.0
    """When it began, in seconds since 1970; 0: it was not said."""
    redirects: tuple[RedirectView, ...] = ()
    """Who stood for whom in that run."""
    inside: dict[str, SubsystemView] = field(default_factory=dict)
    """What lived in its subsystems; the states are those of the instant."""
    steps_by_task: dict[str, tuple[int, ...]] = field(default_factory=dict)
    """As in a run that goes on."""


class DifferenceView(View, frozen=True):
    """The first difference of two recorded runs, or why they cannot be compared; without a text there is none."""

    text: Reason = NOTHING
    at_s: float = 0.0
    variable: str = ""
    tolerance: float = 0.0
    """How far values were allowed to lie apart."""
    part: float = 0.0
    """And by which part of themselves."""
    time_s: float = 0.0
    """How far times were."""
    is_of_places: bool = False
    """Whether speeds and forces were left out, as in wall time they never repeat."""


class ReviewView(View, frozen=True):
    """What is looked at."""

    recording: RecordingView
    other: RecordingView | None = None
    difference: DifferenceView | None = None
    """None: it is being looked for, or there is no other."""


class InstantView(View, frozen=True):
    """What a recorded run was like at an instant."""

    at_s: float
    run: RunView
    """As the run would have been shown then; what could have been chosen is left out."""
    tasks: dict[str, str] = field(default_factory=dict)
    """States by `SUBSYSTEM/TASK`."""
    values: dict[str, Any] = field(default_factory=dict)
    """By `SUBSYSTEM/NAME`; what was not written yet is not there, nor are pictures."""
    poses: dict[str, Any] = field(default_factory=dict)
    """By world, as in `page.Frame`."""
    homes: dict[str, str] = field(default_factory=dict)
    """By open configuration, the subsystem in which its tasks were."""


class StretchView(View, frozen=True):
    """One element of a variable: in each of equal parts of a time the least and the greatest value."""

    label: str
    unit: str
    at_s: tuple[float, ...]
    least: tuple[float, ...]
    most: tuple[float, ...]


class RecordingFile(View, frozen=True):
    """A recording that could be looked at."""

    path: str
    name: str
    """Of the application."""
    began_at_s: float = 0.0
    """Seconds since 1970."""
    took_s: float = 0.0
    bytes: int = 0
    is_whole: bool = True
    is_black_box: bool = False
    """Whether it holds only the last seconds of a run in which something went wrong."""


class RecordingsView(View, frozen=True):
    """The recordings of this environment, newest first, and where they lie."""

    folder: str
    files: tuple[RecordingFile, ...] = ()


class SharedFileView(View, frozen=True):
    """A recorded run as one HTML file (X21)."""

    name: str
    """Of the file."""
    text: str
    every_s: float = 0.0
    """How far its instants lie apart, where that is further than usual; 0: it is not."""


class KeepingView(View, frozen=True):
    """A test that is being kept, or was last."""

    doc: str
    path: str
    state: Literal["running", "kept", "failed"] = "running"
    text: Reason = NOTHING
    """What is in it, or why it is not kept."""
    run: int = 0
    """Which run is carried out now; 0: none yet."""
    of: int = 0
