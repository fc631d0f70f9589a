from kit.fabric.announced_site import TODAY, believed, signer
from onika.cli.fabric.listing_text import lines
from onika.fabric.address_book import AddressBook
from onika.fabric.listing import NetworkListing, entered
from onika.fabric.phone_book import Look
from onika.words.reason import Reason

BOOK = AddressBook(("lan",)).trusting("cmu", signer("a"))


def keys(look):
    return [line.key.removeprefix("cli.fabric_") for line in lines(look)]


def test_a_site_is_told_with_its_standing_and_all_that_it_offers():  # R-F06
    entries = entered([believed("cmu", "b")], BOOK, TODAY)
    told = list(lines(Look(BOOK, NetworkListing(entries))))
    assert "ANOTHER KEY" in str(told[0])
    assert [line.key for line in told[1:]] == [
        "cli.fabric_site_about",
        "cli.fabric_site_runtime",
        "cli.fabric_site_library",
    ]


def test_what_was_not_found_or_not_judged_is_told():  # R-F06
    assert keys(Look(AddressBook(), NetworkListing())) == ["no_places"]
    faults = (("lan", Reason.of("fabric.no_zenoh")),)
    whole = ["no_sites", "place_fault", "left_out", "bad", "unjudged"]
    assert keys(Look(BOOK, NetworkListing((), 1, 2, 3), faults)) == whole
