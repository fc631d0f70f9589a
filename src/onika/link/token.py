"""The token of this machine: 256 random bits in a file that only its user can read, made once."""

import contextlib
import hashlib
import os
import secrets
from collections.abc import Mapping
from pathlib import Path

from onika.files.state.state_directory import make_own, state_directory
from onika.words.reason import Reason
from onika.words.system_error import system_reason_with_place


def new_token() -> str:
    """A new one, as 43 letters."""
    return secrets.token_urlsafe(32)


def digest(token: str) -> str:
    """What is kept of a token instead of it: its SHA-256 in hexadecimal."""
    return hashlib.sha256(token.encode()).hexdigest()


def token_path(environment: Mapping[str, str] = os.environ) -> Path:
    """Where it lies: in the state directory."""
    return state_directory(environment) / "token"


def read_token(path: Path) -> str:
    """The token in a file; raises ValueError where none can be read there."""
    try:
        text = path.read_text(encoding="ascii", errors="replace").strip()
    except OSError as error:
        raise ValueError(system_reason_with_place(error)) from None
    if not text or not text.isprintable() or " " in text:
        raise ValueError(Reason.of("link.token_none", path=str(path)))
    return text


def own_token(path: Path) -> str:
    """The token in that file, made there if there is none; raises OSError, or ValueError for a file others can read."""
    make_own(path.parent)
    if not path.exists():
        _make(path)
    if path.stat().st_mode & 0o077:
        raise ValueError(Reason.of("link.token_open", path=str(path)))
    return read_token(path)


def _make(path: Path) -> None:
    """Whole or not at all: of two programs that start at once, the first one's token stands."""
    draft = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
    descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        with os.fdopen(descriptor, "w", encoding="ascii") as file:
            file.write(new_token() + "\n")
        with contextlib.suppress(FileExistsError):
            os.link(draft, path)
    finally:
        draft.unlink()
