"""The lines that describe an onikon in `.onk` and `.appl` alike: ONIKON, DESC, UI, PICT (dissertation §A.3, §A.4).

Of version 2.0 are the lines TARGET, the types of the further targets of an action in their order, and DESCIN, the
description in another language behind its code: `DESCIN es abre la mano`; ARM, the task of the arm that a target was
made for; and PICT of 48 or 64 rows and digits.
"""

import re
from collections.abc import Mapping, Sequence

from onika.files.line import FileLine, one_line, row, show
from onika.files.picture import read_rows
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.model.onikon import Onikon
from onika.model.picture import SIZE, SIZES
from onika.model.syntax import DataItem, IconType, Syntax, has_word
from onika.words import argument
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of
from onika.words.value import Value, ValueType

SLOTS = (
    KeywordSlot("ONIKON"),
    KeywordSlot("TARGET", Need.OF_2_0, many=True),
    KeywordSlot("DESC", Need.SINCE_1_3),
    KeywordSlot("DESCIN", Need.OF_2_0, many=True),
    KeywordSlot("ARM", Need.OF_2_0),
    KeywordSlot("UI", many=True),
    KeywordSlot("PICT", many=True),
)

_LANGUAGE = re.compile(r"[a-z]{2,3}(?:-[A-Za-z0-9]+)*\Z")

Values = tuple[tuple[Value, ...], ...]


def read_icon(
    name: str, by_keyword: Mapping[str, list[FileLine]], syntax: Syntax, reading: TextReading
) -> Onikon | None:
    """The onikon of arranged lines; None for a target of unknown type, which is noted (requirement D16).

    A job or application of unknown type keeps its type's name and acts as a complete one. Other faults break `reading`.
    """
    line = by_keyword["ONIKON"][0] if by_keyword["ONIKON"] else None
    pictures = [(row.number, row.rest) for row in by_keyword["PICT"]]
    last = pictures[-1][0] if pictures else (line.number if line else 0)
    sizes = SIZES if reading.is_extended else (SIZE,)
    picture = read_rows(pictures, last, reading, sizes) if pictures else None
    kind = _kind(line, syntax, reading) if line else None
    if line is None or kind is None or picture is None:
        return None
    values = _values(by_keyword["UI"], kind, reading)
    is_own = syntax.find(line.text) is not None
    description = by_keyword["DESC"][0].text if by_keyword["DESC"] else ""
    more = tuple(_target(target, kind, is_own, syntax, reading) for target in by_keyword["TARGET"])
    words = _words_in(by_keyword["DESCIN"], reading)
    arm = _arm(by_keyword["ARM"], kind, reading)
    return Onikon(name, kind.name if is_own else line.text, description, values, picture, more, words, arm)


def write_icon(onikon: Onikon) -> str:
    """The lines of an onikon; raises ValueError for a text value with signs that no line holds."""
    values = [_show_values(values) for values in onikon.values] or ["none"]
    return (
        row("ONIKON", one_line(onikon.type))
        + "".join(row("TARGET", one_line(kind)) for kind in onikon.more_targets)
        + row("DESC", one_line(onikon.description))
        + "".join(row("DESCIN", language, one_line(text)) for language, text in onikon.words)
        + (row("ARM", one_line(onikon.arm)) if onikon.arm else "")
        + "".join(row("UI", text) for text in values)
        + "".join(row("PICT", text) for text in onikon.picture.rows)
    )


def _kind(line: FileLine, syntax: Syntax, reading: TextReading) -> IconType | None:
    type_of_icon = syntax.find(line.text)
    acting = type_of_icon or syntax.acting(line.text)
    if acting is None:
        reading.part(
            line.number, Reason.of("files.icon_type_unknown", line=str(line)), Reason.of("files.icon_left_out")
        )
    elif type_of_icon is None:
        reading.note(
            line.number,
            Reason.of("files.icon_type_unknown", line=str(line)),
            Reason.of("files.acts_as", name=acting.name),
        )
    return acting


