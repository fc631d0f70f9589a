"""The configuration file, `.conf` (dissertation §A.2)."""

import math
from collections.abc import Mapping, Sequence, Set

from onika.files import own_lines
from onika.files.layout import carry_comments
from onika.files.line import FileLine, is_number, row, show_number, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED, VERSION
from onika.model.configuration import UNKNOWN_RTPU, Configuration, Group, Locus, Placed
from onika.words.fault import Fault
from onika.words.name import SVAR_NAME, TASK_NAME
from onika.words.reason import Reason

ENDING = ".conf"

_HEAD = (KeywordSlot("VERSION", Need.OPTIONAL),)
_TASK = (
    KeywordSlot("RMODFILE"),
    KeywordSlot("AS", Need.OF_2_0),
    KeywordSlot("COORDS"),
    KeywordSlot("INLEFT", Need.SINCE_1_3),
    KeywordSlot("FREQ", Need.SINCE_1_3),
    KeywordSlot("RTPU", Need.SINCE_1_3),
    *own_lines.SLOTS,
)
_COUNTS = ("CONNS", "NUMINCONST", "NUMOUTCONST", "NUMINVAR", "NUMOUTVAR", "NUMDOUBLEIN")
_LOCUS = (
    KeywordSlot("LOCUS"),
    KeywordSlot("COORDS"),
    *(KeywordSlot(keyword, Need.SINCE_1_3) for keyword in _COUNTS),
    KeywordSlot("SHOW", Need.SINCE_1_3),
)
_GROUP = (KeywordSlot("GROUP", Need.OF_2_0),)


def read(text: str, name: str, place_file: str) -> tuple[Configuration | None, tuple[Fault, ...]]:
    """The configuration `name` (no ending) of a text; with any fault it is left out."""
    reading = TextReading(place_file, Reason.of("files.configuration_left_out"))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {"RMODFILE", "LOCUS", "GROUP"})
    reading.arrange(head, _HEAD)
    placed, loci, grouped = [], [], []
    for block in blocks:
        if block[0].keyword == "GROUP":
            grouped += reading.arrange(block, _GROUP)["GROUP"]
            continue
        if grouped:
            reading.fault(block[0].number, Reason.of("files.group_before_locus", block=str(block[0])))
        if block[0].keyword == "LOCUS":
            loci.append(_locus(reading.arrange(block, _LOCUS), reading))
            continue
        if loci:
            reading.fault(block[0].number, Reason.of("files.task_after_locus", block=str(block[0])))
        placed.append(_placed(reading.arrange(block, _TASK), reading))
    _check_twice([_heading(block) for block in blocks if block[0].keyword != "GROUP"], reading)
    groups = _groups(grouped, {placed.task for placed in placed}, reading)
    return (None if reading.broken else Configuration(name, tuple(placed), tuple(loci), groups)), reading.faults


def write(configuration: Configuration, former: str = "") -> str:
    """The text of a configuration, with the comments of its former text; of version 2.0 only where it has to be.

    That is where it has groups, and tasks that are not as their files say or stand under names of their own.
    """
    groups = [row("GROUP", group.name, *group.tasks) for group in configuration.groups]
    is_extended = bool(groups) or not all(placed.is_as_filed for placed in configuration.placed)
    parts = [row("VERSION", EXTENDED if is_extended else VERSION)]
    parts += ["\n" + _show_placed(placed) for placed in configuration.placed]
    parts += ["\n" + _show_locus(locus) for locus in configuration.loci]
    parts += ["\n", *groups] if groups else []
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show_placed(placed: Placed) -> str:
    return (
        row("RMODFILE", placed.file)
        + (row("AS", placed.task) if placed.rmod else "")
        + row("COORDS", str(placed.x), str(placed.y))
        + row("INLEFT", "yes" if placed.in_left else "no")
        + row("FREQ", show_number(placed.frequency))
        + row("RTPU", placed.rtpu)
        + own_lines.write(placed.own)
    )


