"""A library on a server of the web, asked over six plain connections at a time: so few round trips suffice (F03).

A long file comes over several of them, too. Its first piece is asked for alone, so that whoever is not let in is turned
away once, and a wrong password counts once.
"""

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from threading import Lock, Thread
from typing import TYPE_CHECKING

from onika.store.remote.address import WebAddress
from onika.store.remote.credential import Credential
from onika.store.remote.limits import Limits
from onika.store.remote.piece import FIRST, Piece, Span, joined, shares
from onika.store.remote.source import Wanted
from onika.words.reason import Reason

if TYPE_CHECKING:
    from onika.store.remote.web_connection import WebConnection

CONNECTIONS = 6
_LATE = ("store.server_slow", "store.server_silent")
"""The keys of what is said of a server for which was waited long enough."""


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

    def expected(self) -> None:
        """Wait until the connections of `expect_more` are open, or cannot be opened."""
        for opener in self._openers:
            opener.join()

    def fetch(self, wanted: Iterable[Wanted]) -> Mapping[str, bytes] | Reason:
        """All of these by their paths; at the first that does not come, nothing more is asked for."""
        fetching = _Fetching(deque(wanted))
        count = min(len(self._connections), len(fetching.waiting))
        if not count:
            return {}
        if count == 1:
            return self._alone(fetching.waiting.popleft())
        self.expected()
        used = self._connections[:count]
        _side_by_side(Thread(target=fetching.carry_out, args=(connection,), daemon=True) for connection in used)
        return fetching.outcome

    def _alone(self, wanted: Wanted) -> Mapping[str, bytes] | Reason:
        """One file; where it is long, over all connections that are open."""
        first = self._connections[0]
        if wanted.most <= FIRST:
            content = first.get(wanted)
        else:
            content = self._completed(wanted, first.piece(wanted, Span(0, FIRST)))
        if isinstance(content, Reason):
            return content
        return {wanted.path: content}

    def _completed(self, wanted: Wanted, first: Piece | Reason) -> bytes | Reason:
        """The file that begins with a piece; it is asked for as a whole where it was changed meanwhile."""
        if isinstance(first, Reason):
            return first
        if first.is_whole:
            return first.content
        pieces = [first, *self._others(wanted, first.size)]
        late = next((piece for piece in pieces if isinstance(piece, Reason) and piece.key in _LATE), None)
        if late is not None:
            return late
        content = joined([piece for piece in pieces if isinstance(piece, Piece)])
        if content is None:
            return self._connections[0].get(wanted)
        return content

    def _others(self, wanted: Wanted, size: int) -> Sequence[Piece | Reason]:
        """All but the first piece, at a time; a connection that is not open yet would only come later."""
        open_ones = [connection for connection in self._connections if connection.is_open]
        spans = shares(size, FIRST, max(len(open_ones), 1))
        pieces: dict[int, Piece | Reason] = {}

        def ask(connection: "WebConnection", span: Span) -> None:
            pieces[span.begin] = connection.piece(wanted, span)

        asked = zip(open_ones or self._connections, spans, strict=False)
        _side_by_side(Thread(target=ask, args=each, daemon=True) for each in asked)
        return [pieces[span.begin] for span in spans]

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


def _side_by_side(threads: Iterable[Thread]) -> None:
    begun = list(threads)
    for thread in begun:
        thread.start()
    for thread in begun:
        thread.join()
