"""The index of a library that others may use: one text that names all its files, with the small ones in it (X16, F03).

A line `TEXT path size` is followed by as many bytes and a line end; of every other file stand size and SHA-256 in a
line `CODE path size sha256:digest`. The name of the library is part of it: signed, it is no other library's index.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import date
from hashlib import sha256

from onika.files.line import one_line, row
from onika.words.name import TASK_NAME
from onika.words.reason import NOTHING, Reason, reason_of

FORMAT = "1"
LARGEST_FILE = 10_000_000
"""Bytes of a file."""
LARGEST_TEXT = 50_000_000
"""Bytes of an index, unpacked."""
MOST_FILES = 20_000
NO_KEY = "none"

ENDINGS: Mapping[str, tuple[str, ...]] = {
    "module": (".py", ".rmod", ".toml", ".dta"),
    "conf": (".conf", ".sets"),
    "dict": (".onk", ".dta"),
    "appl": (".appl", ".test"),
    "world": (),
    "robot": (),
    "net": (),
}
"""The folders of a library, and how names of files end there; where nothing stands, any way."""

KEY = re.compile(r"SHA256:[A-Za-z0-9+/]{43}\Z")
"""A key's fingerprint, as `ssh-keygen -l` writes it."""

_PART = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.+^-]{0,199}\Z")
_DIGEST = re.compile(r"sha256:([0-9a-f]{64})\Z")
_SIZE = re.compile(r"[0-9]{1,9}\Z")
_VERSION = re.compile(r"[1-9][0-9]{0,8}\Z")
_LONGEST_LINE = 2000
_DEEPEST = 4


@dataclass(frozen=True, slots=True)
class IndexedFile:
    """One file of a library: its path there, its size in bytes, its SHA-256 in hexadecimal."""

    path: str
    size: int
    digest: str
    content: bytes | None = None
    """What it holds, where that stands in the index."""


@dataclass(frozen=True, slots=True)
class LibraryIndex:
    """What a library offers."""

    name: str
    version: int
    """It only grows."""
    made: date
    until: date
    """The last day on which this may be taken for the newest."""
    next_key: str = ""
    """The fingerprint of the key that signs from now on, where that is another."""
    description: str = ""
    pack: str = ""
    """The SHA-256 of one file that holds all those that do not stand here; empty: there is none."""
    pack_size: int = 0
    files: Mapping[str, IndexedFile] = field(default_factory=dict)
    """By their paths."""


def is_path(path: str) -> bool:
    """Whether a path is that of a file of a library: in a folder of it, nothing hidden, nothing that leads out."""
    folder, *parts = path.split("/")
    if folder not in ENDINGS or not parts or len(parts) >= _DEEPEST or not all(map(_PART.match, parts)):
        return False
    endings = ENDINGS[folder]
    return not endings or (len(parts) == 1 and path.endswith(endings))


def indexed_text(path: str, content: bytes) -> IndexedFile:
    """A file whose content stands in the index."""
    return IndexedFile(path, len(content), sha256(content).hexdigest(), content)


