"""Other sites, as a page shows what was found of them (F06). All of it are hints."""

from typing import Literal

from onika.wire.view.view import View
from onika.words.reason import Reason


class NetworkRuntimeView(View, frozen=True):
    """A runtime that a site offers, with the robots that it drives."""

    address: str
    robots: tuple[str, ...] = ()


class NetworkSiteView(View, frozen=True):
    """A site by its card."""

    name: str
    signer: str
    """The fingerprint of the key."""
    standing: Literal["known", "new", "namesake", "other_key", "older", "overdue"]
    """How it stands with its key, as `onika.fabric.listing` says it."""
    until: str
    """The last day on which the card counts."""
    description: str = ""
    runtimes: tuple[NetworkRuntimeView, ...] = ()
    libraries: tuple[str, ...] = ()


class NetworkPlaceView(View, frozen=True):
    """Where cards are looked for."""

    address: str
    why: Reason | None = None
    """Why it gave nothing."""


class NetworkView(View, frozen=True):
    """What one look has found."""

    places: tuple[NetworkPlaceView, ...] = ()
    sites: tuple[NetworkSiteView, ...] = ()
    left_out: int = 0
    """Cards that are not listed, because there are too many."""
    bad: int = 0
    """Cards that are not good."""
    unjudged: int = 0
    """Cards that were not judged yet."""
