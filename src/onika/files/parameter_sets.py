"""The file of a configuration's parameter sets, `conf/NAME.sets`: a format of our own."""

from collections.abc import Iterable, Sequence

from onika.files.layout import carry_comments
from onika.files.line import FileLine, one_line, row, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.model.parameter_set import ParameterSet
from onika.model.task import LocalLine
from onika.words.fault import Fault
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

ENDING = ".sets"

_HEAD = (KeywordSlot("VERSION"),)
_SET = (KeywordSlot("SET"), KeywordSlot("LOCAL", Need.OPTIONAL, many=True))


def read(text: str, name: str, place_file: str) -> tuple[tuple[ParameterSet, ...] | None, tuple[Fault, ...]]:
    """The sets of a text, all or none; `name` is that of the configuration."""
    reading = TextReading(place_file, Reason.of("files.no_parameter_set", name=name))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {"SET"})
    reading.arrange(head, _HEAD)
    sets: dict[str, ParameterSet] = {}
    for block in blocks:
        parameter_set = _set(block, reading)
        if parameter_set.name in sets:
            reading.fault(block[0].number, Reason.of("files.every_name_once", given=str(block[0])))
        sets[parameter_set.name] = parameter_set
    return (None if reading.broken else tuple(sets.values())), reading.faults


def write(sets: Iterable[ParameterSet], former: str = "") -> str:
    """The text of parameter sets, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED)]
    for parameter_set in sets:
        parts += ["\n", row("SET", one_line(parameter_set.name))]
        parts += [row("LOCAL", task, line.key, *line.words) for task, line in parameter_set.values]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _set(block: Sequence[FileLine], reading: TextReading) -> ParameterSet:
    by_keyword = reading.arrange(block, _SET)
    name = block[0].text
    if not name:
        reading.fault(block[0].number, Reason.of("files.text_after", keyword="SET", line=str(block[0])))
    values: dict[tuple[str, str], LocalLine] = {}
    for line in by_keyword["LOCAL"]:
        if len(line.words) < 2 or not TASK_NAME.match(line.words[0]):
            reading.fault(line.number, Reason.of("files.parameter_of_task", line=str(line)))
            continue
        task, key, *words = line.words
        if (task, key) in values:
            reading.fault(line.number, Reason.of("files.every_name_once", given=str(line)))
        values[task, key] = LocalLine(key, tuple(words))
    return ParameterSet(name, tuple((task, line) for (task, _), line in values.items()))
