"""A token of AL: bare where it cannot be mistaken, else in double quotes."""

import re

KEYWORDS = frozenset(
    [
        "BEGIN",
        "END",
        "COBEGIN",
        "COEND",
        "CASE",
        "OF",
        "IF",
        "THEN",
        "ELSEIF",
        "ELSE",
        "WHILE",
        "REPEAT",
        "UNTIL",
        "DONE",
        "NOT",
        "WHERE",
        "ICON",
        "DRIVE",
        "MOVE",
        "OPEN",
        "CLOSE",
        "HAND",
        "PAUSE",
        "DO",
        "RUN",
        "NOP",
        "TO",
        "USING",
        "WITH",
        "HOLE",
        "SYNCH",
        "BREAK",
        "OFF",
        "TAG",
        "TEST",
    ]
)
"""The words of the language, all in capitals; a name that is one of them stands in quotes."""

_BARE = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]*\Z")
_LABEL = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")


def show(text: str) -> str:
    """A name or tag, in quotes where it must be."""
    if _BARE.match(text) and text not in KEYWORDS:
        return text
    return quoted(text)


def quoted(text: str) -> str:
    """A text in double quotes, in which `\\"` and `\\\\` mean the sign itself."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def unquoted(text: str) -> str:
    """The text within quotes."""
    return re.sub(r"\\(.)", r"\1", text[1:-1])


def is_label(text: str) -> bool:
    """Whether a data item of this name may stand before its value, as in `duration=3.0`."""
    return bool(_LABEL.match(text)) and text not in KEYWORDS
