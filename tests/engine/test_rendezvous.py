"""Stories of two or three runtimes that meet; the datagrams between them are handed over by the test."""

from itertools import permutations

import pytest

from onika.engine.rendezvous import Rendezvous
from onika.engine.rendezvous_orders import (
    AllMet,
    Alone,
    Appoint,
    Confirm,
    HoldNow,
    MeetAgain,
    Permit,
    RepeatStep,
    Revoke,
)
from onika.engine.rendezvous_terms import LATE_NS, RendezvousTerms
from onika.wire.rendezvous import Phase, TagState

MS = 1_000_000
TERMS = RendezvousTerms(MS, MS)
SHIFT = 10**9
"""By how much the clock of a runtime is ahead of that of the one with the next lower number."""


def here(own):
    """The times of others' clocks by that of the runtime `own`."""
    return lambda site, there_ns, _now_ns: there_ns + (own - site) * SHIFT


class Company:
    """Some runtimes and one true time; nobody hears anything but by `hear`."""

    def __init__(self, sites=2):
        self.meetings = [Rendezvous(site, set(range(sites)) - {site}, TERMS, here(site)) for site in range(sites)]
        self.now = 10**12

    def clock(self, site):
        return self.now + site * SHIFT

    def do(self, site, verb, *given):
        return getattr(self.meetings[site], verb)(*given, self.clock(site))

    def hear(self, site, other):
        """What `other` says now comes to `site`."""
        return self.do(site, "hear", other, self.meetings[other].state)

    def talk(self):
        """All hear all, until nothing is new; what each is ordered to do."""
        orders = [[] for _ in self.meetings]
        for _ in range(4):
            for site, other in permutations(range(len(orders)), 2):
                orders[site] += self.hear(site, other)
        return orders

    def phases(self):
        return [meeting.state.phase for meeting in self.meetings]

    def gather(self):
        """All come to the tag and are armed; the time of the beginning."""
        for site in range(len(self.meetings)):
            self.do(site, "come")
        self.talk()
        return self.meetings[0].at_ns

    def commit(self):
        """They are permitted to begin."""
        begin_ns = self.gather()
        self.now = begin_ns - TERMS.commit_ns
        for site in range(len(self.meetings)):
            self.do(site, "look")
        self.talk()
        return begin_ns

    def begin(self, *sites):
        """At the time these begin."""
        self.now = self.commit()
        for site in sites:
            self.do(site, "begun", self.meetings[site].state.attempt)


def test_all_come_commit_themselves_begin_and_go_on():  # R-E04, R-F02, decision 56
    company = Company()
    assert company.do(0, "come") == company.do(1, "come") == []
    assert company.talk() == [[Appoint(1, company.now + TERMS.lead_ns)], [Appoint(1, company.clock(1) + TERMS.lead_ns)]]
    company.now = company.meetings[0].at_ns - TERMS.commit_ns
    assert company.meetings[1].due_ns() == company.clock(1)
    assert (company.do(0, "look"), company.do(1, "look")) == ([], [])
    assert company.talk() == [[Permit(1)], [Permit(1)]]
    company.now = company.meetings[0].at_ns
    assert (company.do(0, "begun", 1), company.do(1, "begun", 1)) == ([], [])
    assert company.talk() == [[Confirm(1), AllMet()], [Confirm(1), AllMet()]]
    assert company.phases() == [Phase.MET, Phase.MET]


def test_nothing_is_proposed_before_all_are_there():
    company = Company(3)
    company.do(0, "come")
    company.do(2, "come")
    assert company.talk() == [[], [], []]
    assert company.meetings[0].absent() == (1,)
    company.do(1, "come")
    assert [len(orders) for orders in company.talk()] == [1, 1, 1]


def test_who_was_not_heard_of_late_is_not_proposed_anything():
    company = Company()
    company.do(0, "come")
    company.do(1, "come")
    company.meetings[0]._heard[1] = (company.now - TERMS.near_ns, company.meetings[1].state)
    assert company.do(0, "look") == []
    company.now -= 1
    assert company.do(0, "look") == [Appoint(1, company.now + TERMS.lead_ns)]


def test_who_hears_of_a_time_too_late_is_not_armed():
    company = Company()
    company.do(0, "come")
    company.do(1, "come")
    company.hear(0, 1)
    company.now = company.meetings[0].at_ns - TERMS.commit_ns
    assert company.hear(1, 0) == []
    company.now -= 1
    assert company.hear(1, 0) == [Appoint(1, company.clock(1) + TERMS.commit_ns + 1)]


def test_nobody_is_armed_who_knows_nothing_of_the_clock_of_who_proposes():
    deaf = Rendezvous(1, [0], TERMS, lambda *_: None)
    deaf.come(5)
    assert deaf.hear(0, TagState(Phase.ARMED, 1, 1, 0, 10**12), 5) == []


@pytest.mark.parametrize("late_ns", [0, LATE_NS])
def test_who_did_not_hear_that_all_are_ready_waits_on_and_that_attempt_is_dead(late_ns):
    company = Company()
    company.do(0, "come")
    company.do(1, "come")
    company.hear(0, 1)
    proposal = company.meetings[0].state
    company.now = company.meetings[0].at_ns - TERMS.commit_ns + late_ns
    assert company.do(0, "look") == [Revoke(1)]
    company.now -= 20 * MS
    assert company.do(1, "hear", 0, proposal) == [Appoint(1, company.clock(1) + TERMS.commit_ns + 20 * MS - late_ns)]
    assert company.talk()[0] == []
    company.now += 21 * MS
    assert company.do(1, "look") == [Revoke(1)]
    assert company.talk()[0] == [Appoint(2, company.now + TERMS.lead_ns)]


