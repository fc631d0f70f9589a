"""Holders that fall silent: what becomes of what they hold."""

import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import live_edits_with_tasks
from kit.runtime.sessions import SECOND, silent
from kit.worlds.rail_world import rail_tasks
from onika.wire import event, live, request, steer


@pytest.fixture
def hand():
    return live_edits_with_tasks()


def held(hand):
    return [(message.subsystem, message.holder) for message in hand.asker.of(event.Held)]


def perform(hand, session="me", on_loss="stop", goals=("5.0",)):
    hand.shop = rail_tasks()
    plan = hand.shop.plan([action("mass", "servo", arguments=goal) for goal in goals])
    hand.asker.ask(request.Prepare(plan, ()), session)
    return hand.asker.ask(request.Begin(on_loss=on_loss), session)


@pytest.fixture
def watched():
    """A hand whose holders have a lease of one second, which a test lets run out."""
    hand = live_edits_with_tasks()
    hand.asker.lease(SECOND)
    return hand


def test_a_holder_that_is_silent_for_its_lease_leaves_everything_off(watched):  # R-X12, network.md D4
    watched.change(spawn=["counter"], on=["counter"], session="one")
    silent(watched, "one", 0.999)
    assert watched.states == {"counter": "ON"}
    silent(watched, "one", 1.0)
    assert watched.states == {"counter": "OFF"}
    assert held(watched)[-1] == ("s0", "")
    assert watched.asker.of(event.Held)[-1].cause.text == "its holder one has been silent for 1.00 s"


def test_hardware_of_a_silent_holder_holds(watched):  # R-X12, law 17
    watched.shop = rail_tasks()
    watched.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")], session="one")
    watched.let_pass(0.2)
    silent(watched, "one", 1.2)
    watched.asker.ask(live.Advance(0.5), "two")
    where = watched.values("X")["X"]
    watched.asker.ask(live.Advance(0.5), "two")
    assert watched.values("X")["X"] == where
    assert watched.states == {"mass": "OFF", "servo": "OFF"}


def test_nothing_moves_again_before_a_holder_that_was_silent_takes_anew(watched):  # R-X12
    watched.change(spawn=["counter"], on=["counter"], session="one")
    silent(watched, "one", 1.5)
    for wish in (live.Change("s0", on=(live.Turn("counter"),)), live.Clear("s0", "counter"), steer.Resume("s0")):
        assert "was not heard for too long" in str(watched.asker.ask(wish, "one").reason)
    assert watched.states == {"counter": "OFF"}
    assert watched.asker.ask(live.Take("s0"), "one") == request.Done()
    assert watched.states == {"counter": "OFF"}
    assert watched.change(on=["counter"], session="one") == ""


def test_what_a_silent_holder_held_may_be_taken_by_another(watched):  # R-X12
    watched.change(spawn=["counter"], on=["counter"], session="one")
    silent(watched, "one", 1.5)
    assert watched.asker.ask(live.Take("s0"), "two") == request.Done()
    assert "held by two" in str(watched.asker.ask(live.Take("s0"), "one").reason)


@pytest.mark.parametrize(("on_loss", "completed"), [("stop", False), ("run", True)])
def test_a_run_depends_on_its_lease_as_it_was_begun(watched, on_loss, completed):  # R-X12, R-E10
    perform(watched, "one", on_loss=on_loss)
    watched.asker.send(live.Advance(0.2), "two")
    watched.asker.program.advance(1)
    silent(watched, "one", 1.5)
    assert watched.asker.to_the_end().completed is completed


def test_a_run_that_paused_for_its_silent_holder_is_anybodys(watched):  # R-X12, R-E10
    perform(watched, "one", on_loss="finish", goals=("5.0", "1.0"))
    watched.asker.send(live.Advance(0.2), "two")
    watched.asker.program.advance(1)
    silent(watched, "one", 1.5)
    assert watched.asker.to_the_end() is None
    assert "was not heard" in str(watched.asker.ask(steer.Resume("flow0"), "one").reason)
    assert watched.asker.ask(live.Take("flow0"), "one") == request.Done()
    assert watched.asker.ask(steer.Resume("flow0"), "one") == request.Done()
    assert watched.asker.to_the_end().completed


def test_a_plan_that_was_prepared_before_the_silence_is_not_begun_after_it(watched):  # R-X12
    watched.asker.ask(live.Take("s1"), "one")
    watched.shop = rail_tasks()
    plan = watched.shop.plan([action("mass", "servo", arguments="5.0")])
    watched.asker.ask(request.Prepare(plan, ()), "one")
    silent(watched, "one", 1.5)
    assert "no plan is prepared" in str(watched.asker.ask(request.Begin(), "one").reason)
    watched.asker.ask(request.Prepare(plan, ()), "one")
    assert watched.asker.ask(request.Begin(), "one") == request.Done()
