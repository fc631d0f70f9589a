import pytest

from onika.engine.rendezvous_terms import RendezvousTerms

MS = 1_000_000


@pytest.mark.parametrize(
    ("one_way", "clock", "alone", "lead"), [(0, 0, 80, 180), (0.5, 0.5, 81.75, 183.25), (100, 100, 430, 830)]
)
def test_who_is_alone_is_held_after_a_time_that_follows_from_the_way(one_way, clock, alone, lead):  # docs/safety.md
    terms = RendezvousTerms(int(one_way * MS), int(clock * MS))
    assert (terms.alone_ns / MS, terms.commit_ns / MS, terms.lead_ns / MS) == (alone, alone, lead)


def test_who_was_not_heard_for_three_ways_and_four_reports_is_not_near():
    assert RendezvousTerms(10 * MS, 0).near_ns == 110 * MS
