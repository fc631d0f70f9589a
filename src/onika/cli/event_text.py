"""The text of a run for people: one sentence per event and the summary at the end, for terminals and plain text."""

from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from onika.cli.language import say
from onika.cli.lines.fault_lines import fault_lines
from onika.desk.run import explanation_text, transfer_text
from onika.desk.run.item_text import bounds, default
from onika.desk.run.outcome import Outcome
from onika.desk.run.positions import waits
from onika.wire import event
from onika.words.reason import NOTHING, Reason

_PRINTED = 20


class SummaryTone(Enum):
    """How a line of the summary is meant."""

    PLAIN = "plain"
    WELL = "well"
    """The outcome of a run as it should be."""
    FAILED = "failed"
    WRONG = "wrong"
    """What is not as it was expected."""


class SummaryLine(NamedTuple):
    """A line of the summary."""

    reason: Reason
    tone: SummaryTone = SummaryTone.PLAIN


def lines(happening: event.Event, total: int, flows: Sequence[str] = (), width: int = 80) -> Iterator[str]:
    """The lines of an event; none for those that only machines want.

    total   how many actions the longest flow has
    flows   the flows' subsystems; each is named where there are several
    width   columns that there are for what takes several lines
    """
    if isinstance(happening, event.Explained):
        yield from explanation_text.lines(happening, width, say)
    elif line := sentence(happening, total, flows):
        yield line


def sentence(happening: event.Event, total: int, flows: Sequence[str] = ()) -> str:
    """One line for an event; empty for those that only machines want."""
    match happening:
        case event.Began():
            return f"{happening.at_s:8.2f} s  {_began(happening, total, flows)}"
        case event.Moved():
            text = say(_moved(happening))
            if text:
                return f"{happening.at_s:8.2f} s  {happening.subsystem} {text}"
            return ""
        case event.LastSecondsKept():
            return f"{happening.at_s:8.2f} s  {say(Reason.of('cli.standstill_kept', path=happening.path))}"
        case event.Met() | event.Stepped() | event.Warned() | event.Outdated() | event.Failed() | event.Drive():
            text = say(_reason(happening))
            return f"{happening.at_s:8.2f} s  {text}" if text else ""
        case _:
            return ""


def _began(began: event.Began, total: int, flows: Sequence[str]) -> str:
    """The number of the action in its flow, and its name; the flow's name too where there are several."""
    width = len(str(total))
    if len(flows) <= 1:
        return f"{began.index + 1:>{width}}/{total}  {began.action}"
    column = max(map(len, flows))
    return f"{flows[began.flow]:<{column}}  {began.index + 1:>{width}}/{began.of}  {began.action}"


def _reason(
    happening: event.Met | event.Stepped | event.Warned | event.Outdated | event.Failed | event.Drive,
) -> Reason:
    """What is said of an event beside its time."""
    match happening:
        case event.Met():
            tag = happening.tag.rpartition(" ")[2]
            return Reason.of("cli.flows_met", flows=happening.subsystems, tag=tag, skew=happening.skew_us)
        case event.Stepped():
            return Reason.of("cli.note", text=transfer_text.sentence_with_subsystem(happening))
        case event.Warned():
            text = happening.text
            if happening.task:
                text = Reason.of("cli.warned", task=happening.task, text=text)
            return Reason.of("cli.note", text=text)
        case event.Outdated():
            return Reason.of("cli.note", text=happening.text)
        case event.Failed():
            where = f" ({happening.path}:{happening.line})" if happening.line else ""
            task = f"{happening.subsystem}/{happening.task}"
            return Reason.of("cli.task_failed", task=task, text=happening.text, where=where)
        case event.Drive(state="TRIPPED"):
            return Reason.of("cli.drive_tripped", device=happening.device, cause=happening.cause)
        case event.Drive(state="PRESSED"):
            return Reason.of("cli.drive_holds", device=happening.device, cause=happening.cause)
        case _:
            return NOTHING


def _moved(moved: event.Moved) -> Reason:
    """What is worth a word of a flow's new state; actions that begin, errors and the end have their own."""
    match moved.state:
        case "waiting" | "joining":
            text = waits(moved.tag, moved.waits_for)
        case "paused" if moved.action >= 0:
            text = Reason.of("cli.paused_after", action=moved.action + 1)
        case "paused":
            text = Reason.of("cli.paused_first")
        case "stopped":
            return NOTHING  # the error and its explanation stand beside it
        case _:
            return moved.text
    if moved.text:
        return Reason.of("cli.moved_because", text=text, because=moved.text)
    return text


