"""Whom the user knows: sites by name with their keys, and the places where cards are looked for (F06).

A text in the state directory, read and written whole; a key is trusted once, by the user, as that of a library is.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType

from onika.files.library_index import KEY, NO_KEY
from onika.files.line import row
from onika.store.remote.object_cache import write_whole
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

FILE = "address-book"
MOST_PLACES = 16
MOST_SITES = 2000
_LARGEST = 1_000_000
_NUMBER = re.compile(r"[0-9]{1,12}\Z")


@dataclass(frozen=True, slots=True)
class AcquaintedSite:
    """A site whose key the user trusts."""

    name: str
    signer: str
    serial: int = 0
    """That of the newest card that was seen; an older one is refused."""
    next_key: str = ""


@dataclass(frozen=True, slots=True)
class AddressBook:
    """Frozen: every change is another one."""

    places: tuple[str, ...] = ()
    sites: Mapping[str, AcquaintedSite] = field(default_factory=lambda: MappingProxyType({}))

    def with_place(self, place: str) -> "AddressBook | Reason":
        """Look there too from now on."""
        if place in self.places:
            return self
        if len(self.places) >= MOST_PLACES:
            return Reason.of("fabric.places_many", most=MOST_PLACES)
        return replace(self, places=(*self.places, place))

    def without_place(self, place: str) -> "AddressBook | Reason":
        """Look there no more."""
        if place not in self.places:
            return Reason.of("fabric.no_place", place=place)
        return replace(self, places=tuple(other for other in self.places if other != place))

    def trusting(self, name: str, signer: str) -> "AddressBook | Reason":
        """Take a key for that of the site of this name from now on, whatever was before."""
        if not TASK_NAME.match(name) or not KEY.match(signer):
            return Reason.of("fabric.trust_form")
        if name not in self.sites and len(self.sites) >= MOST_SITES:
            return Reason.of("fabric.sites_many", most=MOST_SITES)
        return self._with(AcquaintedSite(name, signer))

    def having_seen(self, site: AcquaintedSite) -> "AddressBook":
        """With the newest card of a site that is known."""
        return self if self.sites.get(site.name) == site else self._with(site)

    def _with(self, site: AcquaintedSite) -> "AddressBook":
        return replace(self, sites=MappingProxyType({**self.sites, site.name: site}))


class AddressBookFile:
    """The book in the state directory; raises OSError."""

    def __init__(self, state: Path) -> None:
        self.path = state / FILE

    def read(self) -> AddressBook:
        """The book; an empty one where there is none. A line that is none is left out."""
        try:
            with self.path.open("rb") as file:
                text = file.read(_LARGEST).decode("utf-8", "replace")
        except FileNotFoundError:
            return AddressBook()
        places: list[str] = []
        sites: dict[str, AcquaintedSite] = {}
        for line in text.splitlines():
            match line.split():
                case ["PLACE", place]:
                    places.append(place)
                case ["SITE", name, signer, serial, next_key] if _is_site(name, signer, serial, next_key):
                    sites[name] = AcquaintedSite(name, signer, int(serial), "" if next_key == NO_KEY else next_key)
        return AddressBook(tuple(places[:MOST_PLACES]), MappingProxyType(sites))

    def write(self, book: AddressBook) -> None:
        """Keep the book."""
        lines = [row("PLACE", place) for place in book.places]
        lines += [
            row("SITE", site.name, site.signer, str(site.serial), site.next_key or NO_KEY)
            for site in book.sites.values()
        ]
        write_whole(self.path, "".join(lines).encode())


def _is_site(name: str, signer: str, serial: str, next_key: str) -> bool:
    is_next = next_key == NO_KEY or KEY.match(next_key) is not None
    return bool(TASK_NAME.match(name) and KEY.match(signer) and _NUMBER.match(serial)) and is_next
