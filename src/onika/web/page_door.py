"""The door of a page: who is let in there, over what, and what is told when it is open."""

import asyncio
import socket
import ssl
from collections.abc import Callable, Sequence
from typing import Protocol

from starlette.routing import Route

from onika.web.access.entrance import Entrance
from onika.web.login import Login
from onika.web.server import addresses


class PageDoor(Protocol):
    """What a server of the page needs to know of it."""

    @property
    def entrance(self) -> Entrance:
        """Who is let in."""
        ...

    @property
    def context(self) -> ssl.SSLContext | None:
        """The server's side of TLS; None: there is none."""
        ...

    @property
    def ways(self) -> Sequence[Route]:
        """What else may be asked of it, beside the page."""
        ...

    def ready(self) -> None:
        """It is open."""
        ...

    async def keep(self) -> None:
        """What there is to do meanwhile; does not end by itself."""
        ...

    def close(self) -> None:
        """Nobody is let in any more."""
        ...


class KeyDoor:
    """The door for this machine: `on_ready` is told each address that lets one browser in."""

    context = None
    ways = ()

    def __init__(self, listening: socket.socket, on_ready: Callable[[str], None]) -> None:
        self._address, self._on_ready = addresses(listening)[0], on_ready
        self.entrance = Login(addresses(listening), self._tell)

    def ready(self) -> None:
        """Tell the first address."""
        self._tell(self.entrance.key)

    async def keep(self) -> None:
        """Nothing is to be done."""
        await asyncio.Event().wait()

    def close(self) -> None:
        """Its key is of no use without it."""

    def _tell(self, key: str) -> None:
        self._on_ready(f"http://{self._address}/?key={key}")
