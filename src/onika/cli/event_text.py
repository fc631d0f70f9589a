"""The text of a run for people: one sentence per event and the summary at the end, for terminals and plain text."""

from collections.abc import Iterator, Sequence

from onika.desk.run import explanation_text, transfer_text
from onika.desk.run.outcome import Outcome
from onika.desk.run.positions import waits
from onika.wire import event

_PRINTED = 20


def lines(happening: event.Event, total: int, flows: Sequence[str] = (), width: int = 80) -> Iterator[str]:
    """The lines of an event; none for those that only machines want.

    total   how many actions the longest flow has
    flows   the flows' subsystems; each is named where there are several
    width   columns that there are for what takes several lines
    """
    if isinstance(happening, event.Explained):
        yield from explanation_text.lines(happening, width)
    elif line := sentence(happening, total, flows):
        yield line


def sentence(happening: event.Event, total: int, flows: Sequence[str] = ()) -> str:
    """One line for an event; empty for those that only machines want."""
    match happening:
        case event.Began():
            width = len(str(total))
            column = max(map(len, flows)) if len(flows) > 1 else 0
            name = f"{flows[happening.flow]:<{column}}  " if column else ""
            of = happening.of if column else total
            return f"{happening.at_s:8.2f} s  {name}{happening.index + 1:>{width}}/{of}  {happening.action}"
        case event.Moved():
            text = _moved(happening)
            return f"{happening.at_s:8.2f} s  {happening.subsystem} {text}" if text else ""
        case event.Met():
            tag = happening.tag.rpartition(" ")[2]
            names = " and ".join(happening.subsystems)
            return f"{happening.at_s:8.2f} s  {names} go on together at {tag}, {happening.skew_us:.0f} us apart"
        case event.Stepped():
            return f"{happening.at_s:8.2f} s  note: {happening.subsystem}/{transfer_text.sentence(happening)}"
        case event.Warned():
            who = f"{happening.task}: " if happening.task else ""
            return f"{happening.at_s:8.2f} s  note: {who}{happening.text}"
        case event.Failed():
            where = f" ({happening.path}:{happening.line})" if happening.line else ""
            return f"{happening.at_s:8.2f} s  ERROR {happening.subsystem}/{happening.task}: {happening.text}{where}"
        case event.Drive() if happening.state == "TRIPPED":
            return f"{happening.at_s:8.2f} s  {happening.device} has tripped: {happening.cause}"
        case event.Drive() if happening.state == "PRESSED":
            return f"{happening.at_s:8.2f} s  {happening.device} holds: {happening.cause}"
        case _:
            return ""


def _moved(moved: event.Moved) -> str:
    """What is worth a word of a flow's new state; actions that begin, errors and the end have their own."""
    match moved.state:
        case "waiting" | "joining":
            text = waits(moved.tag, moved.waits_for)
        case "paused":
            text = f"is paused after {moved.action + 1}" if moved.action >= 0 else "is paused before its first action"
        case "stopped":
            return ""  # the error and its explanation stand beside it
        case _:
            return moved.text
    return f"{text} ({moved.text})" if moved.text else text


def item_text(item: event.Item) -> str:
    """What is asked for: name, how many, meaning, unit, bounds and default."""
    parts = [item.name if item.count == 1 else f"{item.name} ({item.count} values)", item.meaning]
    if item.unit not in ("", "-"):
        parts.append(f"in {item.unit}")
    low, high = (None if bound is None else " ".join(f"{x:g}" for x in bound) for bound in (item.low, item.high))
    if low is not None and high is not None:
        parts.append(f"from {low} to {high}")
    elif low is not None or high is not None:
        parts.append(f"at least {low}" if low is not None else f"at most {high}")
    if item.default is not None:
        parts.append(f"else {' '.join(map(str, item.default))}")
    return ", ".join(part for part in parts if part)


def summary(outcome: Outcome, drawn: str) -> Iterator[str]:
    """The lines at the end."""
    for fault in outcome.faults:
        yield str(fault)
    for note in outcome.notes:
        yield f"note: {note}"
    result = outcome.result
    if result is None:
        count = len(outcome.faults)
        yield f"{outcome.name}: refused, nothing moved ({count} fault{'s' if count != 1 else ''})"
        return
    speed = result.runtime_s / result.wall_s if result.wall_s else 0.0
    took = f"{result.runtime_s:.2f} s, in {result.wall_s:.2f} s of wall time"
    pace = f" ({speed:.0f}x)" if result.hash and speed > 1.5 else ""
    is_straight = result.done == result.of or (result.done < result.of and not result.completed)
    done = f"{result.done} of {result.of} actions" if is_straight else f"{result.done} actions"  # loops, branches
    yield f"{outcome.name}: {outcome.state}, {done}, {took}{pace}"
    if result.cause:
        yield f"cause: {result.cause}"
    if result.completed:  # else the cause says it, and the fault stands above
        yield from (f"script: {fault}" for fault in outcome.failed)
    if outcome.printed.strip():
        yield "the runtime printed:"
        yield from (f"  {line}" for line in outcome.printed.strip().splitlines()[-_PRINTED:])
    missed = sum(task.missed for task in result.tasks)
    cycles = sum(task.cycles for task in result.tasks)
    if cycles and not result.hash:
        yield f"cycles: {cycles}, missed {missed}"
    yield from transfer_text.summary(result.steps)
    for condition, value, holds in outcome.expectations:
        yield f"expect {condition.text}: " + ("yes" if holds else f"NO, found {'nothing' if value is None else value}")
    if result.hash:
        yield f"hash: {result.hash}"
    if result.outside:
        yield f"not reproducible: {', '.join(result.outside)} had to do with the outside"
    if drawn:
        yield drawn
