"""Shows the events of a runtime as console lines."""

from collections.abc import Iterator

from onika.desk.console.display import Tone
from onika.desk.console.value import shown
from onika.desk.run import explanation_text, transfer_text
from onika.desk.run.positions import waits
from onika.wire import event

Line = tuple[str, Tone]

_STATES = {"ON": Tone.GOOD, "ERROR": Tone.FAULT, "ASKING": Tone.ASK}


def lines(message: event.Event) -> Iterator[Line]:
    """The lines of an event; none for those that only machines want."""
    match message:
        case event.Began():
            yield f"{_at(message.at_s)}  {message.index + 1}/{message.of}  {message.action}", Tone.PLAIN
        case event.TaskState():
            yield (
                f"{_at(message.at_s)}  {message.subsystem}/{message.task} {message.state}",
                _STATES.get(message.state, Tone.DIM),
            )
        case event.Warned() | event.Stepped():
            yield from _noted(message)
        case event.Failed():
            yield from _failed(message)
        case event.Asked():
            yield from _asked(message)
        case event.Drive():
            yield from _drive(message)
        case event.Signalled():
            number = f" {message.number}" if message.kind in ("FINISH", "USER") else ""
            text = f": {message.text}" if message.text else ""
            yield (
                f"{_at(message.at_s)}  {message.subsystem}/{message.task} signals {message.kind}{number}{text}",
                Tone.NOTE,
            )
        case event.Moved() | event.Met() | event.Explained():
            yield from _flows(message)
        case event.Lost():
            yield f"{_at(message.at_s)}  LOST {message.name}: {message.cause}", Tone.FAULT
        case event.Held() | event.Offered():
            yield _held(message)
        case event.Stopped():
            yield _stopped(message)
        case event.Result():
            yield from _result(message)


def question(message: event.Asked, item: event.Item) -> str:
    """What a task asks for: name, type, meaning, unit, bounds and default."""
    kind = item.type if item.count == 1 else f"{item.type}[{item.count}]"
    parts = [f"{item.name} {kind}" + ("" if item.unit in ("", "-") else f" in {item.unit}"), item.meaning]
    low, high = (None if bound is None else " ".join(f"{x:g}" for x in bound) for bound in (item.low, item.high))
    if low is not None and high is not None:
        parts.append(f"from {low} to {high}")
    elif low is not None or high is not None:
        parts.append(f"at least {low}" if low is not None else f"at most {high}")
    if item.default is not None:
        parts.append(f"else {' '.join(map(str, item.default))}")
    return f"{message.subsystem}/{message.task} asks for " + ", ".join(part for part in parts if part)


def _flows(message: event.Moved | event.Met | event.Explained) -> Iterator[Line]:
    """What flows do: where they wait, where they meet, why they stand still."""
    match message:
        case event.Moved():
            yield from _moved(message)
        case event.Met():
            tag, names = message.tag.rpartition(" ")[2], " and ".join(message.subsystems)
            yield f"{_at(message.at_s)}  {names} go on together at {tag}, {message.skew_us:.0f} us apart", Tone.DIM
        case event.Explained():
            for line in explanation_text.lines(message):
                yield line, Tone.FAULT if message.choices else Tone.NOTE


def _moved(moved: event.Moved) -> Iterator[Line]:
    """What is worth a line; actions that begin, errors and the end have their own."""
    text = "" if moved.state == "stopped" else moved.text  # the error and its explanation stand beside it
    if moved.state in ("waiting", "joining"):
        text = waits(moved.tag, moved.waits_for)
    elif moved.state == "paused":
        text = f"is paused after {moved.action + 1}" if moved.action >= 0 else "is paused before its first action"
    if text:
        yield f"{_at(moved.at_s)}  {moved.subsystem} {text}", Tone.NOTE


def _at(seconds: float) -> str:
    return f"{seconds:9.2f} s"


def _noted(message: event.Warned | event.Stepped) -> Iterator[Line]:
    """What is worth knowing; a step that was no larger than it may be is not."""
    if isinstance(message, event.Warned):
        who = f"{message.subsystem}/{message.task}: " if message.task else ""
        yield f"{_at(message.at_s)}  note: {who}{message.text}", Tone.NOTE
    elif message.is_too_far:
        yield f"{_at(message.at_s)}  note: {message.subsystem}/{transfer_text.sentence(message)}", Tone.NOTE


def _failed(failed: event.Failed) -> Iterator[Line]:
    """The error, its place, the traceback with its source lines, and the values of that cycle (requirement A18)."""
    where = f" ({failed.path}:{failed.line})" if failed.line else ""
    yield f"{_at(failed.at_s)}  ERROR {failed.subsystem}/{failed.task}: {failed.text}{where}", Tone.FAULT
    for line in failed.traceback.rstrip().splitlines():
        yield f"    {line}", Tone.DIM
    for name in sorted(failed.values):
        for line in shown(name, failed.values[name]):
            yield f"    {line}", Tone.DIM


def _asked(message: event.Asked) -> Iterator[Line]:
    if message.reason:
        yield f"{_at(message.at_s)}  {message.subsystem}/{message.task}: {message.reason}", Tone.ASK
    for item in message.items:
        yield f"{_at(message.at_s)}  {question(message, item)}", Tone.ASK


def _drive(drive: event.Drive) -> Iterator[Line]:
    text = f"{_at(drive.at_s)}  drive {drive.device} {drive.state}" + (f": {drive.cause}" if drive.cause else "")
    yield text, Tone.FAULT if drive.state in ("TRIPPED", "PRESSED") else Tone.DIM


def _stopped(stopped: event.Stopped) -> Line:
    cause = f": {stopped.cause}" if stopped.cause else ""
    if stopped.is_stopped:
        return f"STOPPED{cause}; every drive holds until `reset`", Tone.FAULT
    return f"motion is allowed again{cause}", Tone.GOOD


def _held(message: event.Held | event.Offered) -> Line:
    """Who may change a subsystem, or is to."""
    if isinstance(message, event.Held):
        cause = f": {message.cause}" if message.cause else ""
        return f"{message.subsystem} is held by {message.holder or 'nobody'}{cause}", Tone.NOTE
    text = f"{message.holder} offers {message.subsystem} to {message.to or 'nobody'}"
    if message.outcome:
        return f"{text}: {message.outcome}", Tone.NOTE
    return f"{text}, who may `take {message.subsystem}` or `decline {message.subsystem}`", Tone.ASK


def _result(result: event.Result) -> Iterator[Line]:
    how = "completed" if result.completed else "aborted"
    text = f"{_at(result.runtime_s)}  run {how}, {result.done} of {result.of} actions"
    yield text + (f": {result.cause}" if result.cause else ""), Tone.GOOD if result.completed else Tone.FAULT
