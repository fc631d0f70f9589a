"""What an RTPU tells the runner, one datagram each: signals, answers, status. Never merged, never dropped."""

from typing import Any

import msgspec
from msgspec import Struct

from onika.runtime.user_input import AskedItem


class TaskStatus(Struct, frozen=True):
    """The figures of one task (requirement A11); counters count since the last status, times in microseconds."""

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


class Initialised(Struct, frozen=True, tag=True):
    """A task is OFF after `init`."""

    subsystem: str
    task: str


class Changed(Struct, frozen=True, tag=True):
    """A task's state by command or by its own OFF signal (`signal`)."""

    subsystem: str
    task: str
    state: str
    now_ns: int
    signal: str = ""


class Cycled(Struct, frozen=True, tag=True):
    """The first cycle of a task after it came on."""

    subsystem: str
    task: str
    at_ns: int


class Finished(Struct, frozen=True, tag=True):
    """A FINISH signal: the task is OFF."""

    subsystem: str
    task: str
    flow: int
    loop: bool
    now_ns: int


class Failed(Struct, frozen=True, tag=True):
    """An ERROR signal: the task is in ERROR; where its code raised, what it said."""

    subsystem: str
    task: str
    entry: str
    text: str
    path: str
    line: int
    traceback: str
    now_ns: int


class Warned(Struct, frozen=True, tag=True):
    """A WARNING signal."""

    subsystem: str
    task: str
    text: str
    now_ns: int


class Signalled(Struct, frozen=True, tag=True):
    """An ILLEGAL, LEGAL, SHUTDOWN or user signal."""

    subsystem: str
    task: str
    kind: str
    number: int
    text: str
    now_ns: int


class Asked(Struct, frozen=True, tag=True):
    """A task is ASKING: what for, and what was wrong with what it got."""

    subsystem: str
    task: str
    reason: str
    items: tuple[AskedItem, ...]
    now_ns: int


class Refused(Struct, frozen=True, tag=True):
    """A command was not carried out."""

    subsystem: str
    task: str
    command: str
    reason: str


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


News = Initialised | Changed | Cycled | Finished | Failed | Warned | Signalled | Asked | Refused | Got | Statuses


def _plain(value: Any) -> Any:
    """What a module may hand out by `get` and msgpack does not know: arrays and NumPy's numbers, else as text."""
    return value.tolist() if hasattr(value, "tolist") else str(value)


encode = msgspec.msgpack.Encoder(enc_hook=_plain).encode
decode = msgspec.msgpack.Decoder(News).decode
