"""How a run is told to people: one sentence per event and the summary at the end, for terminals and plain text."""

from collections.abc import Iterator, Sequence

from onika.desk.run import explanation_text, transfer_text
from onika.desk.run.outcome import Outcome
from onika.desk.run.positions import waits
from onika.wire import event

_PRINTED = 20


def lines(one: event.Event, total: int, flows: Sequence[str] = (), width: int = 80) -> Iterator[str]:
    """The lines of an event; none for those that only machines want.

    total   how many actions the longest flow has
    flows   the flows' subsystems; each is named where there are several
    width   columns that there are for what takes several lines
    """
    if isinstance(one, event.Explained):
        yield from explanation_text.lines(one, width)
    elif line := sentence(one, total, flows):
        yield line


def sentence(one: event.Event, total: int, flows: Sequence[str] = ()) -> str:
    """One line for an event; empty for those that only machines want."""
    match one:
        case event.Began():
            width = len(str(total))
            column = max(map(len, flows)) if len(flows) > 1 else 0
            name = f"{flows[one.flow]:<{column}}  " if column else ""
            return f"{one.at_s:8.2f} s  {name}{one.index + 1:>{width}}/{one.of if column else total}  {one.action}"
        case event.Moved():
            said = _moved(one)
            return f"{one.at_s:8.2f} s  {one.subsystem} {said}" if said else ""
        case event.Met():
            tag = one.tag.rpartition(" ")[2]
            names = " and ".join(one.subsystems)
            return f"{one.at_s:8.2f} s  {names} go on together at {tag}, {one.skew_us:.0f} us apart"
        case event.Stepped():
            return f"{one.at_s:8.2f} s  note: {one.subsystem}/{transfer_text.sentence(one)}"
        case event.Warned():
            who = f"{one.task}: " if one.task else ""
            return f"{one.at_s:8.2f} s  note: {who}{one.text}"
        case event.Failed():
            where = f" ({one.path}:{one.line})" if one.line else ""
            return f"{one.at_s:8.2f} s  ERROR {one.subsystem}/{one.task}: {one.text}{where}"
        case event.Drive() if one.state == "TRIPPED":
            return f"{one.at_s:8.2f} s  {one.device} has tripped: {one.cause}"
        case event.Drive() if one.state == "PRESSED":
            return f"{one.at_s:8.2f} s  {one.device} holds: {one.cause}"
        case _:
            return ""


def _moved(one: event.Moved) -> str:
    """What is worth a word of a flow's new state; actions that begin, errors and the end have their own."""
    match one.state:
        case "waiting" | "joining":
            said = waits(one.tag, one.waits_for)
        case "paused":
            said = f"is paused after {one.action + 1}" if one.action >= 0 else "is paused before its first action"
        case "stopped":
            return ""  # the error and its explanation stand beside it
        case _:
            return one.text
    return f"{said} ({one.text})" if one.text else said


def asked_item(one: event.Item) -> str:
    """What is asked for: name, how many, meaning, unit, bounds and default."""
    parts = [one.name if one.count == 1 else f"{one.name} ({one.count} values)", one.meaning]
    if one.unit not in ("", "-"):
        parts.append(f"in {one.unit}")
    low, high = (None if bound is None else " ".join(f"{x:g}" for x in bound) for bound in (one.low, one.high))
    if low is not None and high is not None:
        parts.append(f"from {low} to {high}")
    elif low is not None or high is not None:
        parts.append(f"at least {low}" if low is not None else f"at most {high}")
    if one.default is not None:
        parts.append(f"else {' '.join(map(str, one.default))}")
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
    missed = sum(one.missed for one in result.tasks)
    cycles = sum(one.cycles for one in result.tasks)
    if cycles and not result.hash:
        yield f"cycles: {cycles}, missed {missed}"
    yield from transfer_text.summary(result.steps)
    for one, value, holds in outcome.expectations:
        yield f"expect {one.text}: " + ("yes" if holds else f"NO, found {'nothing' if value is None else value}")
    if result.hash:
        yield f"hash: {result.hash}"
    if result.outside:
        yield f"not reproducible: {', '.join(result.outside)} had to do with the outside"
    if drawn:
        yield drawn
