"""A library on a server of the web, asked over six plain connections at a time: so few round trips suffice (F03)."""

from collections import deque
from collections.abc import Iterable, Mapping
from threading import Lock, Thread
from typing import TYPE_CHECKING

from onika.store.remote.address import WebAddress
from onika.store.remote.credential import Credential
from onika.store.remote.limits import Limits
from onika.store.remote.source import Wanted
from onika.words.reason import Reason

if TYPE_CHECKING:
    from onika.store.remote.web_connection import WebConnection

CONNECTIONS = 6


class WebSource:
    """Used by one thread at a time; connections stay open from one fetching to the next, until it is closed."""

    def __init__(self, address: WebAddress, limits: Limits | None = None, credential: Credential | None = None) -> None:
        from onika.store.remote.web_connection import WebConnection  # within: HTTP and TLS take long to load

        made = limits or Limits()
        self._connections = [WebConnection(address, made, credential) for _ in range(CONNECTIONS)]
        self._openers: list[Thread] = []

    def expect_more(self) -> None:
        """Open the connections that the next fetching will need, while this one is still under way."""
        self._openers = [Thread(target=connection.open, daemon=True) for connection in self._connections[1:]]
        for opener in self._openers:
            opener.start()

    def fetch(self, wanted: Iterable[Wanted]) -> Mapping[str, bytes] | Reason:
        """All of these by their paths; at the first that does not come, nothing more is asked for."""
        fetching = _Fetching(deque(wanted))
        count = min(len(self._connections), len(fetching.waiting))
        if count <= 1:
            fetching.carry_out(self._connections[0])
            return fetching.outcome
        for opener in self._openers:
            opener.join()
        threads = [
            Thread(target=fetching.carry_out, args=(connection,), daemon=True)
            for connection in self._connections[:count]
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return fetching.outcome

    def send(self, path: str, body: bytes, most: int) -> bytes | Reason:
        """Send something, and have what is answered, at most so many bytes."""
        return self._connections[0].post(path, body, most)

    def close(self) -> None:
        """End all connections."""
        for connection in self._connections:
            connection.end()


class _Fetching:
    """Files that are shared out among connections."""

    def __init__(self, waiting: deque[Wanted]) -> None:
        self.waiting = waiting
        self._files: dict[str, bytes] = {}
        self._refusal: Reason | None = None
        self._lock = Lock()

    @property
    def outcome(self) -> Mapping[str, bytes] | Reason:
        return self._files if self._refusal is None else self._refusal

    def carry_out(self, connection: "WebConnection") -> None:
        """Ask for one file after the other until there is none left."""
        while True:
            with self._lock:
                if self._refusal is not None or not self.waiting:
                    return
                file = self.waiting.popleft()
            answer = connection.get(file)
            with self._lock:
                if isinstance(answer, Reason):
                    self._refusal = self._refusal or answer
                else:
                    self._files[file.path] = answer