def _show_locus(locus: Locus) -> str:
    counts = (locus.conns, locus.inconst, locus.outconst, locus.invar, locus.outvar, locus.double_in)
    return (
        row("LOCUS", locus.svar)
        + row("COORDS", str(locus.x), str(locus.y))
        + "".join(row(keyword, str(count)) for keyword, count in zip(_COUNTS, counts, strict=True))
        + row("SHOW", "yes" if locus.show else "no")
    )


def _placed(by_keyword: Mapping[str, list[FileLine]], reading: TextReading) -> Placed:
    line = {keyword: lines[0] if lines else None for keyword, lines in by_keyword.items()}
    x, y = reading.wholes(line["COORDS"], (0, 0))
    file = reading.match(line["RMODFILE"], TASK_NAME, Reason.of("files.name_of_task"))
    name = reading.match(line["AS"], TASK_NAME, Reason.of("files.name_of_task"), file)
    return Placed(
        task=name,
        x=x,
        y=y,
        in_left=reading.yes(line["INLEFT"], default=True),
        frequency=_frequency(line["FREQ"], reading),
        rtpu=reading.word(line["RTPU"], Reason.of("files.name_of_unit"), UNKNOWN_RTPU),
        own=own_lines.read(by_keyword, reading),
        rmod="" if name == file else file,
    )


def _frequency(line: FileLine | None, reading: TextReading) -> float:
    """Hz; 0 where the task is aperiodic."""
    if line is None:
        return 0.0
    value = float(line.rest) if is_number(line.rest) else math.nan
    if not (math.isfinite(value) and value >= 0):
        reading.fault(line.number, Reason.of("files.frequency_given", line=str(line)))
        return 0.0
    return abs(value)


def _locus(by_keyword: Mapping[str, list[FileLine]], reading: TextReading) -> Locus:
    line = {keyword: lines[0] if lines else None for keyword, lines in by_keyword.items()}
    x, y = reading.wholes(line["COORDS"], (0, 0))
    return Locus(
        reading.match(line["LOCUS"], SVAR_NAME, Reason.of("files.name_of_variable")),
        x,
        y,
        conns=reading.whole(line["CONNS"], 0, low=0),
        inconst=reading.whole(line["NUMINCONST"], 0, low=0),
        outconst=reading.whole(line["NUMOUTCONST"], 0, low=0),
        invar=reading.whole(line["NUMINVAR"], 0, low=0),
        outvar=reading.whole(line["NUMOUTVAR"], 0, low=0),
        double_in=reading.whole(line["NUMDOUBLEIN"], 0, low=0),
        show=reading.yes(line["SHOW"], default=True),
    )


def _heading(block: Sequence[FileLine]) -> FileLine:
    """The line that says what a block is about: a task by the name that it has here."""
    if block[0].keyword == "LOCUS":
        return block[0]
    return next((line._replace(keyword="RMODFILE") for line in block[:2] if line.keyword == "AS"), block[0])


def _check_twice(heads: Sequence[FileLine], reading: TextReading) -> None:
    """A task, and the locus of a variable, stands in a configuration once."""
    seen: dict[tuple[str, str], int] = {}
    for line in heads:
        first = seen.setdefault((line.keyword, line.rest), line.number)
        if first != line.number:
            reading.fault(
                line.number, Reason.of("files.repeated_after", keyword=line.keyword, rest=line.rest, first=first)
            )


def _groups(lines: Sequence[FileLine], placed: Set[str], reading: TextReading) -> tuple[Group, ...]:
    """Supermodules: each name once, and each task in one of them."""
    named: dict[str, int] = {}
    home: dict[str, int] = {}
    groups = []
    for line in lines:
        if len(line.words) < 2 or not all(map(TASK_NAME.match, line.words)):
            reading.fault(line.number, Reason.of("files.group_line", line=str(line)))
            continue
        name, *tasks = line.words
        first = named.setdefault(name, line.number)
        if first != line.number:
            reading.fault(line.number, Reason.of("files.group_once", name=name, first=first))
        for task in tasks:
            if task not in placed:
                reading.fault(line.number, Reason.of("files.group_stranger", name=name, task=task))
            elif task in home:
                reading.fault(line.number, Reason.of("files.group_task_twice", task=task, home=home[task]))
            home.setdefault(task, line.number)
        groups.append(Group(name, tuple(tasks)))
    return tuple(groups)