def _target(line: FileLine, kind: IconType, is_own: bool, syntax: Syntax, reading: TextReading) -> str:
    """The name of one more target's type, as the syntax writes it; an icon of unknown type keeps it as it is."""
    target = syntax.find(line.text)
    if is_own and not kind.needs_target:
        reading.fault(line.number, Reason.of("files.no_line_target", name=kind.name, line=str(line)))
    elif not (target.is_target if target else has_word(line.text, "object") and not is_own):
        reading.fault(line.number, Reason.of("files.target_type_unknown", line=str(line)))
    return target.name if target else line.text


def needs_extension(onikon: Onikon) -> bool:
    """Whether its lines are of version 2.0."""
    return bool(onikon.more_targets or onikon.words or onikon.arm or onikon.picture.is_larger)


def _arm(lines: Sequence[FileLine], kind: IconType, reading: TextReading) -> str:
    """The task of the arm that a target was made for; empty: none is named."""
    if not lines:
        return ""
    line = lines[0]
    if not kind.is_target:
        reading.fault(line.number, Reason.of("files.arm_of_target", name=kind.name, line=str(line)))
    elif not TASK_NAME.fullmatch(line.rest):
        reading.fault(line.number, Reason.of("files.arm_line", line=str(line)))
    return line.rest


def _words_in(lines: Sequence[FileLine], reading: TextReading) -> tuple[tuple[str, str], ...]:
    """The description in other languages, each once."""
    items: dict[str, str] = {}
    for line in lines:
        language, _, text = line.text.partition(" ")
        if not _LANGUAGE.match(language) or not text:
            reading.fault(line.number, Reason.of("files.descin_line", line=str(line)))
        elif language in items:
            reading.fault(line.number, Reason.of("files.descin_once", language=language, line=str(line)))
        else:
            items[language] = text
    return tuple(items.items())


def _values(lines: Sequence[FileLine], kind: IconType, reading: TextReading) -> Values:
    """One tuple for every data item of the type; `none` where it has none."""
    if not lines:
        return ()
    if not kind.items:
        for line in lines:
            if line.rest != "none" or line is not lines[0]:
                reading.fault(line.number, Reason.of("files.ui_none", name=kind.name, line=str(line)))
        return ()
    if len(lines) != len(kind.items):
        names = ", ".join(item.name for item in kind.items)
        reading.fault(
            lines[-1].number, Reason.of("files.ui_count", count=len(kind.items), names=names, count_2=len(lines))
        )
    return tuple(_elements(line, item, reading) for line, item in zip(lines, kind.items, strict=False))


def _elements(line: FileLine, item: DataItem, reading: TextReading) -> tuple[Value, ...]:
    try:
        words = _words(line, item)
    except ValueError as error:
        reading.fault(line.number, reason_of(error))
        return ()
    if not item.takes(len(words)):
        reading.fault(
            line.number,
            Reason.of(
                "files.ui_elements",
                count=item.count
                if item.each == 1
                else Reason.of("files.times_each", each=item.each, name=item.dimension),
                value=item.type.value,
                name=item.name,
                count_2=len(words),
                line=str(line),
            ),
        )
    values: list[Value] = []
    for word in words:
        try:
            values.append(item.type.parse(word))
        except ValueError as error:
            reading.fault(line.number, reason_of(error))
    return tuple(values) if len(values) == len(words) else ()  # fewer would be others


def _words(line: FileLine, item: DataItem) -> list[str]:
    """The elements as written; a single `line` is the rest of the line unless it is one quoted word (reading 40)."""
    if item.type is not ValueType.LINE or item.count != 1:
        return argument.split(line.rest)
    if not line.rest.startswith('"'):
        return [line.rest] if line.rest else []
    try:
        words = argument.split(line.rest)
    except ValueError:
        return [line.rest]
    return words if len(words) == 1 else [line.rest]


def _show_values(values: Sequence[Value]) -> str:
    text = argument.join(value if isinstance(value, str) else repr(value) for value in values)
    if any(ord(sign) < 32 or 127 <= ord(sign) < 160 for sign in text):
        raise ValueError(Reason.of("files.text_of_one_line", text=show(text)))
    return text
