"""The cause of a stop: what happened, where, and whether the run ends by it (requirement X06).

Whoever runs an application makes one where a flow comes to stand still, or where the run ends before its time;
`host.diagnosis.explanation` tells the rest.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from onika.runtime import news
from onika.words.reason import Reason, every

_PRESSED = ("runtime.button_pressed", "runtime.button_still_pressed")


class CauseKind(Enum):
    """What sort of thing it was."""

    ERROR = "error"
    """A task is in ERROR."""
    PRESSED = "pressed"
    """So is a hardware task, because the panic button of its device is pressed."""
    TRIPPED = "tripped"
    """So is a hardware task, because the drive of its device has tripped."""
    ILLEGAL = "illegal"
    """A task says that it may not go on (signal ILLEGAL)."""
    SHUTDOWN = "shutdown"
    """A task demands the end (signal SHUTDOWN)."""
    REFUSED = "refused"
    """A task could not be spawned, cleared or turned on."""
    ASKING = "asking"
    """A task asks, and nobody is there to answer."""
    LOST = "lost"
    """A process of the runtime is gone."""
    DEADLOCK = "deadlock"
    """Flows wait for each other in a circle."""
    DESERTED = "deserted"
    """A flow waits for one that has ended, or stands still."""
    USER = "user"
    """Somebody wanted it."""


@dataclass(frozen=True)
class Cause:
    """One cause. `text` is what was said, without the place; `subsystem` is empty where no flow is meant."""

    kind: CauseKind
    text: Reason
    subsystem: str = ""
    task: str = ""
    path: str = ""
    line: int = 0
    """Where the module's code raised; else empty and 0."""
    entry: str = ""
    values: Mapping[str, Any] = field(default_factory=dict, hash=False)
    """The task's ports by their own names, as they were when it failed."""
    ends: bool = False
    """Whether the run ends by it: then nothing can be done any more."""


def of_failure(message: news.Failed, is_hardware: bool = False) -> Cause:
    """A task is in ERROR; of a hardware task what its module says tells whether its drive is the reason."""
    text = message.text
    if message.entry:
        text = Reason.of("host.entry_failed", entry=message.entry, why=message.text)
    kind = _of_drive(message.text) if is_hardware else CauseKind.ERROR
    return Cause(kind, text, message.subsystem, message.task, message.path, message.line, message.entry, message.values)


def of_signal(message: news.Signalled) -> Cause:
    """A task has signalled ILLEGAL or SHUTDOWN; raises ValueError for another signal."""
    if message.kind not in ("ILLEGAL", "SHUTDOWN"):
        raise ValueError(f"expected the signal ILLEGAL or SHUTDOWN, found {message.kind}")
    text = Reason.plain(message.kind)
    if message.text:
        text = Reason.of("host.signal_said", signal=message.kind, text=message.text)
    return Cause(CauseKind(message.kind.lower()), text, message.subsystem, message.task)


def of_refusal(message: news.Refused) -> Cause:
    """A command for a task was not carried out."""
    text = Reason.of("host.command_refused", command=message.command, why=message.reason)
    return Cause(CauseKind.REFUSED, text, message.subsystem, message.task)


def of_question(message: news.Asked) -> Cause:
    """A task asks, and what it was given does not answer it."""
    names = tuple(item.name for item in message.items)
    text = Reason.of("host.no_answer_fits", names=names)
    if message.reason:
        text = Reason.of("host.no_answer_fits_why", names=names, why=message.reason)
    return Cause(CauseKind.ASKING, text, message.subsystem, message.task)


def of_loss(text: Reason, tasks: Iterable[tuple[str, str]]) -> Cause:
    """A process is gone; the (subsystem, task) of the run in whose call it was is named, if the reason names it."""
    calls = {reason.args["task"] for reason in every(text) if "task" in reason.args}
    subsystem, task = next(((home, name) for home, name in tasks if f"{home}/{name}" in calls), ("", ""))
    return Cause(CauseKind.LOST, text, subsystem, task)


def is_of_pressed_button(text: Reason) -> bool:
    """Whether a panic button is what it is about."""
    return any(reason.key in _PRESSED for reason in every(text))


def _of_drive(text: Reason) -> CauseKind:
    if is_of_pressed_button(text):
        return CauseKind.PRESSED
    has_tripped = any(reason.key == "runtime.drive_tripped" for reason in every(text))
    return CauseKind.TRIPPED if has_tripped else CauseKind.ERROR
