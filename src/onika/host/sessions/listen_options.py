"""Where a runtime listens and whom it lets in; what is missing for that is said, and nothing is open by default."""

import os
import socket
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from onika.host.sessions.users import User, read
from onika.link.address import PORT, Address, bracketed, is_near, split_host
from onika.link.caller import Role
from onika.link.token import digest, own_token, token_path
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

if TYPE_CHECKING:
    import ssl

_CLOSED = Reason.of("host.not_started")


class ListenOptions(Struct, frozen=True):
    """What the command line asks for; names: other names under which this machine is called."""

    listen: str
    certificate: str = ""
    key: str = ""
    users: str = ""
    names: tuple[str, ...] = ()


class ListenerSettings(Struct, frozen=True):
    """What the listener needs: no token, only what is kept of tokens."""

    host: str
    port: int
    certificate: str
    key: str
    users: tuple[User, ...]
    names: tuple[str, ...]

    def address(self, port: int) -> str:
        """As an environment names it, with the port that was really taken."""
        return str(Address(self.host, port, bool(self.certificate)))


def judge(
    wanted: ListenOptions, environment: Mapping[str, str] = os.environ
) -> tuple[ListenerSettings | None, list[Fault], str]:
    """The place to listen, or all that is missing for it; and where the token of this machine lies, if one is used."""
    try:
        host, port = split_host(wanted.listen)
    except ValueError:
        return None, [Fault(Place("--listen"), Reason.of("host.listen_form", listen=wanted.listen), _CLOSED)], ""
    near = is_near(host)
    users, faults = _users(wanted, near)
    faults += _secrets(wanted, near)
    token_at = ""
    if near and not faults:
        path = token_path(environment)
        try:
            users = (*users, User("owner", Role.OWNER, digest(own_token(path))))
            token_at = str(path)
        except (OSError, ValueError) as wrong:
            faults.append(Fault(Place(str(path)), Reason.of("host.token_unreadable", why=reason_of(wrong)), _CLOSED))
    if faults:
        return None, faults, ""
    names = ("localhost",) if near else (host, socket.gethostname(), *wanted.names)
    place = ListenerSettings(
        host, PORT if port is None else port, wanted.certificate, wanted.key, users, names + wanted.names
    )
    return place, [], token_at


def context(certificate: str, key: str) -> "ssl.SSLContext":
    """The server's side of TLS 1.2 or newer; raises OSError or ssl.SSLError for files that are none."""
    import ssl  # within: only who is called from afar needs it

    made = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    made.minimum_version = ssl.TLSVersion.TLSv1_2
    made.load_cert_chain(certificate, key)
    return made


def _users(wanted: ListenOptions, near: bool) -> tuple[tuple[User, ...], list[Fault]]:
    if not wanted.users:
        missing = Fault(Place("--users"), Reason.of("host.users_missing", listen=_shown(wanted.listen)), _CLOSED)
        return (), [] if near else [missing]
    try:
        text = Path(wanted.users).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as wrong:
        return (), [Fault(Place(wanted.users), Reason.of("host.users_unreadable", why=reason_of(wrong)), _CLOSED)]
    users, faults = read(text, wanted.users)
    if not users and not faults and not near:
        faults = [Fault(Place(wanted.users), Reason.of("host.no_user"), _CLOSED)]
    return users, faults


def _secrets(wanted: ListenOptions, near: bool) -> list[Fault]:
    given = {"--cert": wanted.certificate, "--key": wanted.key}
    if near and not any(given.values()):
        return []
    faults = [
        Fault(Place(option), Reason.of("host.certificate_missing", listen=_shown(wanted.listen)), _CLOSED)
        for option, value in given.items()
        if not value
    ]
    if faults:
        return faults
    try:
        context(wanted.certificate, wanted.key)
    except OSError as wrong:
        return [Fault(Place(wanted.certificate), Reason.of("host.certificate_unfit", why=reason_of(wrong)), _CLOSED)]
    return []


def _shown(listen: str) -> str:
    if listen.count(":") > 1:
        return bracketed(listen)
    return listen
