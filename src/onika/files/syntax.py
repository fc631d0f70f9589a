"""The syntax definition file, `OnikaUpperSetUp.dta` (dissertation §A.7).

Of version 2.0 is the line DIMENSION behind NELEMS, as `DIMENSION NDOF`: there are as many elements as that constant of
the robot says, and NELEMS is what is usual. `DIMENSION NDOF 6` are six for each.
"""

from collections.abc import Mapping, Sequence

from onika.files.layout import carry_comments
from onika.files.line import FileLine, one_line, row, show, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED, VERSION
from onika.model.syntax import SPECIAL_TYPES, DataItem, Edge, IconType, Syntax
from onika.words.fault import Fault
from onika.words.name import SVAR_NAME
from onika.words.reason import Reason
from onika.words.value import ValueType

NAME = "OnikaUpperSetUp.dta"

_HEAD = (KeywordSlot("VERSION", Need.OPTIONAL),)
_TYPE = (KeywordSlot("ONIKON"), KeywordSlot("LEFTEDGE"), KeywordSlot("RIGHTEDGE"))
_ITEM = (KeywordSlot("VARNAME"), KeywordSlot("DATATYPE"), KeywordSlot("NELEMS"), KeywordSlot("DIMENSION", Need.OF_2_0))
_EDGE = (KeywordSlot("EDGENUM"), KeywordSlot("RGB"), KeywordSlot("NUMVERTS"), KeywordSlot("VERTICES"))
_TYPES = {kind.value: kind for kind in ValueType}

_Found = Mapping[str, FileLine | None]


def read(text: str, name: str, place_file: str) -> tuple[Syntax | None, tuple[Fault, ...]]:
    """The syntax of a text, whole or not at all; `name` completes the form of all formats."""
    reading = TextReading(place_file, Reason.of("files.name_left_out", name=name))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {"ONIKON", "EDGENUM"})
    reading.arrange(head, _HEAD)
    types: list[tuple[int, IconType]] = []
    edges: list[tuple[int, Edge]] = []
    for block in blocks:
        first = block[0]
        if first.keyword == "EDGENUM":
            edges.append((first.number, _edge(_arranged(block, _EDGE, reading), reading)))
            continue
        if edges:
            reading.fault(first.number, Reason.of("files.onikon_after_edges", first=str(first)))
        types.append((first.number, _type(block, reading)))
    _check_types(types, {edge.number for _, edge in edges}, reading)
    _check_edges(edges, reading)
    syntax = Syntax(tuple(kind for _, kind in types), tuple(edge for _, edge in edges))
    return (None if reading.broken else syntax), reading.faults


