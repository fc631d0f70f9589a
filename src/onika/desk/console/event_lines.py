"""What a runtime tells, as lines of a console."""

from collections.abc import Iterator

from onika.desk.console.display import Tone
from onika.desk.console.value import shown
from onika.desk.run import explanation_text, transfer_text
from onika.desk.run.positions import waits
from onika.wire import event

Line = tuple[str, Tone]

_STATES = {"ON": Tone.GOOD, "ERROR": Tone.FAULT, "ASKING": Tone.ASK}


def lines(one: event.Event) -> Iterator[Line]:
    """The lines of an event; none for those that only machines want."""
    match one:
        case event.Began():
            yield f"{_at(one.at_s)}  {one.index + 1}/{one.of}  {one.action}", Tone.PLAIN
        case event.TaskState():
            yield f"{_at(one.at_s)}  {one.subsystem}/{one.task} {one.state}", _STATES.get(one.state, Tone.DIM)
        case event.Warned() | event.Stepped():
            yield from _noted(one)
        case event.Failed():
            yield from _failed(one)
        case event.Asked():
            yield from _asked(one)
        case event.Drive():
            yield from _drive(one)
        case event.Signalled():
            number = f" {one.number}" if one.kind in ("FINISH", "USER") else ""
            text = f": {one.text}" if one.text else ""
            yield f"{_at(one.at_s)}  {one.subsystem}/{one.task} signals {one.kind}{number}{text}", Tone.NOTE
        case event.Moved() | event.Met() | event.Explained():
            yield from _flows(one)
        case event.Lost():
            yield f"{_at(one.at_s)}  LOST {one.name}: {one.cause}", Tone.FAULT
        case event.Held() | event.Offered():
            yield _held(one)
        case event.Stopped():
            yield _stopped(one)
        case event.Result():
            yield from _result(one)


def question(asked: event.Asked, item: event.Item) -> str:
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
    return f"{asked.subsystem}/{asked.task} asks for " + ", ".join(part for part in parts if part)


def _flows(one: event.Moved | event.Met | event.Explained) -> Iterator[Line]:
    """What flows do: where they wait, where they meet, why they stand still."""
    match one:
        case event.Moved():
            yield from _moved(one)
        case event.Met():
            tag, names = one.tag.rpartition(" ")[2], " and ".join(one.subsystems)
            yield f"{_at(one.at_s)}  {names} go on together at {tag}, {one.skew_us:.0f} us apart", Tone.DIM
        case event.Explained():
            for line in explanation_text.lines(one):
                yield line, Tone.FAULT if one.choices else Tone.NOTE


def _moved(one: event.Moved) -> Iterator[Line]:
    """What is worth a line; actions that begin, errors and the end have their own."""
    said = "" if one.state == "stopped" else one.text  # the error and its explanation stand beside it
    if one.state in ("waiting", "joining"):
        said = waits(one.tag, one.waits_for)
    elif one.state == "paused":
        said = f"is paused after {one.action + 1}" if one.action >= 0 else "is paused before its first action"
    if said:
        yield f"{_at(one.at_s)}  {one.subsystem} {said}", Tone.NOTE


def _at(seconds: float) -> str:
    return f"{seconds:9.2f} s"


def _noted(one: event.Warned | event.Stepped) -> Iterator[Line]:
    """What is worth knowing; a step that was no larger than it may be is not."""
    if isinstance(one, event.Warned):
        who = f"{one.subsystem}/{one.task}: " if one.task else ""
        yield f"{_at(one.at_s)}  note: {who}{one.text}", Tone.NOTE
    elif one.is_too_far:
        yield f"{_at(one.at_s)}  note: {one.subsystem}/{transfer_text.sentence(one)}", Tone.NOTE


def _failed(one: event.Failed) -> Iterator[Line]:
    """The error, its place, the traceback with its source lines, and the values of that cycle (requirement A18)."""
    where = f" ({one.path}:{one.line})" if one.line else ""
    yield f"{_at(one.at_s)}  ERROR {one.subsystem}/{one.task}: {one.text}{where}", Tone.FAULT
    for line in one.traceback.rstrip().splitlines():
        yield f"    {line}", Tone.DIM
    for name in sorted(one.values):
        for line in shown(name, one.values[name]):
            yield f"    {line}", Tone.DIM


def _asked(one: event.Asked) -> Iterator[Line]:
    if one.reason:
        yield f"{_at(one.at_s)}  {one.subsystem}/{one.task}: {one.reason}", Tone.ASK
    for item in one.items:
        yield f"{_at(one.at_s)}  {question(one, item)}", Tone.ASK


def _drive(one: event.Drive) -> Iterator[Line]:
    text = f"{_at(one.at_s)}  drive {one.device} {one.state}" + (f": {one.cause}" if one.cause else "")
    yield text, Tone.FAULT if one.state in ("TRIPPED", "PRESSED") else Tone.DIM


def _stopped(one: event.Stopped) -> Line:
    cause = f": {one.cause}" if one.cause else ""
    if one.is_stopped:
        return f"STOPPED{cause}; every drive holds until `reset`", Tone.FAULT
    return f"motion is allowed again{cause}", Tone.GOOD


def _held(one: event.Held | event.Offered) -> Line:
    """Who may change a subsystem, or is to."""
    if isinstance(one, event.Held):
        cause = f": {one.cause}" if one.cause else ""
        return f"{one.subsystem} is held by {one.holder or 'nobody'}{cause}", Tone.NOTE
    text = f"{one.holder} offers {one.subsystem} to {one.to or 'nobody'}"
    if one.outcome:
        return f"{text}: {one.outcome}", Tone.NOTE
    return f"{text}, who may `take {one.subsystem}` or `decline {one.subsystem}`", Tone.ASK


def _result(one: event.Result) -> Iterator[Line]:
    how = "completed" if one.completed else "aborted"
    text = f"{_at(one.runtime_s)}  run {how}, {one.done} of {one.of} actions"
    yield text + (f": {one.cause}" if one.cause else ""), Tone.GOOD if one.completed else Tone.FAULT
