"""The entrance of a seat: keys that its class gives out let one browser in each, as its learner or as the teacher."""

import hmac
import secrets
from collections.abc import Callable, Iterable, Mapping
from time import monotonic_ns
from typing import Any

from onika.link.address import split_host
from onika.link.caller import Role
from onika.link.token import digest
from onika.web.access.entrance import Visitor
from onika.words.reason import Reason

KEY_NS = 60 * 1_000_000_000
"""So long a key waits for its browser."""
_MOST = 16
"""Keys that wait, and cookies of one person; of more the oldest is void."""
TEACHER = "teacher"
"""The session of whoever came in from the board; what he is called, too."""


class SeatEntrance:
    """Lets in whoever has a key of the class, and afterwards a cookie of this seat; a cookie of another is none.

    names   under which this machine is called
    clock   ns that never go back
    """

    closed = Reason.of("class.seat_without_key")

    def __init__(
        self,
        names: Iterable[str],
        port: int,
        learner: str,
        *,
        is_secure: bool,
        clock: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._names = frozenset(name.lower() for name in names)
        self._port = port
        self._scheme = "https" if is_secure else "http"
        self._learner = Visitor(learner, Role.OWNER, "learner")
        self._teacher = Visitor(TEACHER, Role.OWNER, TEACHER)
        self._clock = clock
        self._keys: dict[str, tuple[bool, int]] = {}
        self._cookies: dict[str, bool] = {}
        self.is_secure = is_secure
        self.cookie_name = f"__Host-onika-{port}" if is_secure else f"onika-{port}"

    def admit(self, key: str, *, is_teacher: bool) -> None:
        """Whoever comes with this key is let in, once, soon."""
        self._keys[digest(key)] = (is_teacher, self._clock() + KEY_NS)
        _shorten(self._keys)

    def enter(self, key: str) -> str | None:
        """A cookie for whoever has a key, which is void from then on; None for any other."""
        is_teacher, until_ns = self._keys.pop(digest(key), (False, 0))
        if self._clock() >= until_ns:
            return None
        cookie = secrets.token_urlsafe(32)
        self._cookies[digest(cookie)] = is_teacher
        _shorten(self._cookies)
        return cookie

    def shut_out_learner(self) -> None:
        """The learner's keys and cookies are void."""
        self._keys = {key: kept for key, kept in self._keys.items() if kept[0]}
        self._cookies = {cookie: is_teacher for cookie, is_teacher in self._cookies.items() if is_teacher}

    def is_ours(self, headers: Mapping[str, str]) -> bool:
        """Whether a request names us as its host."""
        try:
            host, port = split_host(headers.get("host", ""))
        except ValueError:
            return False
        return host.lower() in self._names and port == self._port

    def is_own_page(self, headers: Mapping[str, str]) -> bool:
        """Whether a page of this very seat has sent it."""
        wanted = f"{self._scheme}://{headers.get('host', '')}"
        return self.is_ours(headers) and hmac.compare_digest(headers.get("origin", "").encode(), wanted.encode())

    def visitor(self, cookies: Mapping[str, str]) -> Visitor | None:
        """Who that is, by his cookie."""
        is_teacher = self._cookies.get(digest(cookies.get(self.cookie_name, "")))
        if is_teacher is None:
            return None
        return self._teacher if is_teacher else self._learner


def _shorten(kept: dict[str, Any]) -> None:
    while len(kept) > _MOST:
        del kept[next(iter(kept))]
