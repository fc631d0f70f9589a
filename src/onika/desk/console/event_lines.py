"""Shows the events of a runtime as console lines."""

from collections.abc import Callable, Iterator

from onika.desk.console.display import Tone
from onika.desk.run import explanation_text, transfer_text
from onika.desk.run.item_text import bounds, default
from onika.desk.run.positions import waits
from onika.desk.run.value_text import shown
from onika.wire import event
from onika.words.reason import NOTHING, Reason

Line = tuple[Reason, Tone]

_STATES = {"ON": Tone.GOOD, "ERROR": Tone.FAULT, "ASKING": Tone.ASK}


def lines(message: event.Event, say: Callable[[Reason], str] = str) -> Iterator[Line]:
    """The lines of an event; none for those that only machines want. `say` makes the words of a block of lines."""
    match message:
        case event.Began() | event.TaskState() | event.Signalled() | event.Drive():
            yield _step(message)
        case event.Warned() | event.Stepped() | event.Outdated():
            yield from _noted(message)
        case event.Failed():
            yield from _failed(message)
        case event.Asked():
            yield from _asked(message)
        case event.Moved() | event.Met() | event.Explained():
            yield from _flows(message, say)
        case event.Lost() | event.UnitUp():
            yield _process(message)
        case event.Held() | event.Offered() | event.SlotEnds() | event.ClockSet():
            yield _held(message)
        case event.LastSecondsKept() | event.Recording():
            yield _recording(message)
        case event.Stopped():
            yield _stopped(message)
        case event.Result():
            for name in sorted(message.values):
                yield from ((Reason.plain(line), Tone.PLAIN) for line in shown(name, message.values[name]))
            yield _result(message)


def _process(message: event.Lost | event.UnitUp) -> Line:
    """A process of the runtime is gone, or a unit is there."""
    if isinstance(message, event.Lost):
        return _timed(message.at_s, Reason.of("console.lost", name=message.name, cause=message.cause)), Tone.FAULT
    return _timed(message.at_s, Reason.of("console.unit_up", name=message.name)), Tone.NOTE


def _recording(message: event.LastSecondsKept | event.Recording) -> Line:
    """Last seconds are kept; or a subsystem is recorded from now on, or no more."""
    if isinstance(message, event.LastSecondsKept):
        return _timed(message.at_s, Reason.of("console.last_seconds", path=message.path)), Tone.NOTE
    subsystem, path = message.subsystem, message.path
    if message.is_on:
        return _timed(message.at_s, Reason.of("console.recording_began", subsystem=subsystem, path=path)), Tone.NOTE
    because = _because(message.cause)
    ended = Reason.of("console.recording_ended", path=path, seconds=message.lasted_s, because=because)
    return _timed(message.at_s, ended), Tone.FAULT if message.cause else Tone.NOTE


def _step(message: event.Began | event.TaskState | event.Signalled | event.Drive) -> Line:
    """What the course of things brings: an action, a task's state, its signal, a drive."""
    match message:
        case event.Began():
            action = f"{_at(message.at_s)}  {message.index + 1}/{message.of}  {message.action}"
            return Reason.plain(action), Tone.PLAIN
        case event.TaskState():
            text = f"{_at(message.at_s)}  {message.subsystem}/{message.task} {message.state}"
            return Reason.plain(text), _STATES.get(message.state, Tone.DIM)
        case event.Signalled():
            signal = f"{message.kind} {message.number}" if message.kind in ("FINISH", "USER") else message.kind
            task, because = f"{message.subsystem}/{message.task}", _because(message.text)
            signals = Reason.of("console.signals", task=task, signal=signal, because=because)
            return _timed(message.at_s, signals), Tone.NOTE
        case event.Drive():
            because = _because(message.cause)
            drive = Reason.of("console.drive", device=message.device, state=message.state, because=because)
            return _timed(message.at_s, drive), Tone.FAULT if message.state in ("TRIPPED", "PRESSED") else Tone.DIM


def question(message: event.Asked, item: event.Item) -> Reason:
    """What a task asks for: name, type, meaning, unit, bounds and default."""
    parts: list[Reason] = [_name_and_type(item)]
    if item.meaning:
        parts.append(Reason.plain(item.meaning))
    parts.extend(limits for limits in (bounds(item), default(item)) if limits)
    return Reason.of("console.asks_for", task=f"{message.subsystem}/{message.task}", parts=tuple(parts))


def _name_and_type(item: event.Item) -> Reason:
    count = f"[{item.count}]" if item.count != 1 else ""
    name = f"{item.name} {item.type}{count}"
    if item.unit in ("", "-"):
        return Reason.plain(name)
    return Reason.of("console.in_unit", name=name, unit=item.unit)


def _flows(message: event.Moved | event.Met | event.Explained, say: Callable[[Reason], str]) -> Iterator[Line]:
    """What flows do: where they wait, where they meet, why they stand still."""
    match message:
        case event.Moved():
            yield from _moved(message)
        case event.Met():
            tag, names = message.tag.rpartition(" ")[2], tuple(message.subsystems)
            met = Reason.of("console.met", names=names, tag=tag, skew_us=message.skew_us)
            yield _timed(message.at_s, met), Tone.DIM
        case event.Explained():
            for line in explanation_text.lines(message, say=say):
                yield Reason.plain(line), Tone.FAULT if message.choices else Tone.NOTE


