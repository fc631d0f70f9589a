"""A runtime that somebody else started, reached over the network."""

import os
from pathlib import Path
from time import monotonic_ns
from types import TracebackType

from onika.desk.run.runtime_conversation import RuntimeConversation
from onika.link.address import Address
from onika.link.connection import Connection
from onika.link.connector import ThreadConnector
from onika.link.link_terms import REMOTE
from onika.link.lost import LinkLost, LossCause
from onika.link.token import read_token, token_path
from onika.link.websocket_opening import WebSocketOpening
from onika.words.reason import Reason, reason_of


class RemoteRuntime(RuntimeConversation):
    """A runtime that somebody else started; it lives on after the `with` block."""

    def __init__(self, opening: WebSocketOpening) -> None:
        self._opening = opening
        super().__init__(Connection(None, monotonic_ns, REMOTE, connector=ThreadConnector(opening)))

    def __enter__(self) -> "RemoteRuntime":
        try:
            self._connection.open(REMOTE.greeting_ns / 1e9)
        except (LinkLost, TimeoutError) as lost:
            self._connection.close(timeout_s=0.0)
            if isinstance(lost, LinkLost):
                raise
            late = Reason.of("link.late", address=str(self._opening.address), why=reason_of(lost))
            raise LinkLost(LossCause.TIMEOUT, late) from None
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._connection.close(timeout_s=0.5)


def connect(url: str, token: str = "", ca: Path | None = None) -> RemoteRuntime:
    """A runtime at an address; raises ValueError for what is no address, LinkLost where no token is to be had.

    token   empty: that of ONIKA_TOKEN, or on this machine the one in the user's state directory
    ca      a file of certificates to trust beside the system's
    """
    address = Address.parse(url)
    return RemoteRuntime(WebSocketOpening(address, token or _token(address), ca))


def _token(address: Address) -> str:
    from_environment = os.environ.get("ONIKA_TOKEN", "")
    if from_environment:
        return from_environment
    try:
        if address.is_near:
            return read_token(token_path())
        return _missing(address)
    except (OSError, ValueError):
        return _missing(address)


def _missing(address: Address) -> str:
    raise LinkLost(LossCause.TOKEN, Reason.of("link.token_needed", address=str(address)))
