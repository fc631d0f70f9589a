"""Where a library of others is: an `https` or `http` address, or a folder, which may be a stick."""

from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urljoin, urlsplit

from onika.words.reason import Reason

_LONGEST = 1000
_LOCAL = ("localhost", "127.0.0.1", "::1")


@dataclass(frozen=True, slots=True)
class WebAddress:
    """An address taken apart; `path` ends with a slash, and everything of the library lies below it."""

    is_tls: bool
    host: str
    port: int
    path: str

    @property
    def authority(self) -> str:
        """The host as a request names it, with its port where that is not the usual one."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return host if self.port == _usual_port(self.is_tls) else f"{host}:{self.port}"

    @property
    def keeps_secrets(self) -> bool:
        """Whether nobody on the way can read what is sent there."""
        return self.is_tls or self.host in _LOCAL

    def below(self, path: str) -> str:
        """What a request for a file of the library asks for."""
        return self.path + path

    def redirected(self, target: str, location: str) -> str | Reason:
        """What is asked for instead of `target` where the server says so: the same server, or nothing."""
        scheme = "https" if self.is_tls else "http"
        whole = urljoin(f"{scheme}://{self.authority}{target}", location)
        there = web_address(whole)
        if isinstance(there, Reason) or (there.is_tls, there.host, there.port) != (self.is_tls, self.host, self.port):
            return Reason.of("store.sent_elsewhere", host=self.host, location=location[:200])
        parts = urlsplit(whole)
        return parts.path + (f"?{parts.query}" if parts.query else "")


def library_address(text: str) -> "WebAddress | Path | Reason":
    """What a user gives as the place of a library."""
    if text.startswith(("https://", "http://")):
        return web_address(text)
    if "://" in text or not text or len(text) > _LONGEST or "\0" in text:
        return Reason.of("store.address_form", address=text[:200])
    try:
        return Path(text).expanduser().absolute()
    except RuntimeError:
        return Reason.of("store.path_home", path=text)


def web_address(text: str) -> WebAddress | Reason:
    """An address of the web; a name or password has no place in it."""
    wrong = Reason.of("store.address_form", address=text[:200])
    if len(text) > _LONGEST or not text.isascii() or not text.isprintable() or " " in text:
        return wrong
    try:
        parts = urlsplit(text)
        port = parts.port
    except ValueError:
        return wrong
    if parts.scheme not in ("https", "http") or not parts.hostname or "\\" in text:
        return wrong
    if parts.username is not None or parts.password is not None:
        return Reason.of("store.address_password")
    is_tls = parts.scheme == "https"
    path = parts.path.rstrip("/") + "/"
    return WebAddress(is_tls, parts.hostname, port or _usual_port(is_tls), path)


def _usual_port(is_tls: bool) -> int:
    return 443 if is_tls else 80
