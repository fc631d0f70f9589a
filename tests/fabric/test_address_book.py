import pytest

from kit.fabric.announced_site import signer
from onika.fabric.address_book import FILE, MOST_PLACES, AcquaintedSite, AddressBook, AddressBookFile


def test_a_book_is_kept_for_its_user_only_and_read_again(tmp_path):  # R-F06
    file = AddressBookFile(tmp_path / "state")
    assert file.read() == AddressBook()
    book = AddressBook().with_place("lan").with_place("https://a/b").trusting("cmu", signer("a"))
    book = book.having_seen(AcquaintedSite("cmu", signer("a"), 12, signer("b")))
    file.write(book)
    assert file.read() == book
    assert file.path.stat().st_mode & 0o777 == 0o600


def test_lines_that_are_none_are_left_out(tmp_path):  # R-F06
    lines = ["PLACE lan", "SITE cmu nokey 1 none", "SITE cmu", "\x00\xff", f"SITE x {signer('a')} 1 none more"]
    (tmp_path / FILE).write_text("\n".join(lines))
    assert AddressBookFile(tmp_path).read() == AddressBook(("lan",))


def test_a_place_is_looked_at_once_and_at_most_so_many(tmp_path):  # R-F06
    book = AddressBook().with_place("lan")
    assert book.with_place("lan") is book
    assert book.without_place("lan") == AddressBook()
    assert book.without_place("wan").key == "fabric.no_place"
    full = AddressBook(tuple(str(number) for number in range(MOST_PLACES)))
    assert full.with_place("lan").key == "fabric.places_many"


@pytest.mark.parametrize(("name", "key"), [("no name", signer("a")), ("cmu", "SHA256:short")])
def test_what_is_no_key_of_a_site_is_not_trusted(name, key):  # R-F06
    assert AddressBook().trusting(name, key).key == "fabric.trust_form"


def test_another_key_takes_the_place_of_the_former_when_the_user_says_so():  # R-F06
    book = AddressBook().trusting("cmu", signer("a")).having_seen(AcquaintedSite("cmu", signer("a"), 12))
    assert book.trusting("cmu", signer("b")).sites["cmu"] == AcquaintedSite("cmu", signer("b"))
    assert book.having_seen(book.sites["cmu"]) is book