def item_text(item: event.Item) -> Reason:
    """What is asked for: name, how many, meaning, unit, bounds and default."""
    name = Reason.plain(item.name)
    if item.count != 1:
        name = Reason.of("cli.item_values", name=item.name, number=item.count)
    unit = NOTHING
    if item.unit not in ("", "-"):
        unit = Reason.of("cli.item_unit", unit=item.unit)
    parts = [name, Reason.plain(item.meaning), unit, bounds(item), default(item)]
    return Reason.of("cli.item_parts", parts=tuple(part for part in parts if part))


def summary(outcome: Outcome, drawn: Reason) -> Iterator[SummaryLine]:
    """The lines at the end."""
    yield from map(SummaryLine, fault_lines(outcome.faults))
    for note in outcome.notes:
        yield SummaryLine(Reason.of("cli.note", text=note))
    if outcome.result is None:
        refused = Reason.of("cli.refused", name=outcome.name, faults=len(outcome.faults))
        yield SummaryLine(refused, SummaryTone.FAILED)
        return
    yield from _ending(outcome, outcome.result)
    yield from _figures(outcome.result)
    for condition, value, holds in outcome.expectations:
        yield SummaryLine(_expectation(condition.text, value, holds), SummaryTone.PLAIN if holds else SummaryTone.WRONG)
    yield from _repeatability(outcome.result)
    if drawn:
        yield SummaryLine(drawn)


def _ending(outcome: Outcome, result: event.Result) -> Iterator[SummaryLine]:
    """How it ended and why, and what was printed then."""
    yield SummaryLine(_verdict(outcome.name, result), SummaryTone.FAILED if outcome.exit_code else SummaryTone.WELL)
    if result.cause:
        yield SummaryLine(Reason.of("cli.cause", cause=result.cause))
    for remark in result.remarks:
        yield SummaryLine(remark, SummaryTone.WRONG)
    if result.black_box:
        yield SummaryLine(Reason.of("cli.black_box", path=result.black_box))
    if result.completed:  # else the cause says it, and the fault stands above
        for fault in outcome.failed:
            yield SummaryLine(Reason.of("cli.script_failed", fault=fault.sentence))
    printed = outcome.printed.strip()
    if printed:
        yield SummaryLine(Reason.of("cli.runtime_printed"))
        yield from (SummaryLine(Reason.plain(f"  {line}")) for line in printed.splitlines()[-_PRINTED:])


def _figures(result: event.Result) -> Iterator[SummaryLine]:
    """What was missed in wall time, and how inputs of hardware stepped."""
    missed = sum(task.missed for task in result.tasks)
    cycles = sum(task.cycles for task in result.tasks)
    if cycles and not result.hash:
        yield SummaryLine(Reason.of("cli.cycles", cycles=cycles, missed=missed))
    yield from map(SummaryLine, transfer_text.summary(result.steps))


def _repeatability(result: event.Result) -> Iterator[SummaryLine]:
    if result.hash:
        yield SummaryLine(Reason.of("cli.hash", hash=result.hash))
    if result.outside:
        yield SummaryLine(Reason.of("cli.not_reproducible", names=result.outside))


def _verdict(name: str, result: event.Result) -> Reason:
    if result.completed:
        return Reason.of("cli.completed", name=name, done=_done(result), took=_took(result))
    return Reason.of("cli.aborted", name=name, done=_done(result), took=_took(result))


def _done(result: event.Result) -> Reason:
    """How many actions; of how many, where there were no loops or branches."""
    is_straight = result.done == result.of or (result.done < result.of and not result.completed)
    if is_straight:
        return Reason.of("cli.actions_of", done=result.done, number=result.of)
    return Reason.of("cli.actions", done=result.done)


def _took(result: event.Result) -> Reason:
    """How long it took; how many times as fast as wall time, where it ran in virtual time."""
    speed = result.runtime_s / result.wall_s if result.wall_s else 0.0
    pace = f" ({speed:.0f}x)" if result.hash and speed > 1.5 else ""
    return Reason.of("cli.took", seconds=result.runtime_s, wall=result.wall_s, pace=pace)


def _expectation(text: str, value: object, holds: bool) -> Reason:
    if holds:
        return Reason.of("cli.expected", text=text)
    if value is None:
        return Reason.of("cli.expected_nothing", text=text)
    return Reason.of("cli.expected_other", text=text, value=str(value))