def write(syntax: Syntax, former: str = "") -> str:
    """The text of a syntax, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED if _is_extended(syntax) else VERSION)]
    parts += ["\n" + _show_type(kind) for kind in syntax.types]
    parts += ["\n" + _show_edge(edge) for edge in syntax.edges]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show_type(kind: IconType) -> str:
    parts = [row("ONIKON", one_line(kind.name)), row("LEFTEDGE", str(kind.left_edge))]
    parts.append(row("RIGHTEDGE", str(kind.right_edge)))
    for item in kind.items:
        parts += [row("VARNAME", one_line(item.name)), row("DATATYPE", item.type.value), row("NELEMS", str(item.count))]
        each = (str(item.each),) if item.each > 1 else ()
        parts += [row("DIMENSION", item.dimension, *each)] if item.dimension else []
    return "".join(parts)


def _is_extended(syntax: Syntax) -> bool:
    return any(item.dimension for kind in syntax.types for item in kind.items)


def _show_edge(edge: Edge) -> str:
    return (
        row("EDGENUM", str(edge.number))
        + row("RGB", *map(str, edge.rgb))
        + row("NUMVERTS", str(len(edge.vertices)))
        + row("VERTICES", *(str(move) for vertex in edge.vertices for move in vertex))
    )


def _arranged(block: Sequence[FileLine], slots: Sequence[KeywordSlot], reading: TextReading) -> _Found:
    return {keyword: lines[0] if lines else None for keyword, lines in reading.arrange(block, slots).items()}


def _type(block: Sequence[FileLine], reading: TextReading) -> IconType:
    head, *items = split(block, {"VARNAME"})
    by_keyword = _arranged(head, _TYPE, reading)
    kind = IconType(
        _text(by_keyword["ONIKON"], Reason.of("files.name_of_type"), reading),
        reading.whole(by_keyword["LEFTEDGE"], 0, low=0),
        reading.whole(by_keyword["RIGHTEDGE"], 0, low=0),
        tuple(_item(_arranged(item, _ITEM, reading), reading) for item in items),
    )
    if items and not kind.is_target:
        reading.fault(items[0][0].number, Reason.of("files.varname_misplaced", items=str(items[0][0])))
    return kind


def _item(by_keyword: _Found, reading: TextReading) -> DataItem:
    dimension, each = _dimension(by_keyword["DIMENSION"], reading)
    return DataItem(
        _text(by_keyword["VARNAME"], Reason.of("files.name_of_item"), reading),
        reading.choice(by_keyword["DATATYPE"], _TYPES, ValueType.STRING),
        reading.whole(by_keyword["NELEMS"], 1, low=1),
        dimension,
        each,
    )


def _dimension(line: FileLine | None, reading: TextReading) -> tuple[str, int]:
    """The constant that says how many elements there are, and how many for each that it counts."""
    if line is None:
        return "", 1
    name, *each = line.words or ("",)
    if SVAR_NAME.match(name) and all(word.isdecimal() and int(word) for word in each) and len(each) < 2:
        return name, int(each[0]) if each else 1
    meaning = Reason.of("files.name_of_constant")
    reading.fault(line.number, Reason.of("files.meaning_after", meaning=meaning, keyword=line.keyword, line=str(line)))
    return "", 1


def _text(line: FileLine | None, meaning: Reason, reading: TextReading) -> str:
    if line and not line.rest:
        reading.fault(
            line.number, Reason.of("files.meaning_after", meaning=meaning, keyword=line.keyword, line=str(line))
        )
    return line.text if line else ""


def _edge(by_keyword: _Found, reading: TextReading) -> Edge:
    red, green, blue = reading.wholes(by_keyword["RGB"], (0, 0, 0), low=0)
    if by_keyword["RGB"] and max(red, green, blue) > 255:
        reading.fault(by_keyword["RGB"].number, Reason.of("files.rgb_numbers", given=str(by_keyword["RGB"])))
    count = reading.whole(by_keyword["NUMVERTS"], 0, low=0)
    line = by_keyword["VERTICES"]
    moves: tuple[int, ...] = ()
    if line and len(line.words) != 2 * count:
        reading.fault(line.number, Reason.of("files.vertices", count=count, line=str(line)))
    elif line and count:
        moves = reading.wholes(line, (0,) * (2 * count))
    pairs = tuple(zip(moves[::2], moves[1::2], strict=True))
    return Edge(reading.whole(by_keyword["EDGENUM"], 0, low=0), (red, green, blue), pairs)


def _check_types(types: Sequence[tuple[int, IconType]], edges: set[int], reading: TextReading) -> None:
    """Names are unique without case, edges are defined, the types with a meaning of their own are there."""
    seen: set[str] = set()
    for number, kind in types:
        if kind.name.lower() in seen:
            reading.fault(number, Reason.of("files.every_type_once", name=show(kind.name)))
        seen.add(kind.name.lower())
        for edge in sorted({kind.left_edge, kind.right_edge} - edges):
            reading.fault(number, Reason.of("files.edge_undefined", edge=edge, name=show(kind.name)))
    for name in SPECIAL_TYPES:
        if name.lower() not in seen:
            reading.fault(reading.end, Reason.of("files.type_missing", name=name))


def _check_edges(edges: Sequence[tuple[int, Edge]], reading: TextReading) -> None:
    seen: set[int] = set()
    for number, edge in edges:
        if edge.number in seen:
            reading.fault(number, Reason.of("files.every_edge_once", number=edge.number))
        seen.add(edge.number)
