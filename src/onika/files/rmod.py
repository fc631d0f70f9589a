"""The task parameter file, `.rmod` (dissertation §A.1)."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Context, Decimal
from fractions import Fraction

from onika.files.layout import Key, carry, words_of
from onika.files.line import FileLine, is_number, one_line, row, show_number
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.model.syntax import has_word
from onika.model.task import LocalLine, Task, TaskType
from onika.words.fault import Fault
from onika.words.name import SVAR_NAME, TASK_NAME
from onika.words.reason import Reason

ENDING = ".rmod"

_SLOTS = (
    KeywordSlot("MODULE"),
    KeywordSlot("DESC"),
    KeywordSlot("SVARALIAS", Need.OPTIONAL, many=True),
    KeywordSlot("INCONST"),
    KeywordSlot("OUTCONST"),
    KeywordSlot("INVAR"),
    KeywordSlot("OUTVAR"),
    KeywordSlot("TASKTYPE"),
    KeywordSlot("FREQ", Need.OPTIONAL),
    KeywordSlot("PERIOD", Need.OPTIONAL),
    KeywordSlot("ONIKA", Need.OPTIONAL),
    KeywordSlot("OBJECT", Need.OPTIONAL),
    KeywordSlot("TARGET", Need.OPTIONAL, many=True),
    KeywordSlot("LOCAL", Need.OPTIONAL),
)
_KEYWORDS = frozenset(slot.keyword for slot in _SLOTS) - {"TARGET"}  # parameters of that name are older than the line
_PORTS = ("INCONST", "OUTCONST", "INVAR", "OUTVAR")
_OUTPUTS = ("OUTCONST", "OUTVAR")
_LOCAL_KEY = re.compile(r"[A-Za-z][A-Za-z0-9_^.-]*\Z")
_ALIAS = re.compile(r"([^ \t=]+)[ \t]*=[ \t]*([^ \t=]+)\Z")


@dataclass(frozen=True, slots=True)
class RmodText:
    """A task with the text it was read from, whose comments and blanks ride along; "" for a new task."""

    task: Task
    text: str = ""


def read(text: str, name: str, place_file: str) -> tuple[RmodText | None, tuple[Fault, ...]]:
    """The task `name` (no ending) of a text; with any fault the task is left out. `place_file` names the file."""
    reading = TextReading(place_file, Reason.of("files.task_left_out"))
    reading.open(text)
    if reading.is_over:
        return None, reading.faults
    head = next((at for at, line in enumerate(reading.lines) if line.keyword == "LOCAL"), len(reading.lines))
    by_keyword = reading.arrange(reading.lines[: head + 1], _SLOTS)
    renamed = aliases(by_keyword["SVARALIAS"], reading)
    ports = _ports(by_keyword, renamed, reading)
    kind = reading.choice(_first(by_keyword["TASKTYPE"]), {kind.value: kind for kind in TaskType}, TaskType.APERIODIC)
    for alone in by_keyword["ONIKA"] + by_keyword["LOCAL"]:
        reading.bare(alone)
    task = Task(
        name=name,
        module=reading.match(_first(by_keyword["MODULE"]), TASK_NAME, Reason.of("files.name_of_module")),
        description=by_keyword["DESC"][0].text if by_keyword["DESC"] else "",
        aliases=renamed,
        inconst=ports["INCONST"],
        outconst=ports["OUTCONST"],
        invar=ports["INVAR"],
        outvar=ports["OUTVAR"],
        type=kind,
        frequency=_frequency(by_keyword, kind, reading),
        gives_period=bool(by_keyword["PERIOD"]),
        object_type=_object_type(by_keyword, reading),
        more_targets=_more_targets(by_keyword, reading),
        local=_local(reading.lines[head + 1 :], reading),
    )
    return (None if reading.broken else RmodText(task, text)), reading.faults


def write(record: RmodText, task: Task | None = None) -> str:
    """The text of a record, with what `task` changes in it; every other line stays as it was."""
    if task is None:
        task = record.task
    if record.text and (task, task.gives_period) == (record.task, record.task.gives_period):
        return record.text
    return carry(record.text, _canonical(task), _key)


def aliases(lines: Sequence[FileLine], reading: TextReading) -> tuple[tuple[str, str], ...]:
    """Variables by coded names, each of these once."""
    pairs: dict[str, str] = {}
    for line in lines:
        match = _ALIAS.match(line.rest)
        if not match or not (SVAR_NAME.match(match[1]) and SVAR_NAME.match(match[2])):
            reading.fault(line.number, Reason.of("files.alias_line", line=str(line)))
        elif match[1] in pairs:
            reading.fault(line.number, Reason.of("files.one_alias", given=match[1], line=str(line)))
        else:
            pairs[match[1]] = match[2]
    return tuple(pairs.items())


def is_parameter(key: str) -> bool:
    """Whether a word may name a parameter of a module."""
    return key not in _KEYWORDS and key != "EOF" and _LOCAL_KEY.match(key) is not None


def _canonical(task: Task) -> str:
    rows = [row("MODULE", task.module), row("DESC", one_line(task.description))]
    rows += [row("SVARALIAS", coded, "=", svar) for coded, svar in task.aliases]
    for keyword, names in zip(_PORTS, (task.inconst, task.outconst, task.invar, task.outvar), strict=True):
        rows.append(row(keyword, *(names or ("none",))))
    rows.append(row("TASKTYPE", task.type.value))
    if task.frequency is not None:
        gives = ("PERIOD", _show_period(task.frequency)) if task.gives_period else ("FREQ", show_number(task.frequency))
        rows += ["\n", row(*gives)]
    if task.object_type is not None:
        rows += ["\n", row("ONIKA"), row("OBJECT", one_line(task.object_type))]
        rows += [row("TARGET", one_line(kind)) for kind in task.more_targets]
    if task.local:
        rows += ["\n", row("LOCAL")]
        rows += [row(line.key, *line.words) for line in task.local]
    return "".join([*rows, "\n", row("EOF")])


def _key(line: str) -> Key:
    """Two spellings of one alias or rate are one line."""
    words = words_of(line)
    if words[0] == "SVARALIAS":
        return words_of(line.replace("=", " = "))
    if words[0] in ("FREQ", "PERIOD") and len(words) == 2 and is_number(words[1]):
        return words[0], repr(float(words[1]))
    return words


def _first(lines: Sequence[FileLine]) -> FileLine | None:
    return lines[0] if lines else None


def _ports(
    by_keyword: Mapping[str, list[FileLine]], aliases: Sequence[tuple[str, str]], reading: TextReading
) -> dict[str, tuple[str, ...]]:
    listed = {keyword: _names(_first(by_keyword[keyword]), reading) for keyword in _PORTS}
    ports = {keyword: _coded(names, listed, aliases) for keyword, names in listed.items()}
    for keyword, names in ports.items():
        if len(set(names)) < len(names):
            reading.fault(
                by_keyword[keyword][0].number, Reason.of("files.every_name_once", given=str(by_keyword[keyword][0]))
            )
    _check_aliases(by_keyword, ports, aliases, reading)
    return ports


def _names(line: FileLine | None, reading: TextReading) -> tuple[str, ...]:
    """The words of a port line; `none` stands for no ports."""
    if line is None or line.words == ("none",):
        return ()
    if not line.words or not all(SVAR_NAME.match(word) for word in line.words) or "NONE" in line.words:
        reading.fault(line.number, Reason.of("files.names_of_variables", keyword=line.keyword, line=str(line)))
        return ()
    return line.words


def _coded(
    names: Sequence[str], listed: Mapping[str, Sequence[str]], aliases: Sequence[tuple[str, str]]
) -> tuple[str, ...]:
    """Coded names for those given by their alias (reading 8).

    A name counts as an alias where the coded name it belongs to stands on no port line.
    """
    present = {name for line in listed.values() for name in line}
    coded = {svar: name for name, svar in aliases if name not in present}
    own = {name for name, _ in aliases}
    return tuple(name if name in own else coded.get(name, name) for name in names)


def _check_aliases(
    by_keyword: Mapping[str, list[FileLine]],
    ports: Mapping[str, Sequence[str]],
    aliases: Sequence[tuple[str, str]],
    reading: TextReading,
) -> None:
    """Every alias belongs to a port, and no two outputs become one variable (reading 9)."""
    present = {name for names in ports.values() for name in names}
    if reading.broken:
        return
    for line, (name, _) in zip(by_keyword["SVARALIAS"], aliases, strict=True):
        if name not in present:
            reading.fault(line.number, Reason.of("files.alias_of_port", line=str(line)))
    svars = dict(aliases)
    writers: dict[str, str] = {}
    for name in dict.fromkeys(name for keyword in _OUTPUTS for name in ports[keyword]):
        other = writers.setdefault(svars.get(name, name), name)
        if other != name:
            line = next(by_keyword[keyword][0] for keyword in reversed(_OUTPUTS) if name in ports[keyword])
            reading.fault(
                line.number, Reason.of("files.output_twice", other=other, name=name, get=svars.get(name, name))
            )


def _frequency(by_keyword: Mapping[str, list[FileLine]], kind: TaskType, reading: TextReading) -> float | None:
    """Hz; exactly one of FREQ and PERIOD where the task is periodic or synchronous."""
    lines = by_keyword["FREQ"] + by_keyword["PERIOD"]
    tasktype = _first(by_keyword["TASKTYPE"])
    is_known = tasktype is not None and tasktype.rest in {kind.value for kind in TaskType}
    if is_known and kind is TaskType.APERIODIC:
        for line in lines:
            reading.fault(line.number, Reason.of("files.rate_unwanted", line=str(line)))
        return None
    if is_known and tasktype and not lines:
        reading.fault(tasktype.number, Reason.of("files.rate_missing", value=kind.value))
    if len(lines) > 1:
        reading.fault(lines[-1].number, Reason.of("files.rate_twice"))
    rates = [_rate(line, reading) for line in lines]
    return rates[0] if rates else None


def _rate(line: FileLine, reading: TextReading) -> float:
    value = float(line.rest) if is_number(line.rest) else math.nan
    if not (math.isfinite(value) and value > 0):
        unit = "Hz" if line.keyword == "FREQ" else "s"
        reading.fault(line.number, Reason.of("files.rate_number", unit=unit, keyword=line.keyword, line=str(line)))
        return 1.0
    if line.keyword == "FREQ":
        return value
    try:
        return float(1 / Fraction(line.rest))
    except OverflowError:
        reading.fault(line.number, Reason.of("files.period_too_short", line=str(line)))
        return 1.0


def _show_period(frequency: float) -> str:
    """The shortest decimal number of seconds that reads back as this frequency in Hz."""
    exact = Fraction(frequency)
    for digits in range(1, 40):
        context = Context(prec=digits)
        text = str(context.divide(Decimal(exact.denominator), Decimal(exact.numerator)))
        if float(1 / Fraction(text)) == frequency:
            return text
    raise ValueError(Reason.of("files.frequency_with_period", frequency=frequency))


def _object_type(by_keyword: Mapping[str, list[FileLine]], reading: TextReading) -> str | None:
    onika, line = _first(by_keyword["ONIKA"]), _first(by_keyword["OBJECT"])
    if onika and not line:
        reading.fault(onika.number, Reason.of("files.object_missing"))
    if line and not onika:
        reading.fault(line.number, Reason.of("files.onika_missing"))
    if line and not (has_word(line.text, "job") and len(line.words) > 1):
        reading.fault(line.number, Reason.of("files.type_of_job", line=str(line)))
    return line.text if line else None


def _more_targets(by_keyword: Mapping[str, list[FileLine]], reading: TextReading) -> tuple[str, ...]:
    for line in by_keyword["TARGET"]:
        if not by_keyword["OBJECT"]:
            reading.fault(line.number, Reason.of("files.object_before_target", line=str(line)))
        if not (has_word(line.text, "object") and len(line.words) > 1):
            reading.fault(line.number, Reason.of("files.type_of_target", line=str(line)))
    return tuple(line.text for line in by_keyword["TARGET"])


def _local(lines: Sequence[FileLine], reading: TextReading) -> tuple[LocalLine, ...]:
    """The parameters of the module; the words of the lines above LOCAL are no names for them."""
    seen = set()
    for line in lines:
        if line.keyword in _KEYWORDS:
            reading.fault(line.number, Reason.of("files.before_local", keyword=line.keyword, line=str(line)))
        elif not _LOCAL_KEY.match(line.keyword):
            reading.fault(line.number, Reason.of("files.name_of_parameter", line=str(line)))
        elif line.keyword in seen:
            reading.note(
                line.number,
                Reason.of("files.keyword_once", keyword=line.keyword, line=str(line)),
                Reason.of("files.last_one_counts"),
            )
        seen.add(line.keyword)
    return tuple(LocalLine(line.keyword, line.words) for line in lines)
