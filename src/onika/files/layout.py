"""Keeps the layout of a file: carries its comments and blank lines over into a newer text (requirement B01)."""

import re
from collections.abc import Callable
from dataclasses import dataclass

from onika.files.line_matching import matches

Key = tuple[str, ...]

_BLANK = re.compile(r"[ \t]+")
_LINE = re.compile(r"[^\n]*\n|[^\n]+\Z")


@dataclass(frozen=True, slots=True)
class _Entry:
    """A line with what stands before it, as written."""

    lead: str
    raw: str
    key: Key


def words_of(line: str) -> Key:
    """What a line means, whatever its blanks."""
    return tuple(_BLANK.split(line))


def carry(former: str, new: str, key: Callable[[str], Key] = words_of) -> str:
    """The lines of `new` with the comments of `former`; a line of the same `key` stays as it was written there.

    The comments above a line that changed or went stay where they were. `new` itself must hold no comments. All its
    lines end as those of `former` do.
    """
    new = _ended_as(former, new)
    old_entries, old_tail = _entries(former, key)
    new_entries, new_tail = _entries(new, key)
    parts: list[str] = []
    old_end = new_end = 0
    for match in matches([entry.key for entry in old_entries], [entry.key for entry in new_entries]):
        leads = [entry.lead for entry in old_entries[old_end : match.old]]
        fresh = new_entries[new_end : match.new]
        parts += [lead + entry.raw for lead, entry in zip(leads, fresh, strict=False)]
        parts += [_comments(lead) for lead in leads[len(fresh) :]]
        parts += [entry.lead + entry.raw for entry in fresh[len(leads) :]]
        old_end, new_end = match.old + match.lines, match.new + match.lines
        parts += [entry.lead + entry.raw for entry in old_entries[match.old : old_end]]
    return "".join(parts) + (old_tail if old_entries else new_tail)


def carry_comments(former: str, new: str) -> str:
    """As `carry`, where `former` has comments at all; else `new` with the line ends of `former`."""
    has_comments = any(line.lstrip(" \t").startswith("#") for line in former.split("\n"))
    if has_comments:
        return carry(former, new)
    return _ended_as(former, new)


def _ended_as(former: str, new: str) -> str:
    """Where the first line of `former` ends as on Windows, `new` does in all; `new` has plain line ends."""
    if former.partition("\n")[0].endswith("\r"):
        return new.replace("\n", "\r\n")
    return new


def _entries(text: str, key: Callable[[str], Key]) -> tuple[list[_Entry], str]:
    entries, lead = [], ""
    for line in _LINE.findall(text):
        stripped = line.removeprefix("\ufeff").strip(" \t\r\n")
        if not stripped or stripped.startswith("#"):
            lead += line
        else:
            entries.append(_Entry(lead, line if line.endswith("\n") else line + "\n", key(stripped)))
            lead = ""
    return entries, lead


def _comments(lead: str) -> str:
    return "".join(line for line in _LINE.findall(lead) if line.strip())
