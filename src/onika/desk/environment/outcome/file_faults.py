"""Faults of files as lines: each by itself, or where a library or dictionary has many and lists them, as one."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from onika.desk.environment.outcome.remedy import plain
from onika.wire import page
from onika.words.fault import Fault
from onika.words.reason import Reason

_MOST = 3
"""Files of one folder that are told one by one."""
_LISTS = {"module": "library", "dict": "dictionary"}
_SECOND = Reason.of("words.first_used")


def told(faults: Iterable[Fault]) -> tuple[page.Say, ...]:
    """Faults of files as lines."""
    groups: dict[tuple[Path, bool], list[Fault]] = {}
    for one in faults:
        groups.setdefault((Path(one.place.file).parent, _is_left_out(one)), []).append(one)
    return tuple(line for (folder, is_out), found in groups.items() for line in _lines(folder, found, is_out=is_out))


def _lines(folder: Path, found: list[Fault], *, is_out: bool) -> Iterator[page.Say]:
    count = len({one.place.file for one in found})
    if folder.name in _LISTS and count > _MOST:
        what = "are left out" if is_out else "are used and have something odd"
        where = f"{folder.parent.name}/{folder.name}"
        yield _line(f"{count} files of {where} {what}; the {_LISTS[folder.name]} lists them", found)
        return
    for one in found:
        yield _line(plain(str(one)), [one])


def _line(text: str, found: list[Fault]) -> page.Say:
    return page.Say("info" if all(one.is_note for one in found) else "warning", text)


def _is_left_out(fault: Fault) -> bool:
    """Whether the file does not count; else it does and something in it is worth knowing."""
    return not fault.is_note or fault.instead == _SECOND
