"""The sessions of those who have signed in: a random token in a cookie, of which only the SHA-256 is kept here.

Each sign-in makes a new token, and a token that somebody brings along is never taken over. No I/O, no clock.
"""

import secrets
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from onika.link.token import digest
from onika.web.access.entrance import Visitor
from onika.web.access.page_users import PageUser

IDLE_NS = 12 * 3600 * 1_000_000_000
"""Without an open page for so long it ends."""
LONGEST_NS = 7 * 24 * 3600 * 1_000_000_000
"""And in any case after so long."""
OF_ONE = 16
"""Sessions of one user; of more the one that has been idle for longest ends."""


@dataclass(slots=True)
class _Session:
    """One of them: `user` as he was when he came in."""

    user: PageUser
    visitor: Visitor
    began_ns: int
    used_ns: int


class PageSessions:
    """All of them, by what is kept of their tokens."""

    def __init__(self) -> None:
        self._sessions: dict[str, _Session] = {}

    def __len__(self) -> int:
        return len(self._sessions)

    def open(self, user: PageUser, address: str, now_ns: int) -> str:
        """Begin one; the token, which is known to nobody before."""
        own = [name for name, session in self._sessions.items() if session.user.name == user.name]
        for name in sorted(own, key=lambda name: self._sessions[name].used_ns)[: max(0, len(own) - OF_ONE + 1)]:
            del self._sessions[name]
        token = secrets.token_urlsafe(32)
        name = digest(token)
        visitor = Visitor(user.name, user.role, name, address)
        self._sessions[name] = _Session(user, visitor, now_ns, now_ns)
        return token

    def visitor(self, token: str, now_ns: int) -> Visitor | None:
        """Whose token that is, who is in use with it."""
        session = self._sessions.get(digest(token))
        if session is None or _is_over(session, now_ns):
            return None
        session.used_ns = now_ns
        return session.visitor

    def close(self, name: str) -> None:
        """End one."""
        self._sessions.pop(name, None)

    def sweep(self, users: Mapping[str, PageUser], in_use: Iterable[str], now_ns: int) -> tuple[Visitor, ...]:
        """End those that are over, and those of users that are gone or are no more what they were; whose they were.

        in_use  sessions with a page that is open
        """
        for name in in_use:
            if name in self._sessions:
                self._sessions[name].used_ns = now_ns
        over = [
            name
            for name, session in self._sessions.items()
            if _is_over(session, now_ns) or users.get(session.user.name) != session.user
        ]
        return tuple(self._sessions.pop(name).visitor for name in over)


def _is_over(session: _Session, now_ns: int) -> bool:
    return now_ns >= min(session.used_ns + IDLE_NS, session.began_ns + LONGEST_NS)
