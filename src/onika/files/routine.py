"""One icon of a flow in the application file: ROUTINE, its marks and the lines of its onikon (dissertation §A.4).

Of version 2.0 are the conditions behind marks: `MARKERIF LAMP == 1` behind MARKER, `WHILEIF …` behind WHILETEST.
"""

from collections.abc import Sequence
from dataclasses import replace

from onika.files.icon import SLOTS, needs_extension, read_icon, write_icon
from onika.files.line import FileLine, one_line, row
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.model.application import Hole, Icon
from onika.model.onikon import Onikon, fits
from onika.model.picture import SIZES
from onika.model.syntax import Syntax
from onika.words.condition import Condition
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

_ROUTINE = (
    KeywordSlot("ROUTINE"),
    KeywordSlot("MARKER", Need.SINCE_1_3),
    KeywordSlot("MARKERIF", Need.OF_2_0),
    KeywordSlot("SYNCHTAG", Need.OPTIONAL),
    KeywordSlot("WHILETAG", Need.OPTIONAL),
    KeywordSlot("WHILETEST", Need.OPTIONAL),
    KeywordSlot("WHILEIF", Need.OF_2_0),
    *SLOTS,
)

_EXTENSIONS = frozenset(slot.keyword for slot in _ROUTINE if slot.need is Need.OF_2_0)


def read_routine(block: Sequence[FileLine], syntax: Syntax, reading: TextReading) -> Icon | Hole | None:
    """A routine as icon; None for the icons that begin and end a flow.

    A hole with its lines for a target of unknown type, and for what is too broken for an icon.
    """
    by_keyword = reading.arrange(block, _ROUTINE)
    line = {keyword: lines[0] if lines else None for keyword, lines in by_keyword.items()}
    name = reading.match(block[0], TASK_NAME, Reason.of("files.name_of_icon"))
    for keyword, behind in (("WHILETAG", "WHILETEST"), ("WHILETEST", "WHILETAG"), ("WHILEIF", "WHILETEST")):
        given = line[keyword]
        if given and not line[behind]:
            order = "after" if keyword == "WHILETAG" else "before"
            reading.fault(given.number, Reason.of("files.order_missing", behind=behind, order=order, name=keyword))
    icon = read_icon(name, by_keyword, syntax, reading)
    if icon is None or not name or not _is_whole(icon, syntax):
        return Hole(block[0].number, "".join(row(at.keyword, at.rest) for at in block))
    kind = syntax.find(icon.type)
    if kind and (kind.is_start or kind.is_end):
        return None
    return Icon(
        icon,
        marker=reading.yes(line["MARKER"], default=False),
        synch_tag=_tag(line["SYNCHTAG"], reading),
        while_tag=_tag(line["WHILETAG"], reading),
        while_test=reading.yes(line["WHILETEST"], default=False),
        marker_if=read_condition(line["MARKERIF"], reading),
        while_if=read_condition(line["WHILEIF"], reading),
        line=block[0].number,
    )


def write_routine(icon: Icon) -> str:
    """The lines of an icon."""
    parts = [row("ROUTINE", icon.onikon.name), row("MARKER", "yes" if icon.marker else "no")]
    if icon.marker_if:
        parts.append(row("MARKERIF", one_line(icon.marker_if)))
    if icon.synch_tag is not None:
        parts.append(row("SYNCHTAG", icon.synch_tag))
    if icon.while_tag is not None:
        parts += [row("WHILETAG", icon.while_tag), row("WHILETEST", "yes" if icon.while_test else "no")]
        parts += [row("WHILEIF", one_line(icon.while_if))] if icon.while_if else []
    return "".join(parts) + write_icon(icon.onikon)


def is_extended(step: Icon | Hole) -> bool:
    """Whether its lines are of version 2.0."""
    if isinstance(step, Hole):
        return any(_is_extended_line(line) for line in step.kept.splitlines())
    icon = step
    return bool(icon.marker_if or (icon.while_if and icon.while_tag is not None)) or needs_extension(icon.onikon)


def _is_extended_line(line: str) -> bool:
    keyword, _, rest = line.partition(" ")
    return keyword in _EXTENSIONS or (keyword == "PICT" and len(rest.strip()) in SIZES[1:])


def read_condition(line: FileLine | None, reading: TextReading) -> str:
    """The condition on a line; empty where there is no line, or a wrong one, which is a fault."""
    if line is None:
        return ""
    try:
        return Condition.parse(line.text).text
    except ValueError:
        reading.fault(line.number, Reason.of("files.condition_after", keyword=line.keyword, line=str(line)))
        return ""


def marked(job: Icon, target: Icon, reading: TextReading) -> tuple[Icon, Icon]:
    """An action's icon with all marks on it, and its target without any (reading 24)."""
    _agree(job.synch_tag, target.synch_tag, Reason.of("files.synch_tag"), target, reading)
    _agree(job.while_tag, target.while_tag, Reason.of("files.while_tag"), target, reading)
    _agree(job.while_if or None, target.while_if or None, Reason.of("files.loop_condition"), target, reading)
    if job.marker and target.marker:
        _agree(job.marker_if, target.marker_if, Reason.of("files.breakpoint"), target, reading)
    stops = target if target.marker and not job.marker else job
    whole = replace(
        job,
        marker=stops.marker,
        marker_if=stops.marker_if or (job.marker_if or target.marker_if) * (not stops.marker),
        synch_tag=target.synch_tag if job.synch_tag is None else job.synch_tag,
        while_tag=target.while_tag if job.while_tag is None else job.while_tag,
        while_test=job.while_test or target.while_test,
        while_if=job.while_if or target.while_if,
    )
    return whole, Icon(target.onikon, line=target.line)


def _is_whole(icon: Onikon, syntax: Syntax) -> bool:
    """Whether its values are those of its type, as far as that is known."""
    kind = syntax.find(icon.type)
    return kind is None or fits(icon.values, kind.items)


def _agree(mark: str | None, other: str | None, meaning: Reason, target: Icon, reading: TextReading) -> None:
    if mark is not None and other is not None and mark != other:
        always = Reason.of("files.always")
        reason = Reason.of("files.icons_disagree", meaning=meaning, first=mark or always, second=other or always)
        reading.fault(target.line, reason)


def _tag(line: FileLine | None, reading: TextReading) -> str | None:
    if line:
        return reading.word(line, Reason.of("files.a_tag"))
    return None
