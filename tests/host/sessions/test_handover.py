import pytest

from onika.host.sessions.handover import Offers
from onika.words.reason import Reason

MINUTE_NS = 60_000_000_000
ACCEPTED = Reason.of("host.offer_accepted")


class Told(list):
    def __call__(self, message, subsystem, session):
        self.append((message.subsystem, message.holder, message.to, message.outcome.key, session))
        self.outcome = message.outcome
        assert message.subsystem == subsystem


@pytest.fixture
def notices():
    return Told()


def test_the_one_it_is_for_is_told_and_the_holder_of_the_end(notices):  # R-X12
    offers = Offers(notices)
    offers.put("s0", "one", "two", 0)
    assert offers.find("s0").to == "two"
    offers.end("s0", ACCEPTED)
    assert notices == [("s0", "one", "two", "", "two"), ("s0", "one", "two", "host.offer_accepted", "one")]
    assert offers.find("s0") is None


def test_a_second_offer_takes_the_place_of_the_first(notices):  # R-X12
    offers = Offers(notices)
    offers.put("s0", "one", "two", 0)
    offers.put("s0", "one", "three", 1)
    assert [message[2:4] for message in notices] == [("two", ""), ("two", "host.offer_withdrawn"), ("three", "")]
    assert offers.find("s0").to == "three"


def test_nobody_is_waited_for_for_ever(notices):  # R-X12
    offers = Offers(notices)
    offers.put("s0", "one", "two", 5)
    offers.expire(5 + MINUTE_NS - 1)
    assert offers.find("s0") is not None
    offers.expire(5 + MINUTE_NS)
    assert offers.find("s0") is None
    assert (notices.outcome.key, notices.outcome.text) == ("host.offer_unanswered", "no answer within 60 s")


def test_who_is_gone_neither_offers_nor_takes(notices):  # R-X12
    offers = Offers(notices)
    offers.put("s0", "one", "two", 0)
    offers.put("s1", "two", "three", 0)
    offers.put("s2", "one", "three", 0)
    offers.leave("two")
    assert [offers.find(name) is None for name in ("s0", "s1", "s2")] == [True, True, False]
    assert notices.outcome == Reason.of("host.offer_deserted", session="two")


def test_the_end_of_what_is_not_offered_is_no_news(notices):
    Offers(notices).end("s0", ACCEPTED)
    assert notices == []


@pytest.mark.parametrize("late_ns", [0, 1, MINUTE_NS])
def test_an_offer_lasts_a_minute_from_when_it_was_made(notices, late_ns):  # R-X12
    offers = Offers(notices)
    offers.put("s0", "one", "two", MINUTE_NS)
    offers.expire(2 * MINUTE_NS - 1)
    assert offers.find("s0") is not None
    offers.expire(2 * MINUTE_NS + late_ns)
    assert offers.find("s0") is None
