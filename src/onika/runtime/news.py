"""The news that an RTPU sends to the runner, one datagram each: signals, answers, status. None is merged or dropped."""

from typing import Any, get_args

import msgspec
from msgspec import Struct, structs

from onika.runtime.load import TaskLoad
from onika.runtime.user_input import AskedItem
from onika.words.reason import Reason


class TaskStatus(Struct, frozen=True):
    """The figures of one task (requirement A11, dissertation §A.5 STATINFO); times in microseconds.

    `cycle`, `miss` and `warn` count since the last status; so does the profile (`profiled_s` and whatever follows it),
    over the time in which the task was ON. `tid` counts the tasks of this unit in the order of their coming.
    """

    subsystem: str
    task: str
    module: str
    state: str
    type: str
    crit: int
    cycle: int
    miss: int
    warn: int
    reference_hz: float
    measured_hz: float
    profiled_s: float
    total_us: float
    least_us: float
    mean_us: float
    most_us: float
    tid: int = 0
    tick_ms: float = 0.0
    """The resolution of the unit's clock."""

    @property
    def letter(self) -> str:
        """The type as `status` shows it: P periodic, Y synchronous, A aperiodic."""
        return {"periodic": "P", "synchronous": "Y"}.get(self.type, "A")

    @property
    def reference_ms(self) -> float:
        """The desired period; 0 without one."""
        if self.reference_hz:
            return 1e3 / self.reference_hz
        return 0.0

    @property
    def measured_ms(self) -> float:
        """The measured period; 0 without a cycle."""
        return 1e3 / self.measured_hz if self.measured_hz else 0.0

    def use(self, took_us: float) -> float:
        """The utilisation that a cycle of so many microseconds is: U = C / period, the measured one without a rate."""
        return took_us * 1e-6 * (self.reference_hz or self.measured_hz)


class Initialised(Struct, frozen=True, tag=True):
    """A task is OFF after `init`."""

    subsystem: str
    task: str


class Reinitialised(Struct, frozen=True, tag=True):
    """A task that is OFF has taken over its constants anew."""

    subsystem: str
    task: str


class Rebound(Struct, frozen=True, tag=True):
    """A task's ports are bound anew; it is to be reinitialised."""

    subsystem: str
    task: str


class Swapped(Struct, frozen=True, tag=True):
    """A task lives on with another module, whose source has this SHA-256."""

    subsystem: str
    task: str
    digest: str


class Changed(Struct, frozen=True, tag=True):
    """A task's state by command or by its own OFF signal (`signal`).

    `activation`, here and below, is that of the Launch with which the task came on, or tried to, last.
    """

    subsystem: str
    task: str
    state: str
    now_ns: int
    signal: str = ""
    activation: int = 0


class Cycled(Struct, frozen=True, tag=True):
    """The first cycle of a task after it came on."""

    subsystem: str
    task: str
    at_ns: int
    activation: int = 0


class Finished(Struct, frozen=True, tag=True):
    """A FINISH signal: the task is OFF."""

    subsystem: str
    task: str
    flow: int
    loop: bool
    now_ns: int
    activation: int = 0
    switched: int = 0
    """The number of the prepared case whose switch was carried out at once; what that led to follows. 0: none."""


class Unprepared(Struct, frozen=True, tag=True):
    """Nothing is prepared any more for a subsystem; what was carried out before has been told before."""

    subsystem: str


class Failed(Struct, frozen=True, tag=True):
    """An ERROR signal: the task is in ERROR; where its code raised, what it said."""

    subsystem: str
    task: str
    entry: str
    text: Reason
    path: str
    line: int
    traceback: str
    now_ns: int
    activation: int = 0
    values: dict[str, Any] = {}
    """Its ports when it failed: inputs as read, outputs as they stood; arrays as lists, long ones cut (A18)."""


class Warned(Struct, frozen=True, tag=True):
    """A WARNING signal."""

    subsystem: str
    task: str
    text: Reason
    now_ns: int


class Signalled(Struct, frozen=True, tag=True):
    """An ILLEGAL, LEGAL, SHUTDOWN or user signal."""

    subsystem: str
    task: str
    kind: str
    number: int
    text: Reason
    now_ns: int
    activation: int = 0


class Stepped(Struct, frozen=True, tag=True):
    """How far an input of a hardware task has stepped at a reconfiguration, told when watching it is over (law 33).

    `step` is the largest from one cycle to the next, `given` the largest that reached the task, `limit` what one may
    be; 0: none is declared. `cycles` is over how many it was blended; 0: not at all.
    """

    subsystem: str
    task: str
    variable: str
    unit: str
    index: int
    step: float
    given: float
    limit: float
    cycles: int
    at_ns: int


class Asked(Struct, frozen=True, tag=True):
    """A task is ASKING: what for, and what was wrong with what it got."""

    subsystem: str
    task: str
    reason: Reason
    items: tuple[AskedItem, ...]
    now_ns: int
    activation: int = 0


class Refused(Struct, frozen=True, tag=True):
    """A command was not carried out."""

    subsystem: str
    task: str
    command: str
    reason: Reason


class Got(Struct, frozen=True, tag=True):
    """The answer to a Get or Set."""

    subsystem: str
    task: str
    name: str
    value: Any


class Statuses(Struct, frozen=True, tag=True):
    """The answer to a Report; `load` is the share of this RTPU's time that tasks took since the last one."""

    rtpu: str
    load: float
    tasks: tuple[TaskStatus, ...]


class Appointed(Struct, frozen=True, tag=True):
    """The time of an appointment is there: it has begun, or was not permitted, or it was too late.

    `drives`: a task of its subsystems has a device or an outside partner, so that what has begun moves something.
    """

    number: int
    at_ns: int
    has_begun: bool
    drives: bool = True


class HeldAlone(Struct, frozen=True, tag=True):
    """What began at an appointment is held: nobody had said in time that all others have begun."""

    number: int
    at_ns: int


class Loads(Struct, frozen=True, tag=True):
    """The answer to a Load: what the tasks of this RTPU cost, by the newest figures there are."""

    rtpu: str
    tasks: tuple[TaskLoad, ...]


TaskNews = (
    Initialised
    | Reinitialised
    | Rebound
    | Swapped
    | Changed
    | Cycled
    | Finished
    | Failed
    | Warned
    | Signalled
    | Stepped
    | Asked
    | Refused
)
"""Of one task, which each names."""

OF_TASKS = frozenset(get_args(TaskNews))
"""The same as kinds: to look one up is quicker than to ask for each of them, and every switch tells several."""

News = TaskNews | Unprepared | Got | Statuses | Loads | Appointed | HeldAlone


def _plain(value: Any) -> Any:
    """What a module may hand out by `get` and msgpack does not know: arrays and NumPy's numbers, else as text."""
    if hasattr(value, "tolist"):
        return value.tolist()
    return str(value)


_WITH_SENTENCES = frozenset((Failed, Warned, Signalled, Asked, Refused))

encode = msgspec.msgpack.Encoder(enc_hook=_plain).encode
decode = msgspec.msgpack.Decoder(News).decode


def in_english(word: News) -> News:
    """The news with its sentence in English alone: what a run is, and hashes to, knows no keys and no translations."""
    if type(word) not in _WITH_SENTENCES:
        return word
    match word:
        case Failed() | Warned() | Signalled():
            return structs.replace(word, text=str(word.text))
        case Asked() | Refused():
            return structs.replace(word, reason=str(word.reason))
    return word
