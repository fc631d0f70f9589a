"""What a runtime tells while it runs a plan: signals on their way to the user, numbered by the link, never lost.

Times are seconds since the run's start in the runtime's own time.
"""

from typing import Any

import msgspec
from msgspec import Struct

from onika.wire.figures import TaskFigures, VariableSteps
from onika.wire.holding import SessionStanding
from onika.words.reason import NOTHING, Reason


class Began(Struct, frozen=True, tag=True):
    """An action begins; `index` counts from 0."""

    flow: int
    index: int
    of: int
    action: str
    at_s: float
    run: str = ""
    """The subsystem of the first flow of its run: several run side by side."""


class Done(Struct, frozen=True, tag=True):
    """An action has finished."""

    flow: int
    index: int
    at_s: float
    run: str = ""
    """As in `Began`."""


class TaskState(Struct, frozen=True, tag=True):
    """A task's state has changed."""

    subsystem: str
    task: str
    state: str
    at_s: float


class Warned(Struct, frozen=True, tag=True):
    """A warning of a task, or something worth knowing about the run (task empty)."""

    subsystem: str
    task: str
    text: Reason
    at_s: float


class Failed(Struct, frozen=True, tag=True):
    """A task is in ERROR: what its code said and where."""

    subsystem: str
    task: str
    text: Reason
    path: str
    line: int
    traceback: str
    at_s: float
    entry: str = ""
    """The entry point that failed."""
    values: dict[str, Any] = {}
    """The task's ports at that moment, arrays as lists (A18)."""


class Item(Struct, frozen=True):
    """One value or vector that is asked for."""

    name: str
    type: str
    count: int
    unit: str
    meaning: str
    default: tuple[Any, ...] | None
    low: tuple[float, ...] | None
    high: tuple[float, ...] | None


class Asked(Struct, frozen=True, tag=True):
    """A task waits for user input."""

    subsystem: str
    task: str
    reason: Reason
    items: tuple[Item, ...]
    at_s: float


class Drive(Struct, frozen=True, tag=True):
    """A drive's state has changed, in the world's own time: at which step, the step before, the last command."""

    device: str
    state: str
    at_ns: int
    previous_step_ns: int
    last_command_ns: int
    cause: Reason
    at_s: float = 0.0
    """As all else: of the run that uses the device, or of the runtime where none does."""
    stands: Reason = NOTHING
    """Where the device stands that begins to hold, as far as its world knows."""
    touches: tuple[Reason, ...] = ()
    """What it presses against then, each a sentence."""


class Mishap(Struct, frozen=True, tag=True):
    """In a simulated world that is watched, something has happened that no program means (E16)."""

    world: str
    text: Reason
    devices: tuple[str, ...]
    """Those to which it happened, `world:device`."""
    at_s: float
    """When it began: of the run that uses the first of the devices, or of the runtime where none does."""
    poses: bytes
    """Where the bodies of the world were then, float32[bodies,7]."""
    lit: tuple[str, ...] = ()
    """The shapes of it that shone then."""


class Edited(Struct, frozen=True, tag=True):
    """The outcome of an accepted change of a subsystem; no cause: it is done."""

    subsystem: str
    number: int
    cause: Reason
    at_s: float


class Signalled(Struct, frozen=True, tag=True):
    """An ILLEGAL, LEGAL, SHUTDOWN, FINISH or user signal of a task that no application answers (Table 9)."""

    subsystem: str
    task: str
    kind: str
    number: int
    text: Reason
    at_s: float


class Lost(Struct, frozen=True, tag=True):
    """A process of the runtime is gone, and why; its tasks are."""

    name: str
    cause: Reason
    at_s: float


class UnitUp(Struct, frozen=True, tag=True):
    """A processing unit is up that was added, or started anew after its loss; it is empty."""

    name: str
    at_s: float


class Outdated(Struct, frozen=True, tag=True):
    """The files of an open world say something else than what was loaded; or, if not `is_outdated`, the same again."""

    world: str
    is_outdated: bool
    text: Reason
    """Which file it is, as a sentence."""
    at_s: float


class Held(Struct, frozen=True, tag=True):
    """The holder of a subsystem has changed; empty: nobody holds it."""

    subsystem: str
    holder: str
    cause: Reason = NOTHING
    """Why, where that is worth a word: it was handed over, or the holder is not heard any more."""


class Offered(Struct, frozen=True, tag=True):
    """A holder offers a subsystem to another session; with an outcome the offer is over."""

    subsystem: str
    holder: str
    to: str
    outcome: Reason = NOTHING


class Company(Struct, frozen=True, tag=True):
    """Who is there now; told to those who attend to `holding.COMPANY`."""

    sessions: tuple[SessionStanding, ...]


class Stopped(Struct, frozen=True, tag=True):
    """Everything was stopped, by whom and why; or may move again (is_stopped false)."""

    is_stopped: bool
    cause: Reason


