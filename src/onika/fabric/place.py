"""Where cards are found: a file of a server or folder, a router of Zenoh, or whatever router this network has (F06)."""

import re
from dataclasses import dataclass
from pathlib import Path

from onika.store.remote.address import WebAddress, library_address
from onika.words.reason import Reason

LAN = "lan"
"""A router that answers on this network."""
_ENDPOINT = re.compile(r"(?:tcp|tls|quic)/(?:[A-Za-z0-9._-]{1,253}|\[[0-9A-Fa-f:.]{2,45}\]):[0-9]{1,5}\Z")


@dataclass(frozen=True, slots=True)
class RouterPlace:
    """A router of Zenoh, as Zenoh writes it: `tcp/HOST:7447`; empty: the first that answers on this network."""

    endpoint: str = ""


Place = WebAddress | Path | RouterPlace


def place_of(text: str) -> Place | Reason:
    """What a user gives as the place of cards."""
    if text == LAN:
        return RouterPlace()
    if text.startswith(("tcp/", "tls/", "quic/")):
        return RouterPlace(text) if _ENDPOINT.match(text) else Reason.of("fabric.place_form", place=text[:200])
    if any(sign.isspace() for sign in text):
        return Reason.of("fabric.place_form", place=text[:200])
    return library_address(text)


def written(text: str) -> str | Reason:
    """A place as it is kept; a folder of this machine whole."""
    place = place_of(text)
    if isinstance(place, Reason):
        return place
    return str(place) if isinstance(place, Path) else text
