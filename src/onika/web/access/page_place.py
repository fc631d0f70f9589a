"""Where the page is served to others, and what that needs: a certificate, its key and at least one user (F10).

Nothing of it is open by default: without `--listen` the page is for this machine alone.
"""

import os
import socket
import ssl
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from onika.files.state.access import ANYTHING, STRANGERS, Access, guard
from onika.link.address import bracketed, split_host
from onika.web.access.certificate import is_for, server_context
from onika.web.access.page_users import PageUserFile, users_path
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

_CLOSED = Reason.of("desk.page_not_begun")
_ANY = ("0.0.0.0", "::")  # noqa: S104 - these are what somebody asks for, compared only


@dataclass(frozen=True, slots=True)
class PageOptions:
    """What the command line asks for; names: other names under which this machine is called."""

    listen: str
    certificate: str = ""
    key: str = ""
    users: str = ""
    names: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PagePlace:
    """Where the page is served, by what, and to whom; `names`: first the one for which its certificate is."""

    host: str
    port: int
    context: ssl.SSLContext
    certificate: str
    users: Path
    names: tuple[str, ...]

    def address(self, port: int) -> str:
        """As a browser names it, with the port that was really taken."""
        return f"https://{bracketed(self.names[0])}:{port}/"


def judged(
    wanted: PageOptions, port: int, environment: Mapping[str, str] = os.environ, *, needs_users: bool = True
) -> tuple[PagePlace | None, list[Fault]]:
    """The place to listen, or all that is missing for it; `port` where none is named."""
    try:
        host, named = split_host(wanted.listen)
    except ValueError:
        return None, [Fault(Place("--listen"), Reason.of("desk.listen_form", listen=wanted.listen), _CLOSED)]
    users = Path(wanted.users) if wanted.users else users_path(environment)
    context, faults = _context(wanted)
    faults += (_users(users) if needs_users else []) + _rights(users, wanted.key)
    if faults or context is None:
        return None, faults
    own = () if host in _ANY else (host,)
    chosen = sorted((*wanted.names, *own), key=lambda name: not is_for(context, wanted.certificate, name))
    names = tuple(dict.fromkeys((*chosen, socket.gethostname(), "localhost")))
    return PagePlace(host, port if named is None else named, context, wanted.certificate, users, names), []


def _context(wanted: PageOptions) -> tuple[ssl.SSLContext | None, list[Fault]]:
    given = {"--cert": wanted.certificate, "--key": wanted.key}
    missing = Reason.of("desk.page_certificate_missing")
    faults = [Fault(Place(option), missing, _CLOSED) for option, value in given.items() if not value]
    if faults:
        return None, faults
    try:
        return server_context(wanted.certificate, wanted.key), []
    except (OSError, ssl.SSLError) as wrong:
        reason = Reason.of("desk.page_certificate_unfit", why=reason_of(wrong))
        return None, [Fault(Place(wanted.certificate), reason, _CLOSED)]


def _users(path: Path) -> list[Fault]:
    file = PageUserFile(path)
    file.look()
    if file.users:
        return []
    return [*file.faults, Fault(Place(str(path)), Reason.of("desk.page_without_users"), _CLOSED)]


def _rights(users: Path, key: str) -> list[Fault]:
    """What others may read or write that they should not, and that cannot be mended."""
    report = guard((Access(users, ANYTHING), Access(Path(key), STRANGERS)) if key else (Access(users, ANYTHING),))
    return [Fault(Place(str(users)), reason, _CLOSED) for reason in report.refused]
