"""Looks at all places at once, each for so long only, and lists what they have; the user's own book with it (F06)."""

import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from datetime import date
from itertools import zip_longest
from pathlib import Path

from onika.fabric.address_book import AddressBook, AddressBookFile
from onika.fabric.listing import CardJudge, NetworkListing, remembered
from onika.fabric.place import Place, RouterPlace, place_of, written
from onika.fabric.router_cards import router_cards
from onika.fabric.signed_card import LARGEST_BOOK, opened, unbound
from onika.store.remote.limits import Limits
from onika.store.remote.source import FolderSource, Wanted
from onika.store.remote.web_source import WebSource
from onika.words.reason import Reason
from onika.words.system_error import system_reason_with_place

BOOK = "phonebook"
"""What a file of cards is called."""
PATIENCE_S = 8.0
"""How long a place may take."""
JUDGING_S = 3.0
"""How long signatures are judged at one look."""
MOST_LOOKED = 10_000
"""Cards of all places that are looked at."""

Bring = Callable[[Place], "tuple[bytes, ...] | Reason"]


@dataclass(frozen=True, slots=True)
class Look:
    """What one look has found."""

    book: AddressBook
    listing: NetworkListing
    faults: tuple[tuple[str, Reason], ...] = ()
    """Places that gave nothing, and why."""


class PhoneBook:
    """Used by one thread at a time; whatever a place does, the others are looked at as well."""

    def __init__(self, state: Path, bring: Bring | None = None) -> None:
        self._file = AddressBookFile(state)
        self._bring = bring or cards_at
        self._judge = CardJudge(opened)

    def look(self, today: date) -> Look | Reason:
        """Ask all places; why not, where the book itself cannot be read."""
        try:
            book = self._file.read()
            answers = list(zip(book.places, self._answers(book.places), strict=True))
            faults = tuple((place, answer) for place, answer in answers if isinstance(answer, Reason))
            contents = by_turns([answer for _, answer in answers if not isinstance(answer, Reason)])
            until_s = time.monotonic() + JUDGING_S
            listing = self._judge.listing(contents[:MOST_LOOKED], book, today, lambda: time.monotonic() < until_s)
            newer = remembered(book, listing.entries)
            if newer != book:
                self._file.write(newer)
            beyond = max(0, len(contents) - MOST_LOOKED)
            return Look(newer, replace(listing, left_out=listing.left_out + beyond), faults)
        except OSError as error:
            return system_reason_with_place(error)

    def add_place(self, text: str) -> Reason | None:
        """Look there too; why not."""
        place = written(text.strip())
        return place if isinstance(place, Reason) else self._changed(lambda book: book.with_place(place))

    def drop_place(self, place: str) -> Reason | None:
        """Look there no more; why not."""
        return self._changed(lambda book: book.without_place(place))

    def trust(self, name: str, signer: str) -> Reason | None:
        """Trust a key for the site of a name; why not."""
        return self._changed(lambda book: book.trusting(name, signer))

    def _changed(self, change: Callable[[AddressBook], AddressBook | Reason]) -> Reason | None:
        try:
            changed = change(self._file.read())
            if isinstance(changed, Reason):
                return changed
            self._file.write(changed)
        except OSError as error:
            return system_reason_with_place(error)
        return None

    def _answers(self, places: tuple[str, ...]) -> list[tuple[bytes, ...] | Reason]:
        if not places:
            return []
        with ThreadPoolExecutor(len(places), "places") as threads:
            return list(threads.map(self._answer, places))

    def _answer(self, text: str) -> tuple[bytes, ...] | Reason:
        place = place_of(text)
        return place if isinstance(place, Reason) else self._bring(place)


def by_turns(answers: Sequence[tuple[bytes, ...]]) -> list[bytes]:
    """Cards of several places, one of each in turn: a place that floods keeps nobody else's from being looked at."""
    rounds = zip_longest(*answers)
    return [card for cards in rounds for card in cards if card is not None]


def cards_at(place: Place) -> tuple[bytes, ...] | Reason:
    """The signed cards that a place has, none of them judged; why none come."""
    if isinstance(place, RouterPlace):
        return router_cards(place, PATIENCE_S)
    if isinstance(place, Path):
        folder, name = (place, BOOK) if place.is_dir() else (place.parent, place.name)
        answer = FolderSource(folder).fetch([Wanted(name, LARGEST_BOOK)])
        return answer if isinstance(answer, Reason) else unbound(answer[name])
    limits = Limits(LARGEST_BOOK, PATIENCE_S / 2, PATIENCE_S / 2, PATIENCE_S)
    source = WebSource(place, limits)
    try:
        answer = source.fetch([Wanted(BOOK, LARGEST_BOOK)])
    finally:
        source.close()
    return answer if isinstance(answer, Reason) else unbound(answer[BOOK])
