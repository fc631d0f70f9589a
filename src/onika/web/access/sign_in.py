"""Signing in: a name and a password give a session, of which the browser keeps a cookie (requirement F10)."""

import asyncio
import ipaddress
import os
import threading
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from time import monotonic_ns

from onika.link.address import split_host
from onika.web.access.entrance import Visitor
from onika.web.access.page_sessions import PageSessions
from onika.web.access.page_trail import PageTrail
from onika.web.access.page_users import PageUserFile
from onika.web.access.password_hash import NOBODY, PasswordHash
from onika.web.access.wrong_tries import WrongTries
from onika.words.reason import Reason

_AT_A_TIME = 8
"""Passwords that wait to be looked at; each costs a quarter of a second of a processor."""
_NICE = 15
_SIGNED_IN = Reason.of("desk.signed_in")


class SignIn:
    """Lets in whom the file of users names.

    names   under which this machine is called; by its number it may always be
    clock   ns that never go back
    """

    closed = Reason.of("desk.page_without_key")

    def __init__(
        self,
        names: Iterable[str],
        port: int,
        users: PageUserFile,
        trail: PageTrail,
        clock: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._names = frozenset(name.lower() for name in names)
        self._users = users
        self._trail = trail
        self._clock = clock
        self._sessions = PageSessions()
        self._tries = WrongTries()
        self._judging = 0
        self._pool = ThreadPoolExecutor(1, "password", _step_back)
        self.cookie_name = f"__Host-onika-{port}"
        """Browsers take such a cookie over TLS only, from this host alone, and keep those of two ports apart."""

    def is_ours(self, headers: Mapping[str, str]) -> bool:
        """Whether a request names us as its host."""
        try:
            host, _ = split_host(headers.get("host", ""))
        except ValueError:
            return False
        return host.lower() in self._names or _is_number(host)

    def is_own_page(self, headers: Mapping[str, str]) -> bool:
        """Whether a page that came from here has sent it, over TLS."""
        return self.is_ours(headers) and headers.get("origin", "") == f"https://{headers.get('host', '')}"

    def visitor(self, cookies: Mapping[str, str]) -> Visitor | None:
        """Who that is, by his cookie."""
        token = cookies.get(self.cookie_name, "")
        return self._sessions.visitor(token, self._clock()) if token else None

    async def enter(self, name: str, password: str, address: str) -> tuple[str, Reason]:
        """A token for whoever has the right password; else none, and why.

        A try counts before it is judged, so that a thousand at a time are not more than ten.
        """
        self._users.look()
        user = self._users.users.get(name)
        shown = name if user is not None else ""  # somebody may have typed his password there
        wait_ns = self._tries.wait_ns(address, self._clock())
        if wait_ns:
            self._trail.turned_away(shown, address, "too-many-tries")
            return "", Reason.of("desk.sign_in_wait", minutes=-(-wait_ns // 60_000_000_000))
        if self._judging >= _AT_A_TIME:
            return "", Reason.of("desk.sign_in_busy")
        self._tries.note(address, self._clock())
        if not await self._is_right(NOBODY if user is None else user.password, password):
            self._trail.turned_away(shown, address, "wrong-password")
            return "", Reason.of("desk.sign_in_wrong")
        self._tries.take_back(address)
        if user is None or self._users.users.get(name) != user:
            return "", Reason.of("desk.sign_in_wrong")  # he was removed meanwhile
        token = self._sessions.open(user, address, self._clock())
        visitor = self._sessions.visitor(token, self._clock())
        if visitor is not None:
            self._trail.entered(visitor)
        return token, _SIGNED_IN

    def leave(self, visitor: Visitor) -> None:
        """End a session, as its user wishes."""
        self._sessions.close(visitor.session)
        self._trail.left(visitor, "signed-out")

    def sweep(self, in_use: Iterable[str]) -> tuple[str, ...]:
        """Look at the file of users, and end what is over; the sessions that have ended."""
        self._users.look()
        over = self._sessions.sweep(self._users.users, in_use, self._clock())
        for visitor in over:
            is_same = self._users.users.get(visitor.user) is not None
            self._trail.left(visitor, "over" if is_same else "no-user-any-more")
        return tuple(visitor.session for visitor in over)

    def close(self) -> None:
        """Judge nobody any more."""
        self._pool.shutdown(wait=False, cancel_futures=True)

    async def _is_right(self, kept: PasswordHash, password: str) -> bool:
        self._judging += 1
        try:
            return await asyncio.get_running_loop().run_in_executor(self._pool, kept.matches, password)
        finally:
            self._judging -= 1


def _step_back() -> None:
    """Whoever guesses passwords takes time of nobody who has other work."""
    os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _NICE)


def _is_number(host: str) -> bool:
    try:
        ipaddress.ip_address(host)
    except ValueError:
        return False
    return True
