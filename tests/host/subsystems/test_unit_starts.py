import pytest

from kit.runtime.live_edits import live_edits_with_tasks
from onika.host.subsystems.unit_starts import MOST_UNITS
from onika.wire import event, live, request
from onika.words.reason import Reason


@pytest.fixture
def hand():
    return live_edits_with_tasks(("rt0", "rt1"), counter="rt1")


def units_of(hand):
    return {unit.name: unit.is_lost for unit in hand.asker.ask(live.Survey()).rtpus}


def refused(key, **about):
    return request.Refused(Reason.of(key, **about))


def test_a_unit_is_added_while_others_work_and_is_told_to_everybody(hand):  # R-A06
    hand.change(spawn=["counter"], on=["counter"])
    assert hand.asker.ask(live.AddUnit("rt2")) == request.Done()
    assert units_of(hand) == {"rt0": False, "rt1": False, "rt2": False}
    assert ("", "", event.UnitUp("rt2", 0.0)) in hand.asker.server.deliveries
    assert hand.states == {"counter": "ON"}
    assert set(hand.asker.ask(live.Status()).loads) == {"rt0", "rt1", "rt2"}


def test_a_lost_unit_is_started_anew_and_empty_and_its_tasks_may_be_spawned_again(hand):  # R-E10, laws 17, 30
    hand.change(spawn=["counter"], on=["counter"])
    hand.driver.lose("rt1")
    assert hand.change(spawn=["counter"])
    assert hand.asker.ask(live.AddUnit("rt1")) == request.Done()
    assert units_of(hand) == {"rt0": False, "rt1": False}
    hand.let_pass(0.1)
    assert hand.states == {}
    assert hand.change(spawn=["counter"], on=["counter"]) == ""
    hand.let_pass(0.5)
    assert hand.values("COUNT")["COUNT"] > 10


def test_a_unit_that_lives_a_name_that_is_none_and_a_ninth_unit_are_refused(hand):  # R-A06
    assert hand.asker.ask(live.AddUnit("rt1")) == refused("host.unit_lives", name="rt1")
    for name in ("", "2", "--fifo", "a b", "a/b", "a" * 201):
        assert hand.asker.ask(live.AddUnit(name)) == refused("host.unit_misnamed", name=name)
    for number in range(2, MOST_UNITS):
        assert hand.asker.ask(live.AddUnit(f"rt{number}")) == request.Done()
    assert hand.asker.ask(live.AddUnit("more")) == refused("host.units_many", most=MOST_UNITS)
    hand.driver.lose("rt3")
    assert hand.asker.ask(live.AddUnit("rt3")) == request.Done()


def test_what_is_being_started_is_not_started_twice_and_what_did_not_start_stays_lost(hand, monkeypatch):  # R-E10
    hand.driver.lose("rt1")
    waiting = []
    monkeypatch.setattr(hand.driver, "add_unit", lambda name, answer: waiting.append(answer))
    ticket = hand.asker.send(live.AddUnit("rt1"))
    assert hand.asker.ask(live.AddUnit("rt1")) == refused("host.unit_starts", name="rt1")
    assert ticket not in hand.asker.server.replies
    waiting.pop()(Reason.plain("no memory"))
    assert hand.asker.server.replies[ticket] == request.Refused(Reason.plain("no memory"))
    assert units_of(hand) == {"rt0": False, "rt1": True}
    hand.asker.send(live.AddUnit("rt1"))
    assert len(waiting) == 1


def test_who_only_watches_adds_no_unit(hand):  # R-X12
    hand.asker.program.authority.watching.add("eve")
    assert hand.asker.ask(live.AddUnit("rt2"), "eve") == refused("host.watches_only")
    assert set(units_of(hand)) == {"rt0", "rt1"}
