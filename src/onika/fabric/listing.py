"""What the network offers, as far as it may be believed: cards beside the keys that the user knows (F06).

Nothing here asks anybody. A site that lies gains nothing: its card counts for its own key and name only.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from datetime import date
from typing import Literal

from onika.fabric.address_book import AcquaintedSite, AddressBook
from onika.fabric.card import VisitingCard
from onika.fabric.signed_card import SignedCard, digest, glance
from onika.words.reason import Reason

Standing = Literal["known", "new", "namesake", "other_key", "older", "overdue"]
"""`known`: by the key that the user trusts; `new`: nobody he knows; `namesake`: several unknown keys bear this name;
`other_key`: not by the key that he trusts for the name; `older`, `overdue`: it counts no more."""
SHOWN = 500
"""Entries of a listing; known sites come first."""
_ORDER: Sequence[Standing] = ("known", "other_key", "new", "namesake", "older", "overdue")


@dataclass(frozen=True, slots=True)
class SiteEntry:
    """A site, as its card says, and how it stands with its key."""

    card: VisitingCard
    signer: str
    standing: Standing


@dataclass(frozen=True, slots=True)
class NetworkListing:
    """What was found."""

    entries: tuple[SiteEntry, ...] = ()
    left_out: int = 0
    """Cards beyond `SHOWN`."""
    bad: int = 0
    """Cards that are none, or whose signature is not good."""
    unjudged: int = 0
    """Cards for whose signature there was no time yet; the next look judges more."""


class CardJudge:
    """Judges signatures, each once; `opens` costs some ms a card, so that a flood of cards is judged bit by bit.

    opens  judges one signed card
    """

    def __init__(self, opens: Callable[[bytes], SignedCard | Reason]) -> None:
        self._opens = opens
        self._judged: dict[str, SignedCard | None] = {}

    def listing(
        self, contents: Iterable[bytes], book: AddressBook, today: date, has_time: Callable[[], bool]
    ) -> NetworkListing:
        """The sites of signed cards: those with names that the user knows are judged first."""
        unique = {digest(content): content for content in contents}
        self._judged = {key: known for key, known in self._judged.items() if key in unique}
        seen = {key: glance(content) for key, content in unique.items()}
        order = sorted(unique, key=lambda key: not _is_known(seen[key], book))
        for key in order:
            if key not in self._judged and not isinstance(seen[key], Reason):
                if not has_time():
                    break
                judged = self._opens(unique[key])
                self._judged[key] = None if isinstance(judged, Reason) else judged
        good = [card for key in order if (card := self._judged.get(key)) is not None]
        waiting = sum(key not in self._judged and not isinstance(seen[key], Reason) for key in order)
        entries = entered(good, book, today)
        bad = len(order) - len(good) - waiting
        return NetworkListing(entries[:SHOWN], max(0, len(entries) - SHOWN), bad, waiting)


def entered(good: Iterable[SignedCard], book: AddressBook, today: date) -> tuple[SiteEntry, ...]:
    """Each site once for each key, by its newest card; known ones first, then by name."""
    newest: dict[tuple[str, str], SignedCard] = {}
    for seen in good:
        key = (seen.card.name, seen.signer)
        if key not in newest or newest[key].card.serial < seen.card.serial:
            newest[key] = seen
    names = Counter(name for name, _ in newest)
    entries = [
        SiteEntry(seen.card, seen.signer, _standing(seen, book, today, is_alone=names[seen.card.name] == 1))
        for seen in newest.values()
    ]
    return tuple(sorted(entries, key=lambda entry: (_ORDER.index(entry.standing), entry.card.name, entry.signer)))


def remembered(book: AddressBook, entries: Iterable[SiteEntry]) -> AddressBook:
    """The book with the newest card of each site that is known; a key that was announced takes the place of the old."""
    for entry in entries:
        known = book.sites.get(entry.card.name)
        if entry.standing == "known" and known is not None:
            card = entry.card
            book = book.having_seen(AcquaintedSite(card.name, entry.signer, card.serial, card.next_key))
    return book


def _standing(seen: SignedCard, book: AddressBook, today: date, *, is_alone: bool) -> Standing:
    known = book.sites.get(seen.card.name)
    if known is not None and seen.signer not in {known.signer, known.next_key} - {""}:
        return "other_key"
    if seen.card.until < today:
        return "overdue"
    if known is None:
        return "new" if is_alone else "namesake"
    return "older" if seen.card.serial < known.serial else "known"


def _is_known(seen: SignedCard | Reason, book: AddressBook) -> bool:
    """Whether a card calls itself, by name and key, a site that the user knows."""
    if isinstance(seen, Reason):
        return False
    known = book.sites.get(seen.card.name)
    return known is not None and seen.signer in (known.signer, known.next_key)
