"""Splits a text of AL into statements: one line, or several where a parenthesis is open, without comments."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.files.al import token as word
from onika.files.line import show
from onika.files.text_reading import TextReading
from onika.words.reason import Reason

_SIGN = re.compile(
    r"""(?P<blank>[ \t\r]+) | (?P<end>\n) | (?P<comment>\{[^}]*\})
      | (?P<text>"(?:[^"\\\n]|\\[^\n])*") | (?P<variant>\#[0-9]{1,9}) | (?P<sign>[();=])
      | (?P<word>[^\s"(){};=\#]+) | (?P<wrong>.)""",
    re.VERBOSE | re.DOTALL,
)
_WHERE = re.compile(r"^[ \t]*WHERE[ \t\r]*(?:\n|\Z)", re.MULTILINE)
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
_MOST_TOKENS = 10_000
"""Tokens of a statement."""


@dataclass(frozen=True, slots=True)
class Token:
    """A word, a quoted text, a variant such as `#2`, or one of the signs `( ) ; =`."""

    kind: str
    """word, text, variant or sign."""
    value: str
    start: int
    """Where it begins in the whole text."""
    end: int
    line: int

    def __str__(self) -> str:
        if self.kind == "text":
            return word.quoted(self.value)
        return self.value

    def says(self, *words: str) -> bool:
        """Whether it is one of these words or signs of the language."""
        return self.kind in ("word", "sign") and self.value in words


@dataclass(frozen=True, slots=True)
class Statement:
    """Its tokens, at least one."""

    tokens: tuple[Token, ...]

    @property
    def number(self) -> int:
        """The line on which it begins, from 1."""
        return self.tokens[0].line

    def __str__(self) -> str:
        return show(joined(self.tokens))


def joined(tokens: Sequence[Token]) -> str:
    """What tokens say, with one blank wherever some stood."""
    parts = []
    for at, token in enumerate(tokens):
        parts.append(" " if at and tokens[at - 1].end < token.start else "")
        parts.append(str(token))
    return "".join(parts)


def sentences(text: str, reading: TextReading) -> tuple[list[Statement], int]:
    """The sentences up to the line WHERE, and the place in `text` behind it, -1 where there is none.

    Faults go to `reading`, whose `end` becomes the last line of the sentences.
    """
    where = _WHERE.search(text)
    content = text[: where.start()] if where else text
    for number, line in enumerate(content.split("\n"), start=1):
        if reading.is_full:
            break
        if _CONTROL.search(line.removesuffix("\r")):
            reading.fault(number, Reason.of("files.printable_text", line=show(line)))
    reading.end = content.rstrip().count("\n") + 1
    return list(_grouped(content, reading)), where.end() if where else -1


def _grouped(text: str, reading: TextReading) -> Iterator[Statement]:
    """A new sentence on every line, but within parentheses, where only a word of the language begins one."""
    tokens: list[Token] = []
    depth = 0
    for token in _tokens(text, reading):
        if tokens and tokens[-1].line < token.line and (depth <= 0 or token.says(*word.KEYWORDS)):
            yield _whole(tokens, depth, reading)
            tokens, depth = [], 0
        tokens.append(token)
        if len(tokens) > _MOST_TOKENS:
            reading.fault(token.line, Reason.of("files.statement_long", most=_MOST_TOKENS))
            reading.is_full = True
            return
        depth += token.says("(") - token.says(")")
    if tokens:
        yield _whole(tokens, depth, reading)


def _whole(tokens: Sequence[Token], depth: int, reading: TextReading) -> Statement:
    sentence = Statement(tuple(tokens))
    if depth > 0:
        reading.fault(sentence.number, Reason.of("files.bracket_open", sentence=str(sentence)))
    return sentence


def _tokens(text: str, reading: TextReading) -> Iterator[Token]:
    at, number, last = 0, 1, 0
    while not reading.is_full and (match := _SIGN.match(text, at)):
        kind, value, at = str(match.lastgroup), match[0], match.end()
        if kind == "wrong":
            at = _pass_over(text, match.start(), number, None if number == last else reading)
            last = number
        elif kind in ("text", "variant", "sign", "word"):
            shown = word.unquoted(value) if kind == "text" else value
            yield Token(kind, shown, match.start(), at, number)
        number += value.count("\n")


def _pass_over(text: str, at: int, number: int, reading: TextReading | None) -> int:
    """Report a sign that begins nothing; gives where to go on: the end of the line where a brace or quote is open."""
    end = text.find("\n", at)
    end = len(text) if end < 0 else end
    if reading:
        reading.fault(number, _strange(text[at], show(text[at:end])))
    return end if text[at] in '{"' else at + 1


def _strange(sign: str, given: str) -> Reason:
    if sign == "{":
        return Reason.of("files.comment_open", given=given)
    if sign == '"':
        return Reason.of("files.quote_open", given=given)
    return Reason.of("files.any_token", given=given)
