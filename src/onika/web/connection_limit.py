"""A limit of the connections that have shown nothing yet, so that a crowd at the door keeps nobody out who is in.

A browser that is let in talks over a WebSocket; all other connections are few and short. Where too many come, of the
address that has the most the one goes that has been silent for longest, before any more descriptors are used up.
"""

import asyncio
from collections import Counter
from collections.abc import Collection
from typing import cast

from uvicorn.protocols.http.h11_impl import H11Protocol

MOST = 64
"""Connections at a time that are no WebSocket; a browser opens about six."""
_LIMIT_S = 10.0
"""How long a connection may take to ask for something whole."""


def limited_protocol(most: int = MOST, limit_s: float = _LIMIT_S) -> type[H11Protocol]:
    """The HTTP protocol of one server that has at most so many connections which are no WebSocket."""
    waiting: dict[H11Protocol, None] = {}

    class LimitedProtocol(H11Protocol):
        """One connection, until it is a WebSocket or ends."""

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            """Somebody has come: whoever has been silent for longest makes room."""
            super().connection_made(transport)
            waiting[self] = None
            self._end = self.loop.call_later(limit_s, self._end_if_silent)
            if len(waiting) > most:
                silent = _in_the_way(waiting)
                silent.transport.abort()
                waiting.pop(silent, None)

        def connection_lost(self, exc: Exception | None) -> None:
            """It is gone."""
            self._forget()
            super().connection_lost(exc)

        def handle_websocket_upgrade(self, event: object) -> None:
            """It is a WebSocket from now on, and judged as one."""
            self._forget()
            super().handle_websocket_upgrade(event)  # type: ignore[arg-type]

        def _forget(self) -> None:
            waiting.pop(self, None)
            self._end.cancel()

        def _end_if_silent(self) -> None:
            if _is_silent(self):
                self.transport.abort()

    return LimitedProtocol


def _in_the_way(waiting: Collection[H11Protocol]) -> H11Protocol:
    """Of the address that has the most connections the one that has been silent for longest."""
    crowded, _ = Counter(map(_address, waiting)).most_common(1)[0]
    same = [protocol for protocol in waiting if _address(protocol) == crowded]
    return next(filter(_is_silent, same), same[0])


def _address(protocol: H11Protocol) -> str:
    return protocol.client[0] if protocol.client else ""


def _is_silent(protocol: H11Protocol) -> bool:
    """Whether nothing whole has been asked on it yet; the library says so by a cycle that is not there."""
    return cast("object | None", protocol.cycle) is None
