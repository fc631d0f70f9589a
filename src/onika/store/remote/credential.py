"""What lets somebody in at a server: a name with its password, or a token. It is never part of an address or a file
of the base directory."""

import base64
import re
from dataclasses import dataclass
from pathlib import Path

_FOLDER = "library-tokens"
_HOST = re.compile(r"[A-Za-z0-9.:_-]{1,253}\Z")
_LONGEST = 4000


@dataclass(frozen=True, slots=True)
class Credential:
    """With a name `secret` is the password, without one a token."""

    secret: str
    user: str = ""

    @property
    def header(self) -> str:
        """What a request says of it."""
        if not self.user:
            return f"Bearer {self.secret}"
        return "Basic " + base64.b64encode(f"{self.user}:{self.secret}".encode()).decode()

    def __repr__(self) -> str:
        return f"Credential(user={self.user!r})"


def kept_credential(state: Path, host: str, port: int) -> Credential | None:
    """What a user keeps for a server, in `library-tokens/HOST:PORT` or `HOST` of the state directory; None: nothing.

    One line: a token, or `NAME:PASSWORD`.
    """
    if not _HOST.match(host) or host.startswith("."):
        return None
    for name in (f"{host}:{port}", host):
        try:
            line = (state / _FOLDER / name).read_text(encoding="utf-8")[:_LONGEST].strip()
        except (OSError, UnicodeDecodeError):
            continue
        if line and line.isprintable():
            user, colon, secret = line.partition(":")
            return Credential(secret, user) if colon else Credential(line)
    return None
