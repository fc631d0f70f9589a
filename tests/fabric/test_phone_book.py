"""The user's book and all places: one that lies, floods, or never answers harms no other."""

import pytest

from kit.fabric.announced_site import TODAY, AnnouncedSite
from kit.labs.library_server import LibraryServer
from onika.fabric import phone_book
from onika.fabric.address_book import AddressBook
from onika.fabric.listing import NetworkListing
from onika.fabric.phone_book import BOOK, Look, PhoneBook, by_turns
from onika.fabric.signed_card import bound
from onika.words.reason import Reason


@pytest.fixture(scope="module")
def cmu(tmp_path_factory):
    return AnnouncedSite(tmp_path_factory.mktemp("cmu"), "cmu.puma")


def book_at(folder, *contents):
    folder.mkdir()
    (folder / BOOK).write_bytes(bound(contents))
    return str(folder)


def names(look):
    return [(entry.card.name, entry.standing) for entry in look.listing.entries]


def test_sites_are_found_in_folders_and_on_servers(tmp_path, cmu):  # R-F06
    book = PhoneBook(tmp_path / "state")
    assert book.look(TODAY) == Look(AddressBook(), NetworkListing())
    folder = book_at(tmp_path / "web", cmu.card())
    with LibraryServer(tmp_path / "web") as server:
        assert book.add_place(server.address) is None
        assert names(book.look(TODAY)) == [("cmu.puma", "new")]
        assert book.drop_place(server.address) is None
    assert book.add_place(folder) is None
    assert book.trust("cmu.puma", cmu.signer) is None
    assert names(book.look(TODAY)) == [("cmu.puma", "known")]
    assert book.look(TODAY).book.sites["cmu.puma"].serial == 1000


def test_a_place_that_lies_floods_or_gives_nothing_leaves_the_others_as_they_are(tmp_path, cmu, monkeypatch):  # R-F06
    lies = cmu.card().replace(b"robots.cmu.edu", b"robots.evil.ed")
    monkeypatch.setattr(phone_book, "JUDGING_S", 0.2)
    flood = [lies.replace(b"PUMA", f"{number:04}".encode()) for number in range(900)]
    places = [book_at(tmp_path / "lies", lies), book_at(tmp_path / "flood", *flood)]
    places += [book_at(tmp_path / "honest", cmu.card()), str(tmp_path / "nothing")]
    (tmp_path / "noise").mkdir()
    (tmp_path / "noise" / BOOK).write_bytes(b"\x28\xb5\x2f\xfdnoise")
    book = PhoneBook(tmp_path / "state")
    for place in [*places, str(tmp_path / "noise")]:
        assert book.add_place(place) is None
    assert book.trust("cmu.puma", cmu.signer) is None
    look = book.look(TODAY)
    assert names(look) == [("cmu.puma", "known")]
    assert look.listing.bad + look.listing.unjudged == 901
    assert [place for place, _ in look.faults] == [str(tmp_path / "nothing"), str(tmp_path / "noise")]


def test_a_server_that_never_answers_is_left_after_a_while(tmp_path, cmu, monkeypatch):  # R-F06
    monkeypatch.setattr(phone_book, "PATIENCE_S", 0.4)
    book = PhoneBook(tmp_path / "state")
    with LibraryServer(tmp_path) as server:
        server.answers[BOOK] = lambda connection: server.stop.wait(20)
        assert book.add_place(server.address) is None
        assert book.add_place(book_at(tmp_path / "honest", cmu.card())) is None
        look, silent = book.look(TODAY), server.address
    assert names(look) == [("cmu.puma", "new")]
    assert [place for place, _ in look.faults] == [silent]


def test_places_are_looked_at_by_turns():  # R-F06
    assert by_turns([(b"a", b"b", b"c"), (), (b"x",)]) == [b"a", b"x", b"b", b"c"]


def test_what_cannot_be_kept_or_read_is_told(tmp_path):  # R-F06
    book = PhoneBook(tmp_path / "state")
    assert book.add_place("ftp://x").key == "store.address_form"
    assert book.drop_place("lan").key == "fabric.no_place"
    assert book.trust("x", "y").key == "fabric.trust_form"
    (tmp_path / "state").mkdir(exist_ok=True)
    (tmp_path / "state" / "address-book").mkdir()
    assert isinstance(book.look(TODAY), Reason)
    assert isinstance(book.add_place("lan"), Reason)
