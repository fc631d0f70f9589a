"""The address of a runtime: `ws://HOST:PORT` on this machine, `wss://HOST:PORT` anywhere."""

import ipaddress
from dataclasses import dataclass
from urllib.parse import urlsplit

from onika.words.reason import Reason

PORT = 7994
"""Where a runtime listens unless told otherwise."""


@dataclass(frozen=True, slots=True)
class Address:
    """Where a runtime is, and whether the way there is private."""

    host: str
    port: int
    is_private: bool

    def __str__(self) -> str:
        return f"{'wss' if self.is_private else 'ws'}://{bracketed(self.host)}:{self.port}"

    @property
    def is_near(self) -> bool:
        """Whether it is this machine."""
        return is_near(self.host)

    @classmethod
    def parse(cls, text: str) -> "Address":
        """Read an address; raises ValueError that says what was expected and found."""
        parts = urlsplit(text)
        try:
            port = parts.port
        except ValueError:
            port = -1
        if parts.scheme not in ("ws", "wss") or not parts.hostname or port == -1:
            raise ValueError(Reason.of("link.address_form", text=text))
        if parts.path not in ("", "/") or parts.query or parts.fragment or parts.username is not None:
            raise ValueError(Reason.of("link.address_bare", text=text))
        if parts.scheme == "ws" and not is_near(parts.hostname):
            raise ValueError(Reason.of("link.address_readable", text=text))
        return cls(parts.hostname, PORT if port is None else port, parts.scheme == "wss")


def is_near(host: str) -> bool:
    """Whether the host is this machine, by its name or number."""
    if host == "localhost":
        return True
    try:
        number = ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return False
    mapped = getattr(number, "ipv4_mapped", None)
    return (mapped or number).is_loopback


def bracketed(host: str) -> str:
    """The host as it stands before a port: an IPv6 number in brackets."""
    return f"[{host}]" if ":" in host else host


def split_host(text: str) -> tuple[str, int | None]:
    """Host and port of `HOST`, `HOST:PORT` or `[HOST]:PORT`; raises ValueError."""
    parts = urlsplit(f"//{text}")
    if not parts.hostname or parts.path or parts.username is not None:
        raise ValueError(Reason.of("link.host_port", text=text))
    return parts.hostname, parts.port
