"""The argument line of a task: the words of a target's values, in order (dissertation §C.4, reading 40).

Words are parted by blanks. A word that is empty or holds blanks or quotes stands in double quotes, in which
`\\"` and `\\\\` mean the sign itself.
"""

import re
from collections.abc import Iterable

from onika.words.reason import Reason

_WORD = re.compile(r'"((?:[^"\\]|\\.)*)"(?=\s|\Z)|([^\s"]+)(?=\s|\Z)')


def split(line: str) -> list[str]:
    """The words of an argument line; raises ValueError where a quote is not closed or stands inside a word."""
    words = []
    rest = line.strip()
    while rest:
        match = _WORD.match(rest)
        if not match:
            raise ValueError(Reason.of("words.argument_line", rest=rest))
        words.append(match[2] if match[2] is not None else re.sub(r"\\(.)", r"\1", match[1]))
        rest = rest[match.end() :].lstrip()
    return words


def join(words: Iterable[str]) -> str:
    """One line from words, such that `split` gives the words again."""
    return " ".join(word if _bare(word) else _quoted(word) for word in words)


def _bare(word: str) -> bool:
    return bool(word) and not re.search(r'[\s"]', word)


def _quoted(word: str) -> str:
    return '"' + word.replace("\\", "\\\\").replace('"', '\\"') + '"'