def _moved(moved: event.Moved) -> Iterator[Line]:
    """What is worth a line; actions that begin, errors and the end have their own."""
    flow = moved.subsystem
    if moved.state in ("waiting", "joining"):
        waiting = Reason.of("console.flow_does", flow=flow, what=waits(moved.tag, moved.waits_for))
        yield _timed(moved.at_s, waiting), Tone.NOTE
    elif moved.state == "paused" and moved.action >= 0:
        yield _timed(moved.at_s, Reason.of("console.paused_after", flow=flow, action=moved.action + 1)), Tone.NOTE
    elif moved.state == "paused":
        yield _timed(moved.at_s, Reason.of("console.paused_before", flow=flow)), Tone.NOTE
    elif moved.text and moved.state != "stopped":  # the error and its explanation stand beside it
        yield _timed(moved.at_s, Reason.of("console.flow_does", flow=flow, what=moved.text)), Tone.NOTE


def _at(seconds: float) -> str:
    return f"{seconds:9.2f} s"


def _timed(at_s: float, line: Reason) -> Reason:
    return Reason.of("console.timed", at=_at(at_s), line=line)


def _because(cause: Reason) -> Reason:
    """A cause behind a colon; nothing where none is given."""
    if cause:
        return Reason.of("console.because", cause=cause)
    return NOTHING


def _noted(message: event.Warned | event.Stepped | event.Outdated) -> Iterator[Line]:
    """What is worth knowing; a step that was no larger than it may be is not."""
    if isinstance(message, event.Warned):
        text = message.text
        if message.task:
            text = Reason.of("console.task_reason", task=f"{message.subsystem}/{message.task}", reason=text)
        yield _timed(message.at_s, Reason.of("console.note", text=text)), Tone.NOTE
    elif isinstance(message, event.Outdated):
        yield _timed(message.at_s, Reason.of("console.note", text=message.text)), Tone.NOTE
    elif message.is_too_far:
        step = transfer_text.sentence_with_subsystem(message)
        yield _timed(message.at_s, Reason.of("console.note", text=step)), Tone.NOTE


def _failed(failed: event.Failed) -> Iterator[Line]:
    """The error, its place, the traceback with its source lines, and the values of that cycle (requirement A18)."""
    where = f" ({failed.path}:{failed.line})" if failed.line else ""
    task = f"{failed.subsystem}/{failed.task}"
    error = Reason.of("console.task_error", task=task, text=failed.text, where=where)
    yield _timed(failed.at_s, error), Tone.FAULT
    for line in failed.traceback.rstrip().splitlines():
        yield Reason.plain(f"    {line}"), Tone.DIM
    for name in sorted(failed.values):
        for line in shown(name, failed.values[name]):
            yield Reason.plain(f"    {line}"), Tone.DIM


def _asked(message: event.Asked) -> Iterator[Line]:
    if message.reason:
        task = f"{message.subsystem}/{message.task}"
        yield _timed(message.at_s, Reason.of("console.task_reason", task=task, reason=message.reason)), Tone.ASK
    for item in message.items:
        yield _timed(message.at_s, question(message, item)), Tone.ASK


def _stopped(stopped: event.Stopped) -> Line:
    because = _because(stopped.cause)
    if stopped.is_stopped:
        return Reason.of("console.stopped", because=because), Tone.FAULT
    return Reason.of("console.motion_allowed", because=because), Tone.GOOD


def _slot(message: event.SlotEnds | event.ClockSet) -> Line:
    """Whose time with the robot ends."""
    if isinstance(message, event.ClockSet):
        return Reason.of("booking.clock_set", seconds=message.by_s), Tone.NOTE
    if message.left_s <= 0:
        return Reason.of("booking.over", user=message.user, follower=message.follower), Tone.NOTE
    minutes = max(1, round(message.left_s / 60))
    return Reason.of("booking.ends", user=message.user, minutes=minutes, follower=message.follower), Tone.NOTE


def _held(message: event.Held | event.Offered | event.SlotEnds | event.ClockSet) -> Line:
    """Who may change a subsystem, or is to; whose time with the robot ends."""
    if isinstance(message, event.SlotEnds | event.ClockSet):
        return _slot(message)
    subsystem = message.subsystem
    if isinstance(message, event.Held):
        because = _because(message.cause)
        if not message.holder:
            return Reason.of("console.held_by_nobody", subsystem=subsystem, because=because), Tone.NOTE
        return Reason.of("console.held", subsystem=subsystem, holder=message.holder, because=because), Tone.NOTE
    holder, to = message.holder, message.to or _nobody()
    if message.outcome:
        outcome = message.outcome
        return Reason.of("console.offered", holder=holder, subsystem=subsystem, to=to, outcome=outcome), Tone.NOTE
    return Reason.of("console.offers", holder=holder, subsystem=subsystem, to=to), Tone.ASK


def _nobody() -> Reason:
    return Reason.of("console.nobody")


def _done(result: event.Result) -> Reason:
    """How many actions; of how many, where there were no loops or branches."""
    if result.done == result.of or (result.done < result.of and not result.completed):
        return Reason.of("console.done_of", done=result.done, of=result.of)
    return Reason.of("console.done_times", done=result.done)


def _result(result: event.Result) -> Line:
    because = _because(result.cause)
    if result.completed:
        ending = Reason.of("console.completed", done=_done(result), because=because)
        return _timed(result.runtime_s, ending), Tone.GOOD
    ending = Reason.of("console.aborted", done=_done(result), because=because)
    return _timed(result.runtime_s, ending), Tone.FAULT
