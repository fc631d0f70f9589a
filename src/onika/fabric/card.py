"""The card of a site: what it is called, and the addresses of its runtimes and libraries (requirement F06).

A card is a hint. Whoever follows it is judged by what is there: a token, a certificate, a signed index.
"""

import re
from dataclasses import dataclass
from datetime import date

from onika.files.library_index import KEY, NO_KEY
from onika.files.line import one_line, row
from onika.store.remote.address import web_address
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of

LARGEST = 4000
"""Bytes of a signed card."""
MOST = 8
"""Runtimes of a card; as many libraries."""
_RUNTIME = re.compile(r"wss?://[A-Za-z0-9.\[\]:_-]{1,255}(?:/[A-Za-z0-9._/-]{0,200})?\Z")
_ROBOT = re.compile(r"[A-Za-z][A-Za-z0-9_.-]{0,39}\Z")
_SERIAL = re.compile(r"[1-9][0-9]{0,11}\Z")
_KEYWORDS = ("CARD", "SERIAL", "UNTIL", "NEXTKEY", "DESC", "RUNTIME", "LIBRARY", "EOF")
_ONCE = ("CARD", "SERIAL", "UNTIL", "NEXTKEY", "DESC", "EOF")
_LONGEST_NAME = 60
_LONGEST_TEXT = 300


@dataclass(frozen=True, slots=True)
class OfferedRuntime:
    """A runtime that a site offers, with the robots that it drives."""

    address: str
    robots: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class VisitingCard:
    """What a site says of itself."""

    name: str
    serial: int
    """It only grows: seconds of UTC when the card was made."""
    until: date
    """The last day on which it counts."""
    description: str = ""
    runtimes: tuple[OfferedRuntime, ...] = ()
    libraries: tuple[str, ...] = ()
    next_key: str = ""
    """The fingerprint of the key that signs from now on, where that is another."""


def write(card: VisitingCard) -> bytes:
    """The text of a card; raises ValueError with the reason where it is none that could be read."""
    lines = [
        row("CARD", card.name),
        row("SERIAL", str(card.serial)),
        row("UNTIL", card.until.isoformat()),
        row("NEXTKEY", card.next_key or NO_KEY),
        row("DESC", one_line(card.description)[:_LONGEST_TEXT]),
        *(row("RUNTIME", runtime.address, *runtime.robots) for runtime in card.runtimes),
        *(row("LIBRARY", library) for library in card.libraries),
        row("EOF"),
    ]
    text = "".join(lines).encode()
    again = read(text)
    if isinstance(again, Reason):
        raise ValueError(again)
    return text


def read(text: bytes) -> VisitingCard | Reason:
    """The card of a text, or the first thing that is wrong with it."""
    try:
        return _card(_lines(text))
    except ValueError as wrong:
        return reason_of(wrong)


def _lines(text: bytes) -> list[tuple[str, str]]:
    """Keywords and what follows them; raises ValueError."""
    if len(text) > LARGEST:
        raise ValueError(Reason.of("fabric.card_large", most=LARGEST))
    try:
        parts = [line.partition(" ") for line in text.decode("utf-8").splitlines()]
    except UnicodeDecodeError:
        raise ValueError(Reason.of("fabric.card_line", line="CARD")) from None
    lines = [(keyword, rest.strip()) for keyword, _, rest in parts]
    keywords = [keyword for keyword, _ in lines]
    for keyword in keywords:
        if keyword not in _KEYWORDS:
            raise ValueError(Reason.of("fabric.card_line", line=one_line(keyword)[:40]))
    for keyword in _ONCE:
        if keywords.count(keyword) != 1:
            raise ValueError(Reason.of("fabric.card_line", line=keyword))
    if keywords[-1] != "EOF":
        raise ValueError(Reason.of("fabric.card_line", line="EOF"))
    return lines


def _card(lines: list[tuple[str, str]]) -> VisitingCard:
    only = dict(lines)
    if not TASK_NAME.match(only["CARD"]) or len(only["CARD"]) > _LONGEST_NAME:
        raise ValueError(Reason.of("fabric.card_name", name=one_line(only["CARD"])[:_LONGEST_NAME]))
    if not _SERIAL.match(only["SERIAL"]):
        raise ValueError(Reason.of("fabric.card_line", line="SERIAL"))
    next_key = "" if only["NEXTKEY"] == NO_KEY else only["NEXTKEY"]
    if next_key and not KEY.match(next_key):
        raise ValueError(Reason.of("fabric.card_line", line="NEXTKEY"))
    runtimes = tuple(_runtime(rest) for keyword, rest in lines if keyword == "RUNTIME")
    libraries = tuple(_library(rest) for keyword, rest in lines if keyword == "LIBRARY")
    if max(len(runtimes), len(libraries)) > MOST:
        raise ValueError(Reason.of("fabric.card_many", most=MOST))
    description = one_line(only["DESC"])[:_LONGEST_TEXT]
    return VisitingCard(
        only["CARD"], int(only["SERIAL"]), _day(only["UNTIL"]), description, runtimes, libraries, next_key
    )


def _runtime(text: str) -> OfferedRuntime:
    address, *robots = text.split() or [""]
    if not _RUNTIME.match(address) or len(robots) > MOST or not all(map(_ROBOT.match, robots)):
        raise ValueError(Reason.of("fabric.card_line", line="RUNTIME"))
    return OfferedRuntime(address, tuple(robots))


def _library(text: str) -> str:
    if isinstance(web_address(text), Reason):
        raise ValueError(Reason.of("fabric.card_line", line="LIBRARY"))
    return text


def _day(text: str) -> date:
    try:
        return date.fromisoformat(text)
    except ValueError:
        raise ValueError(Reason.of("fabric.card_line", line="UNTIL")) from None
