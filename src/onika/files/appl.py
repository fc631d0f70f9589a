"""The application file, `.appl` (dissertation §A.4)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from onika.files.icon import SLOTS, read_icon, write_icon
from onika.files.layout import carry_comments
from onika.files.line import VERSION, Line, Need, Reading, Slot, row, split
from onika.model.application import AppFlow, Application, Hole, Icon, Step
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.name import TASK_NAME

ENDING = ".appl"

_HEAD = (Slot("VERSION", Need.OPTIONAL), Slot("APPLTYPE", Need.SINCE_1_3))
_ROUTINE = (
    Slot("ROUTINE"),
    Slot("MARKER", Need.SINCE_1_3),
    Slot("SYNCHTAG", Need.OPTIONAL),
    Slot("WHILETAG", Need.OPTIONAL),
    Slot("WHILETEST", Need.OPTIONAL),
    *SLOTS,
)
_ALONE = ("FLOW", "ICONHOLE", "ENDFLOW")


@dataclass(frozen=True, slots=True)
class _Read:
    """A step and the line where it begins."""

    number: int
    step: Step


def read(text: str, name: str, place_file: str, syntax: Syntax) -> tuple[Application | None, tuple[Fault, ...]]:
    """The application `name` (no ending) of a text; left out with any fault.

    A target of unknown type leaves a hole that keeps its lines, a job of unknown type acts as a complete one
    (requirement D16).
    Start and end icons are left out (decision 46), adjacent holes are one (decision 33), the marks of a target go to
    its job (decision 24).
    """
    reading = Reading(place_file, "the application is left out")
    reading.open_versioned(text)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {*_ALONE, "ROUTINE"})
    found = reading.arrange(head, _HEAD)
    kinds = {"parallel": True, "conditional": False}
    is_parallel = reading.choice(found["APPLTYPE"][0] if found["APPLTYPE"] else None, kinds, default=False)
    flows = tuple(_flow(steps, syntax, reading) for steps in _flows(blocks, syntax, reading))
    if not flows:
        reading.fault(reading.end, "at least one FLOW", "none")
    return (None if reading.broken else Application(name, is_parallel, flows)), reading.faults


def write(application: Application, former: str = "") -> str:
    """The text of an application, with the comments of its former text."""
    parts = [row("VERSION", VERSION), "\n", row("APPLTYPE", "parallel" if application.is_parallel else "conditional")]
    for flow in application.flows:
        parts += ["\n", row("FLOW")]
        parts += ["\n" + (_show_icon(step) if isinstance(step, Icon) else _show_hole(step)) for step in flow.steps]
        parts += ["\n", row("ENDFLOW")]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show_hole(hole: Hole) -> str:
    return hole.kept or row("ICONHOLE")


def _show_icon(icon: Icon) -> str:
    parts = [row("ROUTINE", icon.onikon.name), row("MARKER", "yes" if icon.marker else "no")]
    if icon.synch_tag is not None:
        parts.append(row("SYNCHTAG", icon.synch_tag))
    if icon.while_tag is not None:
        parts += [row("WHILETAG", icon.while_tag), row("WHILETEST", "yes" if icon.while_test else "no")]
    return "".join(parts) + write_icon(icon.onikon)


def _flows(blocks: Sequence[Sequence[Line]], syntax: Syntax, reading: Reading) -> list[list[_Read]]:
    """The steps between every FLOW and its ENDFLOW."""
    flows: list[list[_Read]] = []
    is_open = False
    for block in blocks:
        first = block[0]
        keyword = first.keyword
        if (keyword == "FLOW") == is_open:
            reading.fault(first.number, "ENDFLOW before the next FLOW" if is_open else "FLOW", str(first))
        if keyword == "FLOW":
            flows.append([])
        is_open = keyword != "ENDFLOW"
        if keyword in _ALONE:
            reading.arrange(block, (Slot(keyword),))
            reading.bare(first)
        step = (
            Hole(first.number)
            if keyword == "ICONHOLE"
            else _icon(block, syntax, reading)
            if keyword == "ROUTINE"
            else None
        )
        if step is not None and flows:
            flows[-1].append(_Read(first.number, step))
    if is_open:
        reading.fault(blocks[-1][-1].number, "ENDFLOW", "the end of the application")
    return flows


def _icon(block: Sequence[Line], syntax: Syntax, reading: Reading) -> Step | None:
    """A routine as icon; a hole for a target of unknown type, None for the icons that begin and end a flow."""
    found = reading.arrange(block, _ROUTINE)
    line = {keyword: lines[0] if lines else None for keyword, lines in found.items()}
    name = reading.match(block[0], TASK_NAME, "the name of an icon")
    test = line["WHILETEST"]
    if line["WHILETAG"] and not test:
        reading.fault(line["WHILETAG"].number, "WHILETEST after WHILETAG", "none")
    if test and not line["WHILETAG"]:
        reading.fault(test.number, "WHILETAG before WHILETEST", "none")
    icon = read_icon(name, found, syntax, reading)
    if icon is None:
        return Hole(block[0].number, "".join(row(at.keyword, at.rest) for at in block))
    kind = syntax.find(icon.type)
    if kind and (kind.is_start or kind.is_end):
        return None
    return Icon(
        icon,
        marker=reading.yes(line["MARKER"], default=False),
        synch_tag=_tag(line["SYNCHTAG"], reading),
        while_tag=_tag(line["WHILETAG"], reading),
        while_test=reading.yes(test, default=False),
        line=block[0].number,
    )


def _tag(line: Line | None, reading: Reading) -> str | None:
    return reading.word(line, "a tag of one word") if line else None


def _flow(reads: Sequence[_Read], syntax: Syntax, reading: Reading) -> AppFlow:
    steps = [read.step for read in reads]
    for at, (job, target) in enumerate(pairwise(steps)):
        if isinstance(job, Icon) and isinstance(target, Icon) and _is_pair(job, target, syntax):
            steps[at : at + 2] = _marked(job, target, reads[at + 1].number, reading)
    return AppFlow(tuple(_without_twin_holes(steps)))


def _is_pair(job: Icon, target: Icon, syntax: Syntax) -> bool:
    kind, data = syntax.find(job.onikon.type), syntax.find(target.onikon.type)
    return bool(kind and data and kind.needs_target and data.is_target)


def _marked(job: Icon, target: Icon, number: int, reading: Reading) -> tuple[Icon, Icon]:
    """The pair with all marks on the job; `number` is the line of the target."""
    tags = ((job.synch_tag, target.synch_tag, "synch tag"), (job.while_tag, target.while_tag, "while tag"))
    for one, other, meaning in tags:
        if one is not None and other is not None and one != other:
            reading.fault(number, f"one {meaning} for a job and its target", f"{one} and {other}")
    marked = replace(
        job,
        marker=job.marker or target.marker,
        synch_tag=target.synch_tag if job.synch_tag is None else job.synch_tag,
        while_tag=target.while_tag if job.while_tag is None else job.while_tag,
        while_test=job.while_test or target.while_test,
    )
    return marked, Icon(target.onikon, line=target.line)


def _without_twin_holes(steps: Sequence[Step]) -> list[Step]:
    return [step for at, step in enumerate(steps) if not (isinstance(step, Hole) and at and steps[at - 1] == step)]
