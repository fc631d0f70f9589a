"""Admission: who may come in, who has tried too often, who waits too long in the door. No I/O, no clock."""

import ipaddress
from collections import OrderedDict
from collections.abc import Iterable
from dataclasses import dataclass

from onika.host.sessions.users import User, Users
from onika.link.address import is_near, split_host
from onika.link.channel import Channel
from onika.words.reason import NOTHING, Reason

IN_THE_DOOR = 256
"""Connections without a greeting at most; the oldest has to go."""
FROM_ONE_ADDRESS = 64
WRONG_TOKENS = 10
BACK_OFF_NS = 60 * 1_000_000_000

_PATHS = {f"/{channel.value}": channel for channel in Channel}


@dataclass(frozen=True, slots=True)
class TurnedAway:
    """Turned away: an HTTP status and why."""

    status: int
    reason: Reason


@dataclass(frozen=True, slots=True)
class LetIn:
    """Let in."""

    user: User
    channel: Channel


class Admission:
    """Judges requests by name, origin, path, token and address, the cheap questions first.

    Whoever has the right token is let in, whatever others from his address have tried: on one machine all users have
    one address, and tokens are too long to be guessed.
    """

    def __init__(self, users: Users, names: Iterable[str], is_private: bool) -> None:
        self._users = users
        self._names = {name.lower() for name in names}
        self._is_private = is_private
        self._waiting: OrderedDict[int, str] = OrderedDict()
        self._wrong: OrderedDict[str, tuple[int, int]] = OrderedDict()
        self._count = 0

    def enter(self, address: str) -> tuple[int, int | None]:
        """Somebody stands in the door: his number, and that of him who has to go for it (None: nobody).

        Who stands there longest goes, so that however many idle, an honest one is served.
        """
        same = [number for number, other in self._waiting.items() if other == address]
        evicted = None
        if len(same) >= FROM_ONE_ADDRESS:
            evicted = same[0]
        elif len(self._waiting) >= IN_THE_DOOR:
            evicted = next(iter(self._waiting))
        if evicted is not None:
            self.leave(evicted)
        self._count += 1
        self._waiting[self._count] = address
        return self._count, evicted

    def leave(self, number: int) -> None:
        """He is in, or gone."""
        self._waiting.pop(number, None)

    def judge(self, path: str, headers: Iterable[tuple[str, str]], address: str, now_ns: int) -> LetIn | TurnedAway:
        """Whether this request is let in, and as whom."""
        headers_by_name = _by_name(headers)
        turned_away = self._foreign(headers_by_name)
        if turned_away is not None:
            return turned_away
        if path not in _PATHS:
            return TurnedAway(404, Reason.of("host.no_such_path", paths=tuple(_PATHS)))
        user = self._caller(headers_by_name, address, now_ns)
        return user if isinstance(user, TurnedAway) else LetIn(user, _PATHS[path])

    def user(self, headers: Iterable[tuple[str, str]], address: str, now_ns: int) -> User | TurnedAway:
        """Who asks, whatever the path."""
        headers_by_name = _by_name(headers)
        return self._foreign(headers_by_name) or self._caller(headers_by_name, address, now_ns)

    def _foreign(self, headers_by_name: dict[str, list[str]]) -> TurnedAway | None:
        wrong = self._wrong_name(headers_by_name) or self._wrong_origin(headers_by_name)
        return TurnedAway(403, wrong) if wrong else None

    def _caller(self, headers_by_name: dict[str, list[str]], address: str, now_ns: int) -> User | TurnedAway:
        user = self._user(headers_by_name.get("authorization", []))
        if user is None and self._is_barred(address, now_ns):
            return TurnedAway(429, Reason.of("host.too_many_tokens"))
        if user is None:
            self._note_wrong(address, now_ns)
            return TurnedAway(401, Reason.of("host.wrong_token"))
        self._wrong.pop(address, None)
        return user

    def _wrong_name(self, message: dict[str, list[str]]) -> Reason:
        """Against pages that have their own name resolved to this machine: a number cannot be resolved anew."""
        hosts = message.get("host", [])
        try:
            (host,) = [split_host(value)[0] for value in hosts]
        except ValueError:
            return Reason.of("host.one_host")
        if host in self._names or _is_number(host):
            return NOTHING
        return Reason.of("host.other_name")

    def _wrong_origin(self, message: dict[str, list[str]]) -> Reason:
        """Against foreign pages in somebody's browser: only programs, which have none, or a page from here."""
        own = f"{'https' if self._is_private else 'http'}://{message['host'][0]}"
        fine = all(origin == own for origin in message.get("origin", []))
        if fine:
            return NOTHING
        return Reason.of("host.other_origin")

    def _user(self, values: list[str]) -> User | None:
        if len(values) != 1:
            return None
        scheme, _, token = values[0].partition(" ")
        if scheme.lower() == "bearer" and token:
            return self._users.find(token.strip())
        return None

    def _is_barred(self, address: str, now_ns: int) -> bool:
        count, last_ns = self._wrong.get(address, (0, 0))
        return count >= WRONG_TOKENS and now_ns < last_ns + BACK_OFF_NS

    def _note_wrong(self, address: str, now_ns: int) -> None:
        count, last_ns = self._wrong.pop(address, (0, now_ns))
        count = 0 if now_ns >= last_ns + BACK_OFF_NS else count
        self._wrong[address] = (count + 1, now_ns)
        while len(self._wrong) > 1024:
            self._wrong.popitem(last=False)


def _by_name(headers: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    headers_by_name: dict[str, list[str]] = {}
    for name, value in headers:
        headers_by_name.setdefault(name.lower(), []).append(value)
    return headers_by_name


def _is_number(host: str) -> bool:
    try:
        ipaddress.ip_address(host)
    except ValueError:
        return False
    return True


def from_near(address: str) -> bool:
    """Whether a connection comes from this machine."""
    return is_near(address)
