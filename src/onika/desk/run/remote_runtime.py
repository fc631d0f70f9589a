"""A runtime on another machine, or one that somebody else started here: reached at its address."""

import os
from contextlib import AbstractContextManager, closing, nullcontext
from dataclasses import replace
from pathlib import Path
from time import monotonic_ns
from types import TracebackType

from onika.desk.run.runtime_conversation import RuntimeConversation
from onika.files.state.known_sites import KnownSites, known_sites_path
from onika.link.address import Address, is_near
from onika.link.connection import Connection
from onika.link.connector import ThreadConnector
from onika.link.link_terms import REMOTE
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.runtime_address import address_of
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import LAUNCH_S
from onika.link.starting.site_opening import SiteOpening
from onika.link.starting.ssh_address import SshAddress
from onika.link.starting.ssh_opening import START_S, SshOpening
from onika.link.token import read_token, token_path
from onika.link.websocket_opening import WebSocketOpening
from onika.words.reason import Reason, reason_of

_BY_SSH = replace(REMOTE, greeting_ns=round(START_S * 1e9) + REMOTE.greeting_ns)
"""The terms where ssh starts a runtime when somebody comes."""
_BY_SITE = replace(REMOTE, greeting_ns=round(LAUNCH_S * 1e9) + REMOTE.greeting_ns)
"""The terms where a site does."""


class RemoteRuntime(RuntimeConversation):
    """A runtime at an address; unless it was started for this, it lives on after the `with` block."""

    def __init__(self, opening: WebSocketOpening | SshOpening | SiteOpening) -> None:
        self._opening = opening
        self._terms = REMOTE
        self._way: AbstractContextManager[object] = nullcontext()
        if isinstance(opening, SshOpening):
            self._terms, self._way = _BY_SSH, closing(opening)
        elif isinstance(opening, SiteOpening):
            self._terms = _BY_SITE
        super().__init__(Connection(None, monotonic_ns, self._terms, connector=ThreadConnector(opening)))

    def __enter__(self) -> "RemoteRuntime":
        try:
            self._connection.open(self._terms.greeting_ns / 1e9)
        except BaseException as lost:
            self._connection.close(timeout_s=0.0)
            self._way.__exit__(None, None, None)
            if not isinstance(lost, TimeoutError):
                raise
            late = Reason.of("link.late", address=str(self._opening.address), why=reason_of(lost))
            raise LinkLost(LossCause.TIMEOUT, late) from None
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._connection.close(timeout_s=0.5)
        self._way.__exit__(kind, fault, trace)


def connect(url: str, token: str = "", ca: Path | None = None) -> RemoteRuntime:
    """A runtime at an address; raises ValueError for what is no address, LinkLost where no token is to be had.

    token   empty: that of ONIKA_TOKEN, or on this machine the one in the user's state directory; none for `ssh://`
    ca      a file of certificates to trust beside the system's
    """
    address = address_of(url)
    if isinstance(address, SshAddress):
        return RemoteRuntime(SshOpening(address))
    if isinstance(address, SiteAddress):
        sites = KnownSites(known_sites_path())
        return RemoteRuntime(SiteOpening(address, token or token_for(address), ca, sites))
    return RemoteRuntime(WebSocketOpening(address, token or token_for(address), ca))


def token_for(address: Address | SiteAddress) -> str:
    """The token for an address for which none was named; raises LinkLost where none is to be had."""
    from_environment = os.environ.get("ONIKA_TOKEN", "")
    if from_environment:
        return from_environment
    try:
        if is_near(address.host):
            return read_token(token_path())
        return _missing(address)
    except (OSError, ValueError):
        return _missing(address)


def _missing(address: Address | SiteAddress) -> str:
    raise LinkLost(LossCause.TOKEN, Reason.of("link.token_needed", address=str(address)))
