"""The login: a key in the address works once, then a cookie; only pages of our own may connect."""

import hmac
import secrets
from collections.abc import Callable, Mapping

from onika.web.access.entrance import OWNER, Visitor
from onika.words.reason import Reason


class Login:
    """Keeps the key and the cookies of one environment, and knows the addresses at which it is reached.

    addresses   as in `127.0.0.1:8420`: what a browser must have in its `Host`
    on_key      told of each new key
    """

    closed = Reason.of("desk.page_without_key")

    def __init__(self, addresses: tuple[str, ...], on_key: Callable[[str], None] = lambda _key: None) -> None:
        self._addresses = frozenset(addresses)
        self.cookie_name = f"onika-{addresses[0].rpartition(':')[2]}"
        """With the port: browsers keep cookies by host, and two environments of a machine have one host."""
        self._on_key = on_key
        self._cookies: set[str] = set()
        self.key = secrets.token_urlsafe(24)

    def enter(self, key: str) -> str | None:
        """A cookie for whoever has the key, which is void from then on; None for any other."""
        if not hmac.compare_digest(key.encode(), self.key.encode()):
            return None
        cookie = secrets.token_urlsafe(32)
        self._cookies.add(cookie)
        self.key = secrets.token_urlsafe(24)
        self._on_key(self.key)
        return cookie

    def knows(self, cookies: Mapping[str, str]) -> bool:
        """Whether a browser came in before."""
        given = cookies.get(self.cookie_name, "").encode()
        return any(hmac.compare_digest(given, cookie.encode()) for cookie in self._cookies)

    def visitor(self, cookies: Mapping[str, str]) -> Visitor | None:
        """Whoever has the key may do everything; None: somebody who never had it."""
        return OWNER if self.knows(cookies) else None

    def is_ours(self, headers: Mapping[str, str]) -> bool:
        """Whether a request names us as its host: a foreign name that leads here does not (DNS rebinding)."""
        return headers.get("host", "") in self._addresses

    def is_own_page(self, headers: Mapping[str, str]) -> bool:
        """Whether a WebSocket is opened by a page that came from here."""
        scheme, _, address = headers.get("origin", "").partition("://")
        return scheme in ("http", "https") and address in self._addresses and address == headers.get("host", "")
