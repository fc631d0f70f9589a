"""Where a session is replayed: copies of its base directories, a home and a state of its own; nothing else is written.

Whatever a log says, only this folder changes: an act that names a file elsewhere is not carried out.
"""

import shutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

from onika.desk.environment.diary_record import LABS
from onika.desk.environment.session_start import digests
from onika.files.state import session_log
from onika.files.state.session_log import LogLine
from onika.store.shipped import shipped
from onika.store.site import OWN, Site, open_site
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_LONGEST = 60
_TEXTS = frozenset(
    ("text", "description", "line", "picture", "command", "condition", "conditions", "flow", "tag", "note")
)
"""Fields of acts that name no file, whatever stands in them."""


@dataclass(frozen=True, slots=True)
class ReplayPlace:
    """The folder of a replay.

    names   where the folders that a log names are here, by what stands for them
    faults  what is not as it was when the session began
    """

    folder: Path
    site: Site
    names: Mapping[str, str]
    faults: tuple[Fault, ...] = field(default=())

    @property
    def state(self) -> Path:
        """The directory of what outlives a session."""
        return self.folder / "state"

    def here(self, record: Mapping[str, Any]) -> Mapping[str, Any]:
        """A record with the folders of this place."""
        text = msgspec.json.encode(record).decode()
        for name, path in self.names.items():
            text = text.replace(name, _inner(path))
        text = text.replace('"~/', f'"{_inner(str(self.site.home))}/')
        content: Mapping[str, Any] = msgspec.json.decode(text)
        return content

    def holds(self, path: Path) -> bool:
        """Whether a file stands in this folder, whatever links there are."""
        return path.resolve().is_relative_to(self.folder.resolve())

    def strange_path(self, value: Any) -> str:
        """The first thing in an act that names a file elsewhere than here or among what is shipped; empty: none."""
        return next((text for text in _texts(value) if self._is_strange(text)), "")

    def _is_strange(self, text: str) -> bool:
        if not text.startswith(("/", "~")) and "/" not in text and ".." not in text:
            return False
        if "://" in text:
            return text.startswith("file:")
        path = Path(text).resolve()
        return not (self.holds(path) or path.is_relative_to(shipped().resolve()))


def made(lines: Sequence[LogLine], bases: Sequence[Path], folder: Path, file: str) -> ReplayPlace:
    """The place for a session, with copies of these base directories, in their order; raises OSError.

    Where the line with which it began lacks, nobody knows how files were then: they are taken as they are.
    """
    begun = session_log.beginning(lines)
    facts: Mapping[str, Any] = (
        _mapping(begun[0].record["start"]) if begun else {"bases": [{"name": base.name} for base in bases]}
    )
    folder = folder.absolute()
    home = folder / "home"
    _own_files(facts, home)
    told_bases = [_mapping(base) for base in _list(facts.get("bases"))]
    own_at = facts.get("own_at", -1)
    copies = [_copy_of(number, base, own_at, folder) for number, base in enumerate(told_bases)]
    for copy, base in zip(copies, bases, strict=False):
        shutil.copytree(base, copy, dirs_exist_ok=True)
    others = [copy for number, copy in enumerate(copies) if number != own_at]
    for copy in others:
        copy.mkdir(parents=True, exist_ok=True)
    names = {f"{{base{number}}}": str(copy) for number, copy in enumerate(copies)}
    place = Place(file, (*begun, lines[0])[0].number)
    if begun:
        then = zip(told_bases, copies, strict=True)
        faults = tuple(fault for base, copy in then for fault in _different(_mapping(base.get("files")), copy, place))
    else:
        faults = (Fault(place, Reason.of("replay.start_lacks"), Reason.of("replay.as_files_are")),)
    return ReplayPlace(folder, open_site(others, {}, home), {**names, LABS: str(shipped())}, faults)


def _own_files(facts: Mapping[str, Any], home: Path) -> None:
    """What stood in the home of the user."""
    home.mkdir(parents=True, exist_ok=True)
    for name, text in _mapping(facts.get("own")).items():
        if _is_plain(name) and name != OWN and isinstance(text, str):
            (home / name).write_text(text, encoding="utf-8", errors="replace")


def _copy_of(number: int, base: Mapping[str, Any], own_at: int, folder: Path) -> Path:
    """Where the copy of a base directory stands; that of the user's own is in the home."""
    if number == own_at:
        return folder / "home" / OWN
    return folder / f"base{number}" / _plain(base.get("name"), number)


def _different(before: Mapping[str, Any], copy: Path, place: Place) -> Iterator[Fault]:
    """Files of a base directory that are not as they were when the session began."""
    now = digests(copy)
    for name in sorted(before.keys() | now.keys()):
        if before.get(name) != now.get(name):
            key = "replay.file_differs" if name in before and name in now else _KEYS[name in now]
            reason = Reason.of(key, name=name, base=copy.name)
            yield Fault(place, reason, Reason.of("replay.with_what_is_there"))


_KEYS = {True: "replay.file_new", False: "replay.file_lacks"}


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        for name, part in value.items():
            yield from () if name in _TEXTS else _texts(part)
    elif isinstance(value, list):
        for part in value:
            yield from _texts(part)
    elif isinstance(value, str):
        yield value


def _plain(name: Any, number: int) -> str:
    """The name of a folder as it was; one that leads elsewhere is not taken."""
    return str(name) if _is_plain(name) else f"base{number}"


def _is_plain(name: Any) -> bool:
    """Whether a file can have this name, and it leads nowhere."""
    if not isinstance(name, str) or name in ("", ".", ".."):
        return False
    return Path(name).name == name and name.isprintable() and len(name) <= _LONGEST


def _mapping(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _list(value: Any) -> Sequence[Any]:
    return value if isinstance(value, list) else ()


def _inner(text: str) -> str:
    """A text as it stands within JSON."""
    return msgspec.json.encode(text).decode()[1:-1]
