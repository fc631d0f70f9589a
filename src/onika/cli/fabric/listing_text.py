"""What `onika fabric list` prints, as sentences."""

from collections.abc import Iterator

from onika.fabric.listing import SiteEntry
from onika.fabric.phone_book import Look
from onika.words.reason import Reason

_STANDINGS = {
    "known": Reason.of("cli.fabric_standing_known"),
    "new": Reason.of("cli.fabric_standing_new"),
    "namesake": Reason.of("cli.fabric_standing_namesake"),
    "other_key": Reason.of("cli.fabric_standing_other_key"),
    "older": Reason.of("cli.fabric_standing_older"),
    "overdue": Reason.of("cli.fabric_standing_overdue"),
}


def lines(look: Look) -> Iterator[Reason]:
    """The sites, then what is to be said of places and cards."""
    listing = look.listing
    for entry in listing.entries:
        yield from _of_site(entry)
    if not look.book.places:
        yield Reason.of("cli.fabric_no_places")
    elif not listing.entries:
        yield Reason.of("cli.fabric_no_sites")
    for place, why in look.faults:
        yield Reason.of("cli.fabric_place_fault", place=place, why=why)
    if listing.left_out:
        yield Reason.of("cli.fabric_left_out", count=listing.left_out)
    if listing.bad:
        yield Reason.of("cli.fabric_bad", count=listing.bad)
    if listing.unjudged:
        yield Reason.of("cli.fabric_unjudged", count=listing.unjudged)


def _of_site(entry: SiteEntry) -> Iterator[Reason]:
    card = entry.card
    yield Reason.of("cli.fabric_site", name=card.name, standing=_STANDINGS[entry.standing], signer=entry.signer)
    if card.description:
        yield Reason.of("cli.fabric_site_about", text=card.description)
    for runtime in card.runtimes:
        yield Reason.of("cli.fabric_site_runtime", address=runtime.address, robots=", ".join(runtime.robots))
    for library in card.libraries:
        yield Reason.of("cli.fabric_site_library", address=library)