def test_nobody_commits_himself_late():
    company = Company()
    company.now = company.gather() - TERMS.commit_ns + LATE_NS
    assert company.do(0, "look") == []
    company.now += 1
    assert company.do(1, "look") == [Revoke(1)]
    assert company.phases() == [Phase.COMMITTED, Phase.WAIT]
    assert company.talk() == [[], []]


def test_who_hears_that_another_does_not_commit_himself_is_not_permitted():
    company = Company()
    company.commit()
    company.do(1, "leave")
    company.do(1, "missed", 1)
    assert company.hear(0, 1) == [Revoke(1)]
    assert company.do(0, "missed", 1) == []
    assert company.phases() == [Phase.WAIT, Phase.AWAY]


def test_who_has_begun_and_hears_that_another_has_not_holds_at_once():  # R-F02
    company = Company()
    company.begin(0)
    company.do(1, "missed", 1)
    assert company.hear(0, 1) == [HoldNow(1), Alone((1,))]
    assert company.do(0, "held", 1) == []


def test_who_hears_nothing_is_held_by_what_began_and_says_for_whom():  # R-F02
    company = Company()
    company.begin(0, 1)
    company.now += TERMS.alone_ns
    assert company.hear(0, 1) == []
    assert company.do(0, "held", 1) == [Alone(())]
    company = Company()
    company.begin(0)
    assert company.do(0, "held", 1) == [Alone((1,))]
    assert company.meetings[0].state.has_begun


def test_what_was_held_though_all_had_begun_repeats_its_step_when_it_is_cleared():  # R-E08
    company = Company()
    company.begin(0, 1)
    company.do(0, "held", 1)
    assert company.hear(1, 0) == [Confirm(1), AllMet()]
    company.hear(0, 1)
    assert company.do(0, "look") == []
    assert company.do(0, "clear") == [RepeatStep(), AllMet()]


def test_what_began_alone_meets_anew_with_another_attempt_when_it_is_cleared():  # R-E08
    company = Company()
    company.begin(0)
    assert company.do(0, "held", 1) == [Alone((1,))]
    assert company.do(0, "clear") == []  # nothing is heard of the other: perhaps it moves
    company.do(1, "missed", 1)
    assert company.hear(0, 1) == [MeetAgain(), Appoint(2, company.now + TERMS.lead_ns)]


def test_a_flow_that_was_let_pass_has_been_there():  # R-E13, reading 26
    company = Company()
    company.do(0, "come")
    assert company.do(0, "let_pass") == []
    company.do(1, "come")
    assert company.hear(1, 0) == [AllMet(is_free=True)]
    assert company.meetings[1].state.phase is Phase.MET


def test_the_others_meet_without_who_was_let_pass():
    company = Company(3)
    company.do(0, "come")
    company.do(0, "let_pass")
    company.do(1, "come")
    company.do(2, "come")
    orders = company.talk()
    assert orders == [
        [],
        [Appoint(1, company.clock(1) + TERMS.lead_ns)],
        [Appoint(1, company.clock(2) + TERMS.lead_ns)],
    ]


def test_who_was_armed_and_is_let_pass_begins_by_himself():
    company = Company()
    company.gather()
    assert company.do(1, "let_pass") == [Revoke(1)]
    assert company.hear(0, 1) == []
    company.now = company.meetings[0].at_ns - TERMS.commit_ns
    assert company.do(0, "look") == [Permit(1)]  # nobody else is needed any more


def test_who_leaves_before_he_is_bound_has_not_been_there():
    company = Company()
    company.gather()
    assert company.do(1, "leave") == [Revoke(1)]
    assert company.meetings[1].state == TagState(Phase.AWAY, 0, 1)
    assert company.hear(0, 1) == []
    company.do(1, "come")
    assert company.hear(1, 0) == []  # that attempt is dead here
    assert company.meetings[1].state.visit == 1


def test_who_leaves_when_he_is_bound_is_held_if_he_has_begun_all_the_same():
    company = Company()
    company.commit()
    assert company.meetings[1].is_bound
    assert company.do(1, "leave") == [Revoke(1)]
    assert company.do(1, "begun", 1) == [HoldNow(1), Alone((0,))]


def test_who_leaves_where_he_is_held_has_been_there():
    company = Company()
    company.begin(0)
    company.do(0, "held", 1)
    assert company.do(0, "leave") == []
    assert company.meetings[0].state.was_passed
    company.do(1, "missed", 1)
    assert company.hear(1, 0) == [AllMet(is_free=True)]


@pytest.mark.parametrize("verb", ["begun", "missed", "held"])
def test_what_is_said_of_an_attempt_that_is_over_changes_nothing(verb):
    company = Company()
    company.gather()
    before = company.meetings[0].state
    assert company.do(0, verb, 1) == []
    company.commit() if verb != "held" else None
    assert company.do(0, verb, 7) == []
    assert before.attempt == 1
