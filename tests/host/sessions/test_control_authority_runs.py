"""Applications and who may begin, end and answer them."""

import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import live_edits_with_tasks
from kit.runtime.sessions import leave, there
from kit.worlds.rail_world import MASS, SERVO, rail_tasks
from onika.wire import event, holding, live, request, steer
from onika.words.reason import Reason


@pytest.fixture
def hand():
    return live_edits_with_tasks()


def perform(hand, session="me", on_loss="stop", goals=("5.0",)):
    hand.shop = rail_tasks()
    plan = hand.shop.plan([action("mass", "servo", arguments=goal) for goal in goals])
    hand.asker.ask(request.Prepare(plan, ()), session)
    return hand.asker.ask(request.Begin(on_loss=on_loss), session)


def test_an_application_does_not_begin_where_others_hold_or_tasks_live(hand):  # law 4, R-X12
    hand.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m1"})
    hand.change(spawn=["counter"], session="one", subsystem="flow0")
    assert "held by one" in str(perform(hand, "two").reason)
    answer = perform(hand, "one")
    assert str(answer.reason) == "subsystem flow0 has tasks already (counter); kill them, or use another subsystem"
    assert hand.change(kill=["counter"], session="one", subsystem="flow0") == ""
    assert perform(hand, "one") == request.Done()
    assert hand.asker.to_the_end().completed


def test_a_subsystem_with_an_application_is_not_changed_by_hand(hand):  # R-X12
    perform(hand, "one")
    for session in ("one", "two"):
        assert "application test runs in subsystem flow0" in hand.change(
            spawn=["servo"], session=session, subsystem="flow0"
        )
        assert isinstance(hand.asker.ask(live.Take("flow0"), session), request.Refused)


def test_a_run_ends_with_the_session_that_began_it(hand):  # R-X12, R-E10
    perform(hand, "one")
    hand.asker.send(live.Advance(0.2), "two")
    hand.asker.program.advance(1)
    leave(hand, "one")
    result = hand.asker.to_the_end()
    assert not result.completed
    assert "session one" in str(result.cause)
    assert perform(hand, "two") == request.Done()


def test_a_run_that_was_begun_to_go_on_goes_on(hand):  # R-X12
    perform(hand, "one", on_loss="run")
    leave(hand, "one")
    assert hand.asker.to_the_end().completed


@pytest.mark.parametrize("on_loss", ["stop", "finish", "run"])
def test_a_run_whose_session_is_gone_is_told_to_be_nobodys(hand, on_loss):  # R-X12
    perform(hand, "one", on_loss=on_loss)
    leave(hand, "one")
    message = hand.asker.of(event.Held)[-1]
    assert (message.subsystem, message.holder) == ("flow0", "")
    assert "one that began it is gone" in str(message.cause)
    assert hand.asker.ask(live.Take("flow0"), "two") == request.Done()


def test_one_run_is_ended_by_its_name_and_only_by_who_may(hand):  # R-X12, R-E10
    def abort(subsystem, session):
        ticket = hand.asker.send(request.Abort(Reason.plain("enough"), subsystem), session)
        return hand.asker.server.replies[ticket]

    perform(hand, "one", on_loss="run")
    hand.asker.send(live.Advance(0.2), "two")
    hand.asker.program.advance(1)
    assert "begun by one" in str(abort("flow0", "two").reason)
    assert abort("elsewhere", "one") == request.Done()
    hand.asker.server.gone.append("one")
    hand.asker.program.serve()
    assert abort("flow0", "two") == request.Done()
    hand.asker.to_the_end()
    assert [str(message.cause) for message in hand.asker.of(event.Result)] == ["enough"]


def test_an_answer_to_an_application_is_for_who_began_it(hand):  # R-X12, law 25
    hand.shop = rail_tasks()
    hand.asker.ask(request.Prepare(hand.shop.plan([action("mass", "servo")]), ()), "one")
    hand.asker.ask(request.Begin(may_ask=True), "one")
    hand.work()
    assert "held by one" in hand.outcome(hand.asker.ask(request.Reply("flow0", "servo", "1.0"), "two"))
    assert hand.asker.ask(request.Reply("flow0", "servo", "1.0"), "one") == request.Done()
    assert hand.asker.to_the_end().completed


def test_the_servo_of_one_holder_is_not_answered_by_another(hand):  # R-X12
    hand.shop = rail_tasks()
    hand.task("servo", SERVO)
    hand.change(spawn=["mass", "servo"], on=["mass", "servo"], session="one")
    assert "held by one" in hand.outcome(hand.asker.ask(request.Reply("s0", "servo", "1.0"), "two"))
    assert hand.states["servo"] == "ASKING"


def test_a_run_is_handed_over_and_goes_on(hand):  # R-X12
    there(hand, "two")
    perform(hand, "one")
    hand.asker.send(live.Advance(0.2), "two")
    hand.asker.program.advance(1)
    assert hand.asker.ask(holding.Hand("flow0", "two"), "one") == request.Done()
    hand.asker.ask(live.Take("flow0"), "two")
    assert "was begun by two" in str(hand.asker.ask(steer.Pause("flow0"), "one").reason)
    leave(hand, "one")
    assert hand.asker.to_the_end().completed
