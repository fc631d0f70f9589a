"""A.5 to A.8: preferences, buttons, the syntax and the pictures of start and stop, read naively."""

import re
from typing import Any

from .icon import row
from .script import Script, blanks, number, numbers, one_of, words, yes

LENGTHS = ("LINELEN", "MINSIZE", "MINPINSEP", "STEPSIZE", "PINLENGTH", "CONNSEP", "LOCISIZE", "HITTOL")
SHOWN = ("INCONST", "OUTCONST", "INVAR", "OUTVAR")
WINDOWS = ("LEXI", "CONF", "DICT", "APPL")
SPOTS = ("STAT", "LOCUS", "MAIN", "BUTTON")
ORDER = (*LENGTHS[:6], *SHOWN, "LOCISIZE", "HITTOL", "RATE", "LEXI", "CONF", "STAT", "LOCUS", "DICT", "APPL", "MAIN",
         "BUTTON", "STATINFO")  # fmt: skip
_COLUMNS = """rmod rtpu tid S crit state cycle miss ref-F ref-T mez-F mez-T ptime tot-C tick
    min-U max-U avg-U min-C max-C avg-C warn"""
COLUMNS = set(_COLUMNS.split())
DATA = ("string", "line", "char", "byte", "float", "double", "long", "int", "short")
SPECIAL = ("application start", "application end", "complete job", "complete application", "complete nop")


def preferences(text: str) -> dict[str, Any]:
    """What the file says; nothing of what it lacks."""
    script = Script(text)
    result: dict[str, Any] = {}
    for keyword in ORDER:
        if keyword == "STEPSIZE" and script.next == "STEPWISE":
            result[keyword] = _length(script.take("STEPWISE"))
        elif script.next == keyword:
            result[keyword] = _preference(keyword, script.take(keyword))
    script.end()
    return result


def _preference(keyword: str, text: str) -> Any:
    if keyword in LENGTHS:
        return _length(text)
    if keyword in SHOWN:
        return yes(text)
    if keyword == "RATE":
        return one_of(text, "frequency", "period")
    if keyword == "STATINFO":
        if not set(words(text)) <= COLUMNS or len(set(words(text))) < len(words(text)):
            raise ValueError(text)
        return words(text)
    place = numbers(text)
    if len(place) != (4 if keyword in WINDOWS else 2) or min(place[2:], default=1) < 1:
        raise ValueError(text)
    return place


def _length(text: str) -> int:
    if number(text) < 1:
        raise ValueError(text)
    return number(text)


def buttons(text: str) -> list[tuple[str, str, bool]]:
    script = Script(text)
    result = []
    while script.next == "BUTTON":
        button, command = blanks(script.take("BUTTON")), script.take("FUNCTION")
        if not button or not command:
            raise ValueError("text")
        spawn = script.take("SPAWNTTY") if script.next == "SPAWNTTY" else script.maybe("SPAWNNTTY", "no")
        result.append((button, command, yes(spawn)))
    script.end()
    return result


def syntax(text: str) -> dict[str, Any]:
    script = Script(text, extended=True)
    types, edges = [], []
    while script.next == "ONIKON":
        kind = blanks(script.take("ONIKON"))
        left, right = number(script.take("LEFTEDGE")), number(script.take("RIGHTEDGE"))
        items = []
        while script.next == "VARNAME":
            item = blanks(script.take("VARNAME")), one_of(script.take("DATATYPE"), *DATA), number(script.take("NELEMS"))
            if item[2] < 1 or not item[0]:
                raise ValueError("item")
            constant = script.new("DIMENSION")
            form = re.fullmatch(r"([A-Z][A-Z0-9_^]*)(?:[ \t]+([0-9]+))?", constant or "A")
            if form is None or (form[2] and int(form[2]) < 1):
                raise ValueError(constant)
            items.append((*item, form[1] if constant else "", int(form[2] or 1)))
        if not kind or (items and "object" not in kind.lower().split(" ")):
            raise ValueError(kind)
        types.append((kind, left, right, items))
    while script.next == "EDGENUM":
        edge = number(script.take("EDGENUM"))
        rgb, count, moves = numbers(script.take("RGB")), number(script.take("NUMVERTS")), script.take("VERTICES")
        if edge < 0 or len(rgb) != 3 or not 0 <= min(rgb) <= max(rgb) <= 255 or len(numbers(moves)) != 2 * count:
            raise ValueError("edge")
        edges.append((edge, rgb, numbers(moves)))
    script.end()
    names, existing = [kind[0].lower() for kind in types], [edge[0] for edge in edges]
    if len(set(names)) < len(names) or len(set(existing)) < len(existing) or not set(SPECIAL) <= set(names):
        raise ValueError("types or edges")
    if not {edge for kind in types for edge in kind[1:3]} <= set(existing):
        raise ValueError("an edge that is not defined")
    return {"types": types, "edges": edges}


def picture(text: str) -> list[str]:
    """Lines of as many characters as there are, 32, 48 or 64, "nor are there any other lines in the files"."""
    parts = [line[:-1] if line.endswith("\r") else line for line in text.split("\n")]
    while parts and not parts[-1].strip(" \t"):
        parts.pop()
    if len(parts) not in (32, 48, 64):
        raise ValueError("rows")
    return [row(line, at, len(parts)) for at, line in enumerate(parts)]
