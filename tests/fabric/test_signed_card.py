import pytest
import zstandard

from kit.fabric.announced_site import CARD, AnnouncedSite
from onika.fabric import signed_card
from onika.fabric.card import LARGEST, write
from onika.fabric.signed_card import MOST_CARDS, bound, digest, glance, opened, signed, unbound
from onika.store.remote.signature import sign


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    return AnnouncedSite(tmp_path_factory.mktemp("site"), "cmu.puma")


def test_a_signed_card_names_its_signer(site):  # R-F06
    seen = opened(site.card())
    assert (seen.card, seen.signer) == (CARD, site.signer)
    assert glance(site.card()) == seen


@pytest.mark.parametrize(
    "altered",
    [
        lambda content: content.replace(b"arm", b"leg"),
        lambda content: content.replace(b"wss://robots.cmu.edu", b"wss://robots.evil.ed"),
        lambda content: content[content.index(b"CARD") :],
        lambda content: content + b" " * LARGEST,
        lambda content: b"",
    ],
)
def test_an_altered_card_is_none(site, altered):  # R-F06
    assert opened(altered(site.card())).key.partition(".")[0] in ("store", "fabric")


def test_a_signature_for_a_library_is_none_for_a_card(site):  # R-F06
    assert opened(sign(write(CARD), site.key)).key == "store.signature_of_other"


def test_a_card_that_cannot_be_written_or_signed_is_told(site, tmp_path):  # R-F06
    assert signed(CARD, tmp_path / "no key").key == "store.not_signed"
    with pytest.raises(TypeError, match=r"expected a name"):
        site.card(name="no name")


def test_many_cards_are_one_file_packed_or_plain(site):  # R-F06
    contents = (site.card(), site.card(serial=1001), site.card(serial=1002))
    assert unbound(bound(contents)) == contents
    assert unbound(b"".join(contents)) == contents
    assert len({digest(content) for content in contents}) == 3


def test_a_file_that_is_no_book_is_refused_before_it_is_large(site, monkeypatch):  # R-F06
    head = b"-----BEGIN SSH SIGNATURE-----\n"
    assert unbound(b"hello" + site.card()).key == "fabric.book_form"
    assert unbound(b"").key == "fabric.book_form"
    assert unbound(bound([site.card()])[:-9]).key in ("fabric.book_packed", "fabric.book_form")
    assert unbound(head * (MOST_CARDS + 1)).key == "fabric.book_many"
    monkeypatch.setattr(signed_card, "_LARGEST_TEXT", 10_000)
    bomb = zstandard.ZstdCompressor().compress(b"x" * 1_000_000)
    assert unbound(bomb).key == "fabric.book_large"
