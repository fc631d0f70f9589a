"""A run of an application, as a page shows it. Times are seconds of the run's own clock."""

from typing import Any, Literal

from msgspec import field

from onika.wire.view.asking import AskView
from onika.wire.view.puzzle import PuzzleResultView
from onika.wire.view.view import ChoiceView, View
from onika.words.reason import NOTHING, Reason


class StepRunView(View, frozen=True):
    """What has become of a step of the application in this run."""

    state: Literal["running", "done", "left"] = "running"
    began_s: float = 0.0
    """When it began last."""
    took_s: float = 0.0
    """How long it took last."""
    times: int = 0
    """How often it has been done."""


class FlowRunView(View, frozen=True):
    """Where a flow is; `state` is a word of `engine.flow.FlowState`."""

    order: int
    state: str = "ready"
    step: int = 0
    """The step of the application that is carried out, or was last; 0: none yet."""
    action: str = ""
    """What is carried out, in the words of the icons; of a nested application the action in it."""
    within: tuple[str, ...] = ()
    """The nested applications around it."""
    index: int = -1
    """Of the action, among all that are planned for this flow."""
    of: int = 0
    done: int = 0
    began_s: float = 0.0
    should_take_s: float = 0.0
    """What its target says of its duration; 0: nothing is known."""
    is_pausing: bool = False
    tag: str = ""
    waits_for: tuple[str, ...] = ()
    waits_since_s: float = 0.0
    loops: tuple[str, ...] = ()
    is_nested: bool = False
    text: Reason = NOTHING
    """Why it stands, where that is worth a word."""
    worlds: tuple[str, ...] = ()
    """The worlds in which its tasks have devices."""
    guest: str = ""
    """The program of another framework that carries out all its actions; empty: there is none."""
    station: str = ""
    """Where it is carried out, where the flows of a run are at several stations."""


class MeetView(View, frozen=True):
    """Flows have begun together at a tag."""

    tag: str
    flows: tuple[str, ...]
    skew_us: float
    at_s: float


class CourseView(View, frozen=True):
    """The last seconds of a variable."""

    variable: str
    unit: str
    at_s: tuple[float, ...]
    values: tuple[Any, ...]


class StopView(View, frozen=True):
    """Why a flow stands still or the run has ended, and what can be done (X06)."""

    text: Reason
    kind: str
    """A word of `host.diagnosis.stop_cause.Kind`."""
    at_s: float
    subsystem: str = ""
    task: str = ""
    step: int = 0
    action: str = ""
    index: int = -1
    suspect: str = ""
    path: str = ""
    line: int = 0
    traceback: str = ""
    waiting: tuple[tuple[str, str], ...] = ()
    """The flows that wait for this one, each with its tag."""
    courses: tuple[CourseView, ...] = ()
    choices: tuple[ChoiceView, ...] = ()
    """What can be done safely, likeliest first."""
    short: Reason = NOTHING
    """The text without where in a module it was said."""
    black_box: str = ""
    """The file on the runtime's machine in which the last seconds before it stand; empty: there is none, or not yet."""
    stands: tuple[Reason, ...] = ()
    """Where the arms of the flow stood, each a sentence."""
    touches: tuple[Reason, ...] = ()
    """What was in their way."""


class JumpView(View, frozen=True):
    """The largest step of an input of a hardware task where what drives it was exchanged, and what became of them."""

    subsystem: str
    task: str
    variable: str
    """With its element."""
    unit: str
    jump: float
    limit: float
    """What one cycle may change it by; 0: nobody says."""
    at_s: float
    count: int
    """At how many switches it was measured."""
    blended: int = 0
    """At how many of them it was blended."""
    cycles: int = 0
    """Over how many cycles at most."""
    refused: int = 0
    """At how many it was too large for that, and the drive has held."""


class RunView(View, frozen=True):
    """A run of an application that goes on now, or is over."""

    doc: str
    """The application; it may be closed meanwhile."""
    name: str
    number: int
    """Which run of this environment it is, from 1."""
    state: Literal["beginning", "running", "over"] = "beginning"
    began_at_s: float = 0.0
    """Seconds since 1970."""
    flows: dict[str, FlowRunView] = field(default_factory=dict)
    """By their subsystems."""
    steps: dict[str, StepRunView] = field(default_factory=dict)
    """By the numbers of the steps."""
    asks: dict[str, AskView] = field(default_factory=dict)
    """What tasks want to be told, by `SUBSYSTEM/TASK`."""
    stops: dict[str, StopView] = field(default_factory=dict)
    """Standstills, by subsystem; the end of the run under the empty one."""
    meets: tuple[MeetView, ...] = ()
    notes: tuple[Reason, ...] = ()
    """Warnings and other things worth knowing, newest last."""
    is_completed: bool = False
    cause: Reason = NOTHING
    """Why it ended before its time."""
    can_go_on: bool = False
    """Whether the next run may begin where this one ended before its time."""
    done: int = 0
    of: int = 0
    took_s: float = 0.0
    """Of the run's own clock, once it is over."""
    jumps: tuple[JumpView, ...] = ()
    """How far inputs of hardware have stepped at switches, once it is over (X04)."""
    recording: str = ""
    """The file in which it is recorded; empty: it is not."""
    recorded_bytes: int = 0
    """Of that file, once the run is over; 0: it is not there."""
    black_box: str = ""
    """The file on the runtime's machine in which its last seconds stand, once it has ended badly; empty: none."""
    repeats_until_s: float = 0.0
    """Up to when it is a recorded run again, before it goes on as it is steered; 0: it is a run of its own."""
    steps_by_task: dict[str, tuple[int, ...]] = field(default_factory=dict)
    """By `SUBSYSTEM/TASK`: the steps of the application in which it is ON."""
    station: str = ""
    """Where it is carried out; empty: at the first station."""
    puzzle: PuzzleResultView | None = None
    """What came of it, once it is over, where it was to solve a puzzle."""
