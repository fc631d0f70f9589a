import pytest

from onika.desk.joined.meeting_links import link, note
from onika.desk.plan.plan_parts import PlanPart
from onika.wire.plan import Do, Halt, Meet, Plan, PlannedFlow
from onika.wire.rendezvous_link import Linked, LinkRuntimes, MeetingTerms, OfferPact, PactOffered, SharedTag, Way
from onika.wire.request import Refused
from onika.words.reason import Reason

PROGRAM = (Meet("x"), Do(0), Halt())
PARTS = [PlanPart(Plan("a", (PlannedFlow(f"flow{site}", (), (), PROGRAM),), ()), (site,)) for site in range(2)]
TITLES = ("ws://a", "ws://b")


class Runtimes:
    """They offer pacts and answer as the test wants."""

    def __init__(self, *linked):
        self.asked, self.linked = [], linked

    def ask(self, asked):
        self.asked.append(list(asked))
        if isinstance(asked[0], OfferPact):
            return [PactOffered(5000 + site, bytes(8), bytes(32), 70 + site) for site in range(len(asked))]
        return list(self.linked)


def linked(trip_ns, clock_ns, refusal=""):
    return Linked((Way(0, trip_ns, clock_ns),), Reason.plain(refusal) if refusal else Linked(()).refusal)


def test_pacts_are_handed_round_and_the_worst_way_says_the_terms(monkeypatch):  # R-F02
    runtimes = Runtimes(linked(4_000_000, 2_000_000), linked(6_000_000, 1_000_000))
    assert link(PARTS, TITLES, ["127.0.0.1", "localhost"], runtimes.ask) == MeetingTerms(3_000_000, 3_500_000)
    offers, (first, second) = runtimes.asked
    assert offers == [OfferPact("127.0.0.1")] * 2
    assert isinstance(first, LinkRuntimes)
    assert first.run == second.run
    assert first.tags == (SharedTag("x", (0, 1)),)
    assert [(partner.site, partner.host, partner.port, partner.epoch) for partner in first.partners] == [
        (1, "127.0.0.1", 5001, 71)
    ]
    assert second.partners[0].title == "ws://a"


def test_runtimes_of_other_machines_are_heard_at_every_address():
    runtimes = Runtimes(linked(1, 1), linked(1, 1))
    link(PARTS, TITLES, ["198.51.100.7", "198.51.100.8"], runtimes.ask)
    assert runtimes.asked[0][0].host == "0.0.0.0"
    assert runtimes.asked[1][0].partners[0].host == "198.51.100.8"


@pytest.mark.parametrize("answer", [linked(1, 1, "unheard"), Refused(Reason.plain("unheard"))])
def test_who_cannot_meet_is_named_with_the_reason(answer):
    reason = link(PARTS, TITLES, ["::1", "::1"], Runtimes(linked(1, 1), answer).ask)
    assert str(reason) == "flows cannot meet: ws://b: unheard"


def test_a_runtime_that_gives_no_pact_is_named():
    refused = [Refused(Reason.plain("in virtual time")), PactOffered(1, b"", b"", 1)]
    assert "ws://a: in virtual time" in str(link(PARTS, TITLES, ["::1", "::1"], lambda _asked: refused))


def test_the_terms_are_said():
    said = str(note(MeetingTerms(1_000_000, 2_000_000), TITLES))
    assert "clocks are judged to 2.0 ms" in said
    assert "held after 86 ms at most" in said
