from datetime import date

import pytest

from kit.fabric.announced_site import TODAY, AnnouncedSite, believed, signer
from onika.fabric.address_book import AcquaintedSite, AddressBook
from onika.fabric.listing import SHOWN, CardJudge, entered, remembered
from onika.fabric.signed_card import glance
from onika.words.reason import Reason

BOOK = AddressBook().trusting("cmu", signer("a"))


def standings(cards, book=BOOK):
    return [(entry.card.name, entry.signer[7], entry.standing) for entry in entered(cards, book, TODAY)]


def test_a_site_is_known_by_the_key_that_was_trusted():  # R-F06
    assert standings([believed("cmu", "a"), believed("mit", "m")]) == [("cmu", "a", "known"), ("mit", "m", "new")]


def test_two_sites_of_one_name_are_both_shown_and_neither_is_taken_for_the_other():  # R-F06
    cards = [believed("mit", "m"), believed("mit", "n"), believed("cmu", "x"), believed("cmu", "a")]
    assert standings(cards) == [
        ("cmu", "a", "known"),
        ("cmu", "x", "other_key"),
        ("mit", "m", "namesake"),
        ("mit", "n", "namesake"),
    ]


def test_a_key_that_changed_is_told_unless_the_former_announced_it():  # R-F06
    assert standings([believed("cmu", "b")]) == [("cmu", "b", "other_key")]
    announced = remembered(BOOK, entered([believed("cmu", "a", next_key=signer("b"))], BOOK, TODAY))
    assert standings([believed("cmu", "b", 1001)], announced) == [("cmu", "b", "known")]
    rolled = remembered(announced, entered([believed("cmu", "b", 1001)], announced, TODAY))
    assert standings([believed("cmu", "a", 1002)], rolled) == [("cmu", "a", "other_key")]


def test_an_older_card_and_one_that_is_overdue_count_no_more():  # R-F06
    seen = BOOK.having_seen(AcquaintedSite("cmu", signer("a"), 1001))
    assert standings([believed("cmu", "a", 1000)], seen) == [("cmu", "a", "older")]
    assert standings([believed("cmu", "a", 1002, until=date(2026, 11, 23))], seen) == [("cmu", "a", "overdue")]
    assert remembered(seen, entered([believed("cmu", "a", 1000)], seen, TODAY)) == seen


def test_of_several_cards_of_a_site_the_newest_counts():  # R-F06
    (entry,) = entered([believed("cmu", "a", 3), believed("cmu", "a", 9), believed("cmu", "a", 5)], BOOK, TODAY)
    assert entry.card.serial == 9


class Judging:
    """Judges by a glance, so many a look, and counts."""

    def __init__(self, bad=()):
        self.bad, self.judged, self.left = bad, [], 0
        self.judge = CardJudge(self.opens)

    def opens(self, content):
        self.judged.append(content)
        return Reason.of("store.signature_bad") if content in self.bad else glance(content)

    def look(self, contents, book=BOOK, most=10_000):
        self.left = most
        return self.judge.listing(contents, book, TODAY, self.has_time)

    def has_time(self):
        self.left -= 1
        return self.left >= 0


@pytest.fixture(scope="module")
def sites(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sites")
    return [AnnouncedSite(folder, name) for name in ("cmu", "mit")]


def test_bad_signatures_and_what_is_no_card_are_counted_and_left_out(sites):  # R-F06
    good, bad = sites[0].card(), sites[1].card()
    listing = Judging(bad=(bad,)).look([good, bad, b"noise", good])
    assert [entry.card.name for entry in listing.entries] == ["cmu"]
    assert (listing.bad, listing.unjudged) == (2, 0)


def test_a_card_is_judged_once_and_a_flood_bit_by_bit_with_known_sites_first(sites):  # R-F06
    cmu, mit = sites
    flood = [mit.card(serial=number) for number in range(2000, 2008)]
    judging = Judging()
    book = AddressBook().trusting("cmu", cmu.signer)
    first = judging.look([*flood, cmu.card()], book, most=3)
    assert [entry.standing for entry in first.entries] == ["known", "new"]
    assert first.unjudged == 6
    second = judging.look([*flood, cmu.card()], book)
    assert second.unjudged == 0
    assert len(judging.judged) == len(set(judging.judged)) == 9


def test_no_more_is_listed_than_somebody_looks_through():  # R-F06
    contents = [str(number).encode() for number in range(SHOWN + 5)]
    judge = CardJudge(lambda content: believed(f"s{content.decode()}", "a"))
    judge._judged = {}
    listing = judge.listing(contents, AddressBook(), TODAY, lambda: True)
    assert (len(listing.entries), listing.bad) == (0, SHOWN + 5)  # none of them is a card
    many = entered([believed(f"s{number}", "a") for number in range(SHOWN + 5)], AddressBook(), TODAY)
    assert len(many) == SHOWN + 5
