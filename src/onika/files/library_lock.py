"""The lock, `onika.lock` in a base directory: which libraries of others it uses, and what was agreed to (X16).

A format of our own. It names the signer of each library, the version of its index, and every file by its SHA-256; of
each task stands what it may write and which devices it may touch. It is a text that is kept with the base directory.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date

from onika.files import library_index
from onika.files.library_index import KEY
from onika.files.line import FileLine, one_line, row, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.words.fault import Fault
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

NAME = "onika.lock"
NOTHING = "nothing"
"""What a task writes, or touches, that does neither."""

_HEAD = (KeywordSlot("VERSION"),)
_LIBRARY = (
    KeywordSlot("LIBRARY"),
    KeywordSlot("SIGNER"),
    KeywordSlot("INDEX"),
    KeywordSlot("NEXTKEY", Need.OPTIONAL),
    KeywordSlot("RIGHTS", Need.OPTIONAL),
    KeywordSlot("FILE", Need.OPTIONAL, many=True),
    KeywordSlot("WRITES", Need.OPTIONAL, many=True),
    KeywordSlot("MAY", Need.OPTIONAL, many=True),
    KeywordSlot("BASE", Need.OPTIONAL, many=True),
)
_ALL = "all"
_DIGEST = re.compile(r"sha256:([0-9a-f]{64})\Z")
_NUMBER = re.compile(r"[0-9]{1,9}\Z")


@dataclass(frozen=True, slots=True)
class LockedFile:
    """One file: its SHA-256 in hexadecimal and its size in bytes."""

    digest: str
    size: int


@dataclass(frozen=True, slots=True)
class Agreement:
    """What a task may do: which state variables it writes, by the names that it has for them, and what it touches."""

    writes: frozenset[str] = frozenset()
    touches: frozenset[str] = frozenset()
    """Its devices."""


@dataclass(frozen=True, slots=True)
class LockedLibrary:
    """A library of others as a base directory uses it."""

    name: str
    address: str
    """Where it is: an `https` address, or a folder."""
    signer: str
    """The fingerprint of the key that was trusted."""
    trusted: str
    """Since when, and by whom."""
    version: int
    index: str
    """The SHA-256 of the signed index."""
    until: date
    next_key: str = ""
    files: Mapping[str, LockedFile] = field(default_factory=dict)
    agreed: Mapping[str, Agreement] = field(default_factory=dict)
    """By tasks."""
    bases: Mapping[str, str] = field(default_factory=dict)
    """The SHA-256 of what own copies of files began with, where that is no more what the library has; by paths."""
    has_all_rights: bool = False
    """Whether its code may do what its user may; else it may compute, and nothing else."""


def read(text: str, _name: str, place_file: str) -> tuple[tuple[LockedLibrary, ...] | None, tuple[Fault, ...]]:
    """The libraries of a lock, all or none."""
    reading = TextReading(place_file, Reason.of("files.no_lock"), most_lines=4 * library_index.MOST_FILES)
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {"LIBRARY"})
    reading.arrange(head, _HEAD)
    libraries: dict[str, LockedLibrary] = {}
    for block in blocks:
        library = _library(block, reading)
        if library is None:
            continue
        if library.name in libraries:
            reading.fault(block[0].number, Reason.of("files.every_name_once", given=str(block[0])))
        libraries[library.name] = library
    return (None if reading.broken else tuple(libraries.values())), reading.faults


def write(libraries: Iterable[LockedLibrary], _former: str = "") -> str:
    """The text of a lock, its libraries and files in order, so that a difference reads well."""
    parts = [row("VERSION", EXTENDED)]
    for library in sorted(libraries, key=lambda library: library.name):
        parts += [
            "\n",
            row("LIBRARY", library.name, one_line(library.address)),
            row("SIGNER", library.signer, one_line(library.trusted)),
            row("INDEX", str(library.version), f"sha256:{library.index}", library.until.isoformat()),
        ]
        parts += [row("NEXTKEY", library.next_key)] if library.next_key else []
        parts += [row("RIGHTS", _ALL)] if library.has_all_rights else []
        parts += [
            row("FILE", path, f"sha256:{file.digest}", str(file.size)) for path, file in sorted(library.files.items())
        ]
        agreed = sorted(library.agreed.items())
        parts += [row("WRITES", task, *_words(agreement.writes)) for task, agreement in agreed]
        parts += [row("MAY", task, *_words(agreement.touches)) for task, agreement in agreed if agreement.touches]
        parts += [row("BASE", path, f"sha256:{digest}") for path, digest in sorted(library.bases.items())]
    return "".join([*parts, "\n", row("EOF")])


def _words(names: frozenset[str]) -> tuple[str, ...]:
    return tuple(sorted(names)) or (NOTHING,)


def _library(block: Sequence[FileLine], reading: TextReading) -> LockedLibrary | None:
    """What a block says; None with its faults where it cannot be read."""
    by_keyword = reading.arrange(block, _LIBRARY)
    if not all(by_keyword[keyword] for keyword in ("LIBRARY", "SIGNER", "INDEX")):
        return None
    head, signer, index = (by_keyword[keyword][0] for keyword in ("LIBRARY", "SIGNER", "INDEX"))
    next_key = by_keyword["NEXTKEY"][0].rest if by_keyword["NEXTKEY"] else ""
    pinned, wrong = _pinned(index), _wrong_line(by_keyword)
    if wrong is not None or pinned is None:
        _wrong(wrong or index, reading)
        return None
    version, digest, until = pinned
    return LockedLibrary(
        head.words[0],
        head.rest.partition(" ")[2].strip(),
        signer.words[0],
        " ".join(signer.words[1:]),
        version,
        digest,
        until,
        next_key,
        _files(by_keyword["FILE"], reading),
        _agreed(by_keyword["WRITES"], by_keyword["MAY"], reading),
        _bases(by_keyword["BASE"], reading),
        has_all_rights=bool(by_keyword["RIGHTS"]),
    )


def _wrong_line(by_keyword: Mapping[str, Sequence[FileLine]]) -> FileLine | None:
    """The first line of a block, but for the index and the lists, that says what cannot be."""
    head, signer = by_keyword["LIBRARY"][0], by_keyword["SIGNER"][0]
    if len(head.words) < 2 or not TASK_NAME.match(head.words[0]):
        return head
    if not signer.words or not KEY.match(signer.words[0]):
        return signer
    wrong = [line for line in by_keyword["NEXTKEY"] if line.rest and not KEY.match(line.rest)]
    wrong += [line for line in by_keyword["RIGHTS"] if line.rest != _ALL]
    return next(iter(wrong), None)


def _pinned(line: FileLine) -> tuple[int, str, date] | None:
    """The version, the digest and the last day of an index."""
    if len(line.words) != 3 or not _NUMBER.match(line.words[0]):
        return None
    digest = _DIGEST.match(line.words[1])
    try:
        until = date.fromisoformat(line.words[2])
    except ValueError:
        return None
    return None if digest is None else (int(line.words[0]), digest[1], until)


def _files(lines: Iterable[FileLine], reading: TextReading) -> dict[str, LockedFile]:
    files: dict[str, LockedFile] = {}
    for line in lines:
        digest = _DIGEST.match(line.words[1]) if len(line.words) == 3 else None
        if digest is None or not _NUMBER.match(line.words[2]) or not library_index.is_path(line.words[0]):
            _wrong(line, reading)
        elif line.words[0] in files:
            reading.fault(line.number, Reason.of("files.every_name_once", given=str(line)))
        else:
            files[line.words[0]] = LockedFile(digest[1], int(line.words[2]))
    return files


def _bases(lines: Iterable[FileLine], reading: TextReading) -> dict[str, str]:
    bases: dict[str, str] = {}
    for line in lines:
        digest = _DIGEST.match(line.words[1]) if len(line.words) == 2 else None
        if digest is None or not library_index.is_path(line.words[0]):
            _wrong(line, reading)
        elif line.words[0] in bases:
            reading.fault(line.number, Reason.of("files.every_name_once", given=str(line)))
        else:
            bases[line.words[0]] = digest[1]
    return bases


def _agreed(writes: Iterable[FileLine], touches: Iterable[FileLine], reading: TextReading) -> dict[str, Agreement]:
    written, touched = _names_by_task(writes, reading), _names_by_task(touches, reading)
    return {
        task: Agreement(written.get(task, frozenset()), touched.get(task, frozenset()))
        for task in written.keys() | touched.keys()
    }


def _names_by_task(lines: Iterable[FileLine], reading: TextReading) -> dict[str, frozenset[str]]:
    names: dict[str, frozenset[str]] = {}
    for line in lines:
        if len(line.words) < 2 or not TASK_NAME.match(line.words[0]):
            _wrong(line, reading)
        elif line.words[0] in names:
            reading.fault(line.number, Reason.of("files.every_name_once", given=str(line)))
        else:
            names[line.words[0]] = frozenset(line.words[1:]) - {NOTHING}
    return names


def _wrong(line: FileLine, reading: TextReading) -> None:
    reading.fault(line.number, Reason.of("files.lock_line", line=str(line)))
