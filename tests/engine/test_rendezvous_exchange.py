from dataclasses import replace

import pytest

from onika.engine.rendezvous_exchange import RendezvousExchange
from onika.engine.rendezvous_orders import Appoint
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.wire.rendezvous import Phase

MS = 1_000_000
TERMS = RendezvousTerms(MS, MS)
RUN, EPOCHS = bytes(16), {0: 70, 1: 71, 2: 72}
TAGS = [(0, 1), (1, 2)]
NOW = 10**9


def exchange(site):
    return RendezvousExchange(RUN, site, EPOCHS, TAGS, TERMS)


@pytest.fixture
def two():
    return exchange(0), exchange(1)


def test_each_takes_part_in_the_meetings_at_its_own_tags():  # R-E04
    assert [sorted(exchange(site).meetings) for site in range(3)] == [[0], [0, 1], [1]]
    assert exchange(1).others == (0, 2)
    report = exchange(0).report(1, NOW)
    assert (report.run, report.epoch, report.site, len(report.tags)) == (RUN, 70, 0, 2)


def test_what_is_heard_comes_to_its_tag(two):
    first, second = two
    second.meetings[0].come(NOW)
    first.meetings[0].come(NOW)
    assert first.hear(1, second.report(0, NOW), NOW) == [(0, Appoint(1, NOW + TERMS.lead_ns))]
    assert first.due_ns() == NOW + TERMS.lead_ns - TERMS.commit_ns
    assert first.look(NOW) == []


def test_what_was_overtaken_counts_no_more(two):
    first, second = two
    old = second.report(0, NOW)
    second.meetings[0].come(NOW)
    first.hear(7, second.report(0, NOW), NOW)
    for count in (7, 6, 1):
        first.hear(count, old, NOW)
    assert first.meetings[0]._of(1).phase is Phase.WAIT
    first.hear(8, old, NOW)
    assert first.meetings[0]._of(1).phase is Phase.AWAY


@pytest.mark.parametrize("wrong", [{"epoch": 1}, {"run": b"x" * 16}, {"site": 0}, {"site": 9}, {"tags": ()}], ids=str)
def test_another_life_another_run_and_strangers_never_count(two, wrong):
    first, second = two
    second.meetings[0].come(NOW)
    first.hear(1, replace(second.report(0, NOW), **wrong), NOW)
    assert first.meetings[0]._of(1).phase is Phase.AWAY
    assert first.silent_ns(1, NOW) is None


def test_clocks_are_learned_from_what_is_echoed(two):
    first, second = two
    ahead = 5 * 10**9
    second.hear(1, first.report(1, NOW), NOW + ahead + MS)
    first.hear(1, second.report(0, NOW + ahead + 2 * MS), NOW + 3 * MS)
    assert first.clock(1).here(NOW + ahead, NOW + 3 * MS) == NOW
    assert first.clock(1).trip_ns(NOW + 3 * MS) == 2 * MS
    assert first.silent_ns(1, NOW + 10 * MS) == 7 * MS


def test_a_time_of_a_clock_that_may_be_misjudged_by_more_than_the_terms_say_is_not_believed(two):
    first, second = two
    first.meetings[0].come(NOW)
    second.meetings[0].come(NOW)
    first.hear(1, second.report(0, NOW), NOW + 5 * MS)
    assert second.hear(1, first.report(1, NOW + 5 * MS), NOW + 10 * MS) == []
    assert second.clock(0).bound_ns(NOW + 10 * MS) > TERMS.clock_ns
    quick_ns = NOW + 10 * MS + 400_000
    first.hear(2, second.report(0, NOW + 10 * MS), quick_ns)
    orders = second.hear(2, first.report(1, quick_ns), quick_ns + 400_000)
    assert [order.attempt for _, order in orders] == [1]


def test_a_stop_is_passed_on(two):  # law 27
    first, second = two
    first.is_stopped = True
    second.hear(1, first.report(1, NOW), NOW)
    assert second.is_stopped
    assert second.report(2, NOW).is_stopped