def write(index: LibraryIndex) -> bytes:
    """The text of an index, its files in the order of their paths."""
    head = [
        row("ONIKA", FORMAT),
        row("LIBRARY", index.name),
        row("VERSION", str(index.version)),
        row("DATE", index.made.isoformat()),
        row("UNTIL", index.until.isoformat()),
        row("NEXTKEY", index.next_key or NO_KEY),
        row("DESC", one_line(index.description)[: _LONGEST_LINE // 2]),
    ]
    head += [row("PACK", str(index.pack_size), f"sha256:{index.pack}")] if index.pack else []
    parts = ["".join(head).encode()]
    for path in sorted(index.files):
        file = index.files[path]
        if file.content is None:
            parts.append(row("CODE", path, str(file.size), f"sha256:{file.digest}").encode())
        else:
            parts += [row("TEXT", path, str(file.size)).encode(), file.content, b"\n"]
    return b"".join([*parts, row("EOF").encode()])


def read(data: bytes) -> LibraryIndex | Reason:
    """The index of a text, or the first thing that is wrong with it: nothing is made of half an index."""
    try:
        return _Reading(data).index()
    except ValueError as wrong:
        return reason_of(wrong)


class _Reading:
    """Goes through the bytes once; raises ValueError with the reason at the first thing that is wrong."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def index(self) -> LibraryIndex:
        if self._words("ONIKA", 1)[0] != FORMAT:
            raise ValueError(Reason.of("files.index_newer"))
        name = self._matching("LIBRARY", TASK_NAME)
        version = int(self._matching("VERSION", _VERSION))
        made, until = self._day("DATE"), self._day("UNTIL")
        next_key = self._words("NEXTKEY", 1)[0]
        if next_key != NO_KEY and not KEY.match(next_key):
            raise ValueError(Reason.of("files.index_line", line="NEXTKEY"))
        _, description = self._line("DESC")
        pack, pack_size = self._pack()
        key = "" if next_key == NO_KEY else next_key
        files = self._files()
        return LibraryIndex(name, version, made, until, key, one_line(description), pack, pack_size, files)

    def _pack(self) -> tuple[str, int]:
        """The digest and the size of the pack, where there is one."""
        if not self._data.startswith(b"PACK ", self._at):
            return "", 0
        size, digest = self._words("PACK", 2)
        found = _DIGEST.match(digest)
        if found is None or not _SIZE.match(size) or int(size) > LARGEST_FILE:
            raise ValueError(Reason.of("files.index_line", line="PACK"))
        return found[1], int(size)

    def _files(self) -> dict[str, IndexedFile]:
        files: dict[str, IndexedFile] = {}
        while True:
            keyword, rest = self._line("CODE", "TEXT", "EOF")
            if keyword == "EOF":
                break
            file = self._file(keyword, rest.split())
            if file.path in files:
                raise ValueError(Reason.of("files.index_twice", path=file.path))
            files[file.path] = file
            if len(files) > MOST_FILES:
                raise ValueError(Reason.of("files.index_many", most=MOST_FILES))
        if self._at != len(self._data):
            raise ValueError(Reason.of("files.index_line", line="EOF"))
        reason = _clash(files)
        if reason:
            raise ValueError(reason)
        return files

    def _file(self, keyword: str, words: list[str]) -> IndexedFile:
        if len(words) != (3 if keyword == "CODE" else 2) or not _SIZE.match(words[1]):
            raise ValueError(Reason.of("files.index_line", line=keyword))
        path, size = words[0], int(words[1])
        if not is_path(path):
            raise ValueError(Reason.of("files.index_path", path=path))
        if size > LARGEST_FILE:
            raise ValueError(Reason.of("files.index_file_large", path=path, size=size, most=LARGEST_FILE))
        if keyword == "TEXT":
            return indexed_text(path, self._content(size))
        digest = _DIGEST.match(words[2])
        if digest is None:
            raise ValueError(Reason.of("files.index_line", line=keyword))
        return IndexedFile(path, size, digest[1])

    def _content(self, size: int) -> bytes:
        content = self._data[self._at : self._at + size]
        self._at += size
        if self._data[self._at : self._at + 1] != b"\n":
            raise ValueError(Reason.of("files.index_line", line="TEXT"))
        self._at += 1
        return content

    def _line(self, *keywords: str) -> tuple[str, str]:
        end = self._data.find(b"\n", self._at, self._at + _LONGEST_LINE)
        if end < 0:
            raise ValueError(Reason.of("files.index_line", line=keywords[0]))
        try:
            line = self._data[self._at : end].decode("utf-8")
        except UnicodeDecodeError:
            raise ValueError(Reason.of("files.index_line", line=keywords[0])) from None
        keyword, _, rest = line.partition(" ")
        if keyword not in keywords:
            raise ValueError(Reason.of("files.index_line", line=keywords[0]))
        self._at = end + 1
        return keyword, rest.strip()

    def _words(self, keyword: str, count: int) -> list[str]:
        words = self._line(keyword)[1].split()
        if len(words) != count:
            raise ValueError(Reason.of("files.index_line", line=keyword))
        return words

    def _matching(self, keyword: str, pattern: re.Pattern[str]) -> str:
        word = self._words(keyword, 1)[0]
        if not pattern.match(word):
            raise ValueError(Reason.of("files.index_line", line=keyword))
        return word

    def _day(self, keyword: str) -> date:
        try:
            return date.fromisoformat(self._words(keyword, 1)[0])
        except ValueError:
            raise ValueError(Reason.of("files.index_line", line=keyword)) from None


def _clash(files: Mapping[str, IndexedFile]) -> Reason:
    """Why the paths cannot all be files of one directory: a path that is a folder of another."""
    for path in files:
        parent = path.rpartition("/")[0]
        while parent:
            if parent in files:
                return Reason.of("files.index_twice", path=parent)
            parent = parent.rpartition("/")[0]
    return NOTHING
