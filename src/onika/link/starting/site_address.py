"""The address of a runtime that a site launches: `site://HOST[:PORT]/NAME[?stay&tls]` (requirement A15).

NAME is what the owner of the site has listed; nothing else can be launched. A site is spoken to over TLS, on this
machine as it is. What stands after the question mark:

    stay        it stays when nobody is connected any more
    tls         over TLS on this machine too, as where a tunnel leads to another one
"""

import re
from dataclasses import dataclass
from urllib.parse import SplitResult, parse_qsl, urlsplit

from onika.link.address import Address, bracketed, is_near
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

SCHEME = "site"
PORT = 7995
"""Where a site listens unless told otherwise."""
_HOST = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*|[0-9A-Fa-f:.]+(%[A-Za-z0-9]+)?")
_WORDS = ("stay", "tls")


@dataclass(frozen=True, slots=True)
class SiteAddress:
    """Where a site is, and what is to be launched there; without a name the site itself."""

    host: str
    port: int = PORT
    name: str = ""
    stays: bool = False
    is_private: bool = True

    def __str__(self) -> str:
        words = ["stay"] * self.stays + ["tls"] * (self.is_private and is_near(self.host))
        return f"{SCHEME}://{self.place}{'/' if self.name else ''}{self.name}{'?' if words else ''}{'&'.join(words)}"

    @property
    def place(self) -> str:
        """Host and port."""
        return f"{bracketed(self.host)}:{self.port}"

    @classmethod
    def parse(cls, text: str) -> "SiteAddress":
        """Read an address; raises ValueError that says what was expected and found."""
        try:
            parts = urlsplit(text)
            port = parts.port
        except ValueError:
            raise ValueError(Reason.of("link.site_address_form", text=text)) from None
        host, name = parts.hostname or "", parts.path.removeprefix("/")
        if port == 0 or not _fits(parts, host, name):
            raise ValueError(Reason.of("link.site_address_form", text=text))
        words = parse_qsl(parts.query, keep_blank_values=True)
        unknown = [word for word, value in words if word not in _WORDS or value]
        if unknown:
            raise ValueError(Reason.of("link.site_address_words", word=unknown[0], text=text))
        given = {word for word, _ in words}
        is_private = "tls" in given or not is_near(host)
        return cls(host, PORT if port is None else port, name, "stay" in given, is_private)

    def runtime(self, port: int) -> Address:
        """Where a runtime of the site listens: over TLS where the site is."""
        return Address(self.host, port, self.is_private)


def _fits(parts: SplitResult, host: str, name: str) -> bool:
    """Whether each part is what it may be."""
    is_bare = not parts.fragment and parts.username is None
    has_name = not name or TASK_NAME.match(name) is not None
    return parts.scheme == SCHEME and is_bare and has_name and _HOST.fullmatch(host) is not None
