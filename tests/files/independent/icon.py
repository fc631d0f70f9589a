"""A.3, the upper-level icon file, and the lines of an icon that A.4 shares with it, read naively."""

import re
from typing import Any

from .script import Script, blanks, number, real

Types = dict[str, list[tuple[str, int]]]
"""Every type by its name in small letters: the type and number of its data items."""


def read(text: str, types: Types) -> dict[str, Any]:
    script = Script(text, extended=True)
    result = lines(script, types)
    script.end()
    if result["ONIKON"] in ("application start", "application end"):
        raise ValueError("no icon of a dictionary")
    return result


def lines(script: Script, types: Types) -> dict[str, Any]:
    kind = blanks(script.take("ONIKON")).lower()
    items = types[kind] if kind in types else _unknown(kind)
    targets = []
    while (target := script.new("TARGET")) is not None:
        targets.append(blanks(target).lower())
        if {"complete", "object", "nop", "start", "end"} & set(kind.split()) or targets[-1] not in types:
            raise ValueError("a target of " + kind)
        if "object" not in targets[-1].split():
            raise ValueError(target)
    description = blanks(script.maybe("DESC", ""))
    others: dict[str, str] = {}
    while (other := script.new("DESCIN")) is not None:
        code, _, text = blanks(other).partition(" ")
        small = code.split("-")[0]
        if code in others or not text or not (2 <= len(small) <= 3 and small.isascii() and small.islower()):
            raise ValueError("a language in " + other)
        if not all(part and part.isascii() and part.isalnum() for part in code.split("-")) or not small.isalpha():
            raise ValueError("a language in " + other)
        others[code] = text
    arm = script.new("ARM")
    if arm is not None and ("object" not in kind.split() or not re.fullmatch("[A-Za-z][A-Za-z0-9_.-]{0,199}", arm)):
        raise ValueError("an arm in " + arm)
    values: list[Any] = []
    for data, count in items:
        values.append([_value(data, word) for word in _elements(script.take("UI"), data, count)])
        if len(values[-1]) != count:
            raise ValueError("elements")
    if not items and script.take("UI") != "none":
        raise ValueError("none")
    return {
        "ONIKON": kind,
        "TARGET": targets,
        "DESC": description,
        "DESCIN": others,
        "ARM": arm or "",
        "UI": values,
        "PICT": picture(script),
    }


def picture(script: Script) -> list[str]:
    """As many rows as the first has digits; more than 32 only where the file is of version 2.0."""
    rows = [script.take("PICT")]
    if len(rows[0]) not in ((32, 48, 64) if script.is_new else (32,)):
        raise ValueError(rows[0])
    while len(rows) < len(rows[0]):
        rows.append(script.take("PICT"))
    return [row(text, at, len(rows)) for at, text in enumerate(rows)]


def row(text: str, at: int, size: int) -> str:
    """A 9 is black (reading 38), and so is the border (requirement B11)."""
    if len(text) != size or any(c not in "0123456789" for c in text):
        raise ValueError(text)
    return "8" * size if at in (0, size - 1) else "8" + text[1:-1].replace("9", "8") + "8"


def _unknown(kind: str) -> list[tuple[str, int]]:
    raise ValueError(kind)


def _elements(text: str, data: str, count: int) -> list[str]:
    """Words, those with blanks in double quotes; a single line is the rest of the line (reading 40)."""
    if data == "line" and count == 1:
        try:
            quoted = _quoted(text) if text[:1] == '"' else []
        except ValueError:
            quoted = []
        return quoted if len(quoted) == 1 else [text] if text else []
    return _quoted(text)


def _quoted(text: str) -> list[str]:
    result: list[str] = []
    at = 0
    while at < len(text):
        if text[at].isspace():
            at += 1
        elif text[at] == '"':
            word, at = "", at + 1
            while True:
                if at >= len(text):
                    raise ValueError("quote")
                if text[at] == '"':
                    break
                if text[at] == "\\":
                    at += 1
                    if at >= len(text):
                        raise ValueError("quote")
                word, at = word + text[at], at + 1
            at += 1
            if at < len(text) and not text[at].isspace():
                raise ValueError("quote within a word")
            result.append(word)
        else:
            word = ""
            while at < len(text) and not text[at].isspace():
                if text[at] == '"':
                    raise ValueError("quote within a word")
                word, at = word + text[at], at + 1
            result.append(word)
    return result


def _value(data: str, word: str) -> Any:
    if data in ("string", "line"):
        return word
    if data == "char":
        if len(word) != 1 or ord(word) > 255:
            raise ValueError(word)
        return word
    if data in ("float", "double"):
        return real(word)
    low, high = {"byte": (0, 255), "short": (-(2**15), 2**15 - 1), "int": (-(2**31), 2**31 - 1)}.get(
        data, (-(2**63), 2**63 - 1)
    )
    value = number(word)
    if not low <= value <= high:
        raise ValueError(word)
    return value
