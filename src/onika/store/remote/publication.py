"""A base directory as a library for others: a folder that any server of files, or a stick, can give away (F03)."""

import base64
import binascii
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, timedelta
from hashlib import sha256
from pathlib import Path

import zstandard

from onika.files import library_index
from onika.files.library_index import IndexedFile, LibraryIndex, indexed_text
from onika.store.remote.code_pack import packed
from onika.store.remote.index_check import SignedIndex, opened
from onika.store.remote.object_cache import write_whole
from onika.store.remote.signature import sign
from onika.store.remote.source import INDEX, object_path
from onika.words.name import TASK_NAME
from onika.words.reason import Reason
from onika.words.system_error import system_reason_with_place

SMALL = 256_000
"""Bytes of a text that stands in the index, so that browsing needs nothing more."""

_LISTED = (".rmod", ".conf", ".sets", ".onk", ".appl", ".test", ".toml", ".dta", ".world", ".robot")
"""How texts are called that stand there; code, models and nets never do, as they are fetched by need."""

DAYS = 92
"""How long an index may be taken for the newest, unless it is said otherwise."""

_LEVEL = 19
_KEY_BYTES = 20_000
_OPENSSH = b"openssh-key-v1\0"
_MODE = 0o644


@dataclass(frozen=True, slots=True)
class Publication:
    """What was published."""

    index: LibraryIndex
    signer: str
    packed: int
    """Bytes of the signed index."""
    left_out: tuple[str, ...]
    """Files of its folders that are none of a library's, by their paths."""


@dataclass(frozen=True, slots=True)
class Publisher:
    """Publishes a base directory into a folder; who looks there meanwhile sees the former version or the new one.

    key     the file of the private key, or of a public one whose private key an agent has
    """

    base: Path
    folder: Path
    key: Path
    name: str

    def publish(
        self, today: date, *, days: int = DAYS, description: str = "", next_key: str = ""
    ) -> Publication | Reason:
        """Sign and write; the number of the version is one above the former one."""
        if not TASK_NAME.match(self.name):
            return Reason.of("store.library_name", name=repr(self.name[:80]))
        try:
            return self._publish(today, days, description, next_key)
        except OSError as error:
            return system_reason_with_place(error)

    @property
    def signer(self) -> str | None:
        """The fingerprint of the key; None where it stands nowhere in the clear. Raises OSError."""
        return fingerprint_of(self.key) or _fingerprint_within(self.key.read_bytes()[:_KEY_BYTES])

    def former(self) -> LibraryIndex | Reason | None:
        """What lies in the folder; None: nothing. It must be this library. Raises OSError."""
        signed = self._former()
        return signed.index if isinstance(signed, SignedIndex) else signed

    def _former(self) -> SignedIndex | Reason | None:
        path = self.folder / INDEX
        if not path.exists():
            return None
        found = opened(path.read_bytes())
        if isinstance(found, Reason):
            return Reason.of("store.former_unread", path=str(path), why=found)
        if found.index.name != self.name:
            return Reason.of("store.former_other", path=str(path), library=found.index.name)
        return found

    def is_published(self, today: date) -> bool:
        """Whether what lies in the folder is just what the base directory has now, signed by its key, not overdue."""
        try:
            former = self._former()
            if not isinstance(former, SignedIndex) or self.signer not in (former.signer, None):
                return False
            return former.index.until >= today and former.index.files == self._gathered()[0]
        except OSError:
            return False

    def _publish(self, today: date, days: int, description: str, next_key: str) -> Publication | Reason:
        former = self.former()
        if isinstance(former, Reason):
            return former
        files, objects, left_out = self._gathered()
        if not files:
            return Reason.of("store.nothing_to_publish", path=str(self.base))
        too_many = len(files) > library_index.MOST_FILES
        if too_many:
            return Reason.of("files.index_many", most=library_index.MOST_FILES)
        until, version = today + timedelta(days=days), former.version + 1 if former else 1
        pack = packed(objects)
        if len(pack) > library_index.LARGEST_FILE:
            pack = b""
        named = sha256(pack).hexdigest() if pack else ""
        index = LibraryIndex(self.name, version, today, until, next_key, description, named, len(pack), files)
        body = zstandard.ZstdCompressor(level=_LEVEL).compress(library_index.write(index))
        signed = sign(body, self.key)
        if isinstance(signed, Reason):
            return signed
        found = opened(signed)
        if isinstance(found, Reason):
            return found
        for content in (*objects.values(), *([pack] if pack else []), signed):
            target = self.folder / object_path(sha256(content).hexdigest())
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists():
                write_whole(target, content, mode=_MODE)
        write_whole(self.folder / INDEX, signed, mode=_MODE)
        return Publication(index, found.signer, len(signed), left_out)

    def _gathered(self) -> tuple[dict[str, IndexedFile], dict[str, bytes], tuple[str, ...]]:
        """The files, what of them does not stand in the index, and the paths of those that are left out."""
        files: dict[str, IndexedFile] = {}
        objects: dict[str, bytes] = {}
        left_out = []
        for path in _paths(self.base):
            name = path.relative_to(self.base).as_posix()
            if not library_index.is_path(name) or path.stat().st_size > library_index.LARGEST_FILE:
                left_out.append(name)
                continue
            content = path.read_bytes()
            if len(content) <= SMALL and name.endswith(_LISTED):
                files[name] = indexed_text(name, content)
            else:
                files[name] = IndexedFile(name, len(content), sha256(content).hexdigest())
                objects[name] = content
        return files, objects, tuple(left_out)


def fingerprint_of(public_key: Path) -> str | None:
    """The fingerprint of the key in a `.pub` file; None where there is none. Raises OSError."""
    words = public_key.read_bytes()[:_KEY_BYTES].split()
    try:
        return _fingerprint(base64.b64decode(words[1], validate=True))
    except (IndexError, binascii.Error):
        return None


def _fingerprint_within(private_key: bytes) -> str | None:
    """That of the public key which an OpenSSH private key has in the clear, also where a pass phrase locks it."""
    lines = private_key.split(b"-----")
    try:
        opened_key = base64.b64decode(b"".join(lines[2].split()), validate=True)
        place = opened_key.index(_OPENSSH) + len(_OPENSSH)
        for _ in range(3):  # how the rest is locked
            place += 4 + int.from_bytes(opened_key[place : place + 4])
        place += 4  # how many keys there are
        size = int.from_bytes(opened_key[place : place + 4])
        return _fingerprint(opened_key[place + 4 : place + 4 + size])
    except (IndexError, ValueError):
        return None


def _fingerprint(public_key: bytes) -> str:
    return "SHA256:" + base64.b64encode(sha256(public_key).digest()).decode().rstrip("=")


def _paths(base: Path) -> Iterator[Path]:
    """The plain files in the folders of a library, in order; hidden ones and compiled code are nobody's."""
    for folder in library_index.ENDINGS:
        for path in sorted((base / folder).rglob("*")):
            parts = path.relative_to(base).parts
            if path.is_file() and not any(part.startswith((".", "__")) for part in parts):
                yield path
