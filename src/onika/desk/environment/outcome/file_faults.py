"""Faults of files as lines: each by itself, or where a library or dictionary has many and lists them, as one."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from onika.wire import page
from onika.words.fault import Fault
from onika.words.reason import Reason

_MOST = 3
"""Files of one folder that are told one by one."""
_OF_FOLDER = {
    ("module", True): "run.files_left_out_of_library",
    ("module", False): "run.files_odd_in_library",
    ("dict", True): "run.files_left_out",
    ("dict", False): "run.files_odd",
}
"""What many faults in the files of a folder are said to be: by its name, and whether the files are left out."""
_SECOND = Reason.of("words.first_used")


def told(faults: Iterable[Fault]) -> tuple[page.Say, ...]:
    """Faults of files as lines."""
    groups: dict[tuple[Path, bool], list[Fault]] = {}
    for one in faults:
        groups.setdefault((Path(one.place.file).parent, _is_left_out(one)), []).append(one)
    return tuple(line for (folder, is_out), found in groups.items() for line in _lines(folder, found, is_out=is_out))


def _lines(folder: Path, found: list[Fault], *, is_out: bool) -> Iterator[page.Say]:
    count = len({one.place.file for one in found})
    if (folder.name, is_out) in _OF_FOLDER and count > _MOST:
        key = _OF_FOLDER[folder.name, is_out]
        yield _line(Reason.of(key, count=count, where=f"{folder.parent.name}/{folder.name}"), found)
        return
    for one in found:
        yield _line(one.sentence, [one])


def _line(reason: Reason, found: list[Fault]) -> page.Say:
    return page.Say("info" if all(one.is_note for one in found) else "warning", reason)


def _is_left_out(fault: Fault) -> bool:
    """Whether the file does not count; else it does and something in it is worth knowing."""
    return not fault.is_note or fault.instead == _SECOND