class Moved(Struct, frozen=True, tag=True):
    """A flow has come into another state (`engine.flow` has the words); where it waits, the tag and for whom."""

    subsystem: str
    state: str
    action: int
    """The current action, or the last one; -1 before the first."""
    at_s: float
    tag: str = ""
    waits_for: tuple[str, ...] = ()
    text: Reason = NOTHING
    """Why, where that is worth a word."""


class Met(Struct, frozen=True, tag=True):
    """Flows have begun together at a tag; `skew_us` lies between the first cycles of the first and the last of them."""

    tag: str
    subsystems: tuple[str, ...]
    skew_us: float
    at_s: float


class Stood(Struct, frozen=True, tag=True):
    """The clock of a held run stands, and everything that was asked is carried out; `steer.Onward` lets it go on."""

    at_s: float


class Course(Struct, frozen=True):
    """The last seconds of one variable, oldest first."""

    variable: str
    unit: str
    at_s: tuple[float, ...]
    values: tuple[Any, ...]


class Stepped(Struct, frozen=True, tag=True):
    """How far an input of a hardware task has stepped at a reconfiguration (X04); in a run only if it was too far."""

    subsystem: str
    task: str
    variable: str
    unit: str
    index: int
    """The element that stepped farthest, as a share of what it may."""
    step: float
    """From one cycle to the next, as it was wanted."""
    given: float
    """The largest step that reached the task."""
    limit: float
    """What one cycle may change it by; 0: nobody has said."""
    cycles: int
    """Over how many cycles it was blended; 0: it was not."""
    at_s: float

    @property
    def is_too_far(self) -> bool:
        """Whether it was more than one cycle may change."""
        return 0.0 < self.limit < self.step


class Explained(Struct, frozen=True, tag=True):
    """Why a flow stands still or the run ends: the chain from the task to whoever waits, and what can be done (X06)."""

    subsystem: str
    task: str
    """Empty where no task is the cause."""
    action: str
    index: int
    place: str
    """The application's file and line."""
    text: Reason
    path: str
    """The module's file and line, where its code raised; else empty and 0."""
    line: int
    waiting: tuple[tuple[str, str], ...]
    """The flows that wait for this one, each with its tag."""
    courses: tuple[Course, ...]
    choices: tuple[tuple[str, Reason], ...]
    """What can be done safely: the command, and what it does."""
    at_s: float
    kind: str = ""
    """What sort of cause it is: a word of `host.diagnosis.stop_cause.Kind`."""
    suspect: str = ""
    """The task upstream from which the trouble likely comes; empty: from nobody else."""
    run: str = ""
    """As in `Began`."""


class LastSecondsKept(Struct, frozen=True, tag=True):
    """The last seconds before what an `Explained` of a run that goes on has told are written (X05)."""

    subsystem: str
    at_s: float
    """Both as in that `Explained`."""
    path: str
    """The file on the runtime's machine."""
    run: str = ""
    """As in `Began`."""


class Recording(Struct, frozen=True, tag=True):
    """A subsystem that is held by hand is recorded from now on, or no more (X05)."""

    subsystem: str
    at_s: float
    path: str
    """The file on the runtime's machine."""
    is_on: bool
    cause: Reason = NOTHING
    """Why it has ended, where nobody asked for that."""
    lasted_s: float = 0.0
    """How much of the time of the subsystem is in it, where it has ended."""


class Result(Struct, frozen=True, tag=True):
    """The end of a run: always the last event."""

    completed: bool
    cause: Reason
    done: int
    of: int
    runtime_s: float
    wall_s: float
    values: dict[str, Any]
    tasks: tuple[TaskFigures, ...]
    hash: str
    """Of a virtual run: everything that happened and the worlds every 50 ms, as SHA-256; else empty."""
    skews_us: tuple[float, ...] = ()
    """At each meeting of flows, between the first cycles of the first and the last of them."""
    switches_us: tuple[float, ...] = ()
    """From each trigger's finish to the first cycle of the next action's tasks, in the runtime's time."""
    outside: tuple[str, ...] = ()
    """Of a virtual run: the tasks, SUBSYSTEM/TASK, that had to do with the outside, so that it may not repeat."""
    steps: tuple[VariableSteps, ...] = ()
    """What the inputs of hardware tasks have stepped by where what drives them was exchanged (X04)."""
    black_box: str = ""
    """The file on the runtime's machine in which the last seconds of a run stand that ended badly; empty: none."""
    remarks: tuple[Reason, ...] = ()
    """Of a completed run: what went wrong while its tasks were being ended, after its last action."""
    run: str = ""
    """As in `Began`."""


Event = (
    Began
    | Done
    | TaskState
    | Warned
    | Failed
    | Asked
    | Drive
    | Mishap
    | Moved
    | Met
    | Stepped
    | Explained
    | LastSecondsKept
    | Recording
    | Result
    | Edited
    | Signalled
    | Lost
    | UnitUp
    | Outdated
    | Held
    | Offered
    | Company
    | Stopped
    | Stood
)

encode = msgspec.msgpack.Encoder().encode
decode = msgspec.msgpack.Decoder(Event).decode
