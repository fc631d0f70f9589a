"""Offers of what one holds, by themselves: made, taken, declined, withdrawn, ended with their time (law 27)."""

import pytest

from kit.runtime.authority_bench import AuthorityBench, LiveFake
from onika.wire import event, holding, request
from onika.words.reason import Reason

MINUTE_NS = 60_000_000_000


@pytest.fixture
def bench():
    return AuthorityBench()


def test_only_what_one_holds_can_be_handed_over(bench):  # R-X12
    assert bench.hand("one", "two") == request.Refused(Reason.of("host.hand_free", subsystem="s0"))
    bench.take("one")
    held = request.Refused(Reason.of("host.hand_held", subsystem="s0", holder="one"))
    assert bench.hand("two", "ann#1") == held


def test_an_offer_is_withdrawn_by_who_made_it(bench):  # R-X12
    bench.take("one")
    nobody = request.Refused(Reason.of("host.offered_nobody", subsystem="s0"))
    assert bench.hand("one", "") == nobody
    bench.hand("one", "two")
    bench.keys()
    assert bench.hand("one", "") == request.Done()
    assert bench.keys() == [("s0", "one", "host.offer_withdrawn")]
    assert bench.hand("one", "") == nobody


def test_an_offer_that_is_taken_makes_another_holder(bench):  # R-X12
    bench.take("one")
    assert bench.hand("one", "two") == request.Done()
    bench.messages.clear()
    assert bench.take("two") == request.Done()
    assert bench.messages[-1] == (event.Held("s0", "two", Reason.of("host.handed_over", holder="one")), "s0", "two")
    assert bench.keys()[0] == ("s0", "one", "host.offer_accepted")
    assert bench.subsystems.live["s0"].holder == "two"


def test_an_offer_is_for_who_it_was_made_for(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two")
    bench.keys()
    nobody = request.Refused(Reason.of("host.offers_nobody", subsystem="s0"))
    assert bench.authority.decline("ann#1", holding.Decline("s0")) == nobody
    assert bench.take("ann#1") == request.Refused(Reason.of("host.held_by", subsystem="s0", holder="one"))
    assert bench.authority.decline("two", holding.Decline("s0")) == request.Done()
    declined = Reason.of("host.offer_declined", session="two")
    assert bench.messages == [(event.Offered("s0", "one", "two", declined), "s0", "one")]
    assert bench.authority.decline("two", holding.Decline("s0")) == nobody


def test_an_offer_ends_with_its_time(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two", wall_ns=5)
    bench.keys()
    bench.authority.expire(5 + MINUTE_NS - 1)
    assert bench.keys() == []
    bench.authority.expire(5 + MINUTE_NS)
    assert bench.keys() == [("s0", "one", "host.offer_unanswered")]


def test_an_offer_of_who_holds_it_no_more_is_worth_nothing(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two")
    bench.subsystems.live["s0"].holder = "ann#1"
    bench.keys()
    assert bench.take("two") == request.Refused(Reason.of("host.held_by", subsystem="s0", holder="ann#1"))
    assert bench.keys() == [("s0", "one", "host.offer_overtaken")]


@pytest.mark.parametrize(
    ("to", "reason"),
    [
        ("ann", Reason.of("host.handed_to", names=("ann#1", "ann#2"), to="ann")),
        ("bob", Reason.of("host.handed_to", names=("two", "ann#1", "ann#2"), to="bob")),
        ("one", Reason.of("host.handed_to", names=("two", "ann#1", "ann#2"), to="one")),
    ],
)
def test_who_is_meant_has_to_be_one_and_another(bench, to, reason):  # R-X12
    bench.take("one")
    assert bench.hand("one", to) == request.Refused(reason)


def test_a_session_is_meant_by_its_name_before_others_by_their_user(bench):  # R-X12
    bench.standings.append(holding.SessionStanding("ann", "operator"))
    bench.take("one")
    assert bench.hand("one", "ann") == request.Done()
    assert bench.messages[-1] == (event.Offered("s0", "one", "ann"), "s0", "ann")


def test_a_user_with_one_session_is_meant_by_his_name(bench):  # R-X12
    bench.standings[2:] = [
        holding.SessionStanding("ann#1", "operator", is_here=False),
        holding.SessionStanding("ann#2", "operator"),
    ]
    bench.take("one")
    assert bench.hand("one", "ann") == request.Done()
    assert bench.messages[-1][0].to == "ann#2"


@pytest.mark.parametrize("standing", [{"role": "viewer"}, {"role": "operator", "only_watches": True}])
def test_nothing_is_handed_to_who_takes_nothing(bench, standing):  # R-X12
    bench.standings.append(holding.SessionStanding("eve", **standing))
    bench.take("one")
    assert bench.hand("one", "eve") == request.Refused(Reason.of("host.takes_nothing", name="eve"))


def test_who_is_alone_hands_to_nobody(bench):  # R-X12
    del bench.standings[1:]
    bench.take("one")
    assert bench.hand("one", "two") == request.Refused(Reason.of("host.handed_alone", to="two"))


def test_who_is_gone_offers_nothing_and_is_offered_nothing(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two")
    bench.keys()
    bench.authority.lost("two", 9)
    assert bench.keys() == [("s0", "one", "host.offer_deserted")]


def test_a_run_is_handed_over_with_all_its_subsystems_and_what_was_offered_of_them(bench):  # R-X12
    run = bench.runs("one", "flow0", "flow1")
    bench.hand("one", "ann#1", "flow0")
    bench.hand("one", "two", "flow1")
    bench.messages.clear()
    assert bench.take("two", "flow1") == request.Done()
    assert (run.session, bench.subsystems.released) == ("two", ["one"])
    assert bench.keys() == [
        ("flow1", "one", "host.offer_accepted"),
        ("flow0", "one", "host.offer_passed_on"),
        ("flow0", "two", "host.handed_over"),
        ("flow1", "two", "host.handed_over"),
    ]


def test_what_is_given_back_is_offered_to_nobody_any_more(bench):  # R-X12
    bench.subsystems.live["s0"] = LiveFake("one", "t")
    bench.hand("one", "two")
    bench.keys()
    bench.release("one")
    assert bench.keys() == [("s0", "one", "host.offer_released"), ("s0", "one", "")]
