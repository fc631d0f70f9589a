"""Files of others kept by what they hold: each under its SHA-256, which is looked at whenever it is opened (F03)."""

import os
import re
import secrets
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from onika.files.state.state_directory import make_own

_OBJECTS = "objects"
_DIGEST = re.compile(r"[0-9a-f]{64}\Z")


def is_digest(text: str) -> bool:
    """Whether a text is a SHA-256 in hexadecimal."""
    return _DIGEST.match(text) is not None


def cache_directory(environment: Mapping[str, str]) -> Path:
    """Where they are kept, as the XDG says it; it need not be there yet."""
    cache = environment.get("XDG_CACHE_HOME", "")
    home = Path(cache) if cache.startswith("/") else Path(environment.get("HOME") or Path.home()) / ".cache"
    return home / "onika"


@dataclass(frozen=True, slots=True)
class ObjectCache:
    """The objects below a folder. Several programs may use it at a time: what is there is whole, or it is not there."""

    folder: Path

    def get(self, digest: str) -> bytes | None:
        """What has this SHA-256 in hexadecimal; None where it is not there, or no longer what it was."""
        try:
            content = self._file(digest).read_bytes()
        except OSError:
            return None
        return content if sha256(content).hexdigest() == digest else None

    def put(self, content: bytes) -> str:
        """Keep something; its SHA-256. Raises OSError."""
        digest = sha256(content).hexdigest()
        if self.get(digest) is None:
            write_whole(self._file(digest), content)
        return digest

    def put_all(self, contents: Iterable[bytes]) -> None:
        """Keep many things: they are written first, and only then waited for. Raises OSError."""
        new = {sha256(content).hexdigest(): content for content in contents}
        written = [digest for digest in new if self.get(digest) is None]
        for digest in written:
            write_whole(self._file(digest), new[digest], is_lasting=False)
        for digest in written:
            with self._file(digest).open("rb") as file:
                os.fsync(file.fileno())

    def is_altered(self, digest: str) -> bool:
        """Whether something is there under this SHA-256 that is no longer what was kept."""
        return self._file(digest).is_file() and self.get(digest) is None

    def _file(self, digest: str) -> Path:
        return self.folder / _OBJECTS / digest[:2] / digest


def write_whole(path: Path, content: bytes, mode: int = 0o600, *, is_lasting: bool = True) -> None:
    """Put a file in place whole or not at all; raises OSError.

    `is_lasting`: once it returns, the file outlasts a loss of power.
    """
    make_own(path.parent)
    fresh = path.parent / f".{secrets.token_hex(8)}.new"
    try:
        with fresh.open("xb") as file:
            os.fchmod(file.fileno(), mode)
            file.write(content)
            if is_lasting:
                file.flush()
                os.fsync(file.fileno())
        fresh.rename(path)
    except BaseException:
        with suppress(OSError):
            fresh.unlink()
        raise
