import pytest

from onika.testing.hand import hand_with_tasks
from onika.testing.rail import MASS, SERVO, rail
from onika.testing.workshop import action
from onika.wire import event, live, request


@pytest.fixture
def hand():
    return hand_with_tasks()


def held(hand):
    return [(one.subsystem, one.holder) for one in hand.asker.of(event.Held)]


def leave(hand, session):
    hand.asker.gate.gone.append(session)
    hand.asker.program.serve()
    hand.work()


def perform(hand, session="me", on_loss="stop", goals=("5.0",)):
    hand.shop = rail()
    plan = hand.shop.plan([action("mass", "servo", arguments=goal) for goal in goals])
    hand.asker.ask(request.Prepare(plan, ()), session)
    return hand.asker.ask(request.Begin(on_loss=on_loss), session)


def test_who_changes_a_subsystem_first_holds_it(hand):  # R-X12
    hand.change(spawn=["counter"], session="one")
    assert held(hand) == [("s0", "one")]
    assert "held by one" in hand.change(on=["counter"], session="two")
    assert hand.states == {"counter": "OFF"}


def test_a_refused_change_makes_nobody_a_holder(hand):  # R-X12
    hand.change(kill=["no"], session="one")
    assert held(hand) == []
    assert hand.change(spawn=["counter"], session="two") == ""


@pytest.mark.parametrize(
    "asked",
    [
        live.Change("s0", off=("counter",)),
        live.Clear("s0", "counter"),
        live.Reinit("s0", "counter"),
        live.Set("s0", "counter", "X", "1"),
        live.Close("s0"),
        live.Release("s0"),
        live.Take("s0"),
        request.Reply("s0", "counter", "1"),
    ],
    ids=lambda one: type(one).__name__,
)
def test_what_changes_a_subsystem_is_for_its_holder(hand, asked):  # R-X12
    hand.change(spawn=["counter"], on=["counter"], session="one")
    before = hand.standing()
    answer = hand.asker.ask(asked, "two")
    assert isinstance(answer, request.Refused)
    assert "held by one" in answer.reason
    assert hand.standing() == before


def test_everybody_looks(hand):  # R-X12
    hand.change(spawn=["counter"], on=["counter"], session="one")
    for asked in (live.Survey(), live.Read("s0"), live.Status(), live.Check("s0"), live.Get("s0", "counter", "X")):
        answer = hand.asker.ask(asked, "two")
        assert "held by" not in str(answer)


def test_a_subsystem_is_handed_over(hand):  # R-X12
    hand.change(spawn=["counter"], on=["counter"], session="one")
    assert hand.asker.ask(live.Release("s0"), "one") == request.Done()
    assert hand.states == {"counter": "ON"}
    assert hand.asker.ask(live.Take("s0"), "two") == request.Done()
    assert held(hand) == [("s0", "one"), ("s0", ""), ("s0", "two")]
    assert "held by two" in hand.change(off=["counter"], session="one")
    assert hand.change(off=["counter"], session="two") == ""


def test_taking_what_one_holds_tells_nobody(hand):
    hand.asker.ask(live.Take("s0"), "one")
    hand.asker.ask(live.Take("s0"), "one")
    assert held(hand) == [("s0", "one")]


def test_an_empty_subsystem_that_nobody_holds_is_no_more(hand):  # R-A06
    hand.asker.ask(live.Take("s0"), "one")
    hand.asker.ask(live.Release("s0"), "one")
    hand.asker.ask(live.Take("s1"), "one")
    leave(hand, "one")
    assert hand.asker.ask(live.Survey()).subsystems == ()
    assert hand.asker.program.stage.tables == {}


def test_a_holder_that_is_gone_leaves_its_tasks_off_and_its_subsystem_free(hand):  # R-X12
    hand.change(spawn=["counter", "source"], on=["counter"], session="one")
    hand.change(spawn=["counter"], on=["counter"], session="two", subsystem="s1")
    leave(hand, "one")
    assert hand.states == {"counter": "OFF", "source": "OFF"}
    assert hand.asker.states("s1") == {"counter": "ON"}
    assert not any(one.is_wanted_on for one in hand.standing().values())
    assert hand.change(on=["counter"], session="two") == ""


def test_hardware_of_a_holder_that_is_gone_holds(hand):  # R-X12, law 17
    hand.shop = rail()
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")], session="one")
    hand.let_pass(0.2)
    leave(hand, "one")
    hand.asker.ask(live.Advance(0.5), "two")
    there = hand.values("X")["X"]
    hand.asker.ask(live.Advance(0.5), "two")
    assert hand.values("X")["X"] == there
    assert hand.states == {"mass": "OFF", "servo": "OFF"}


def test_a_holder_that_goes_in_the_midst_of_its_change_leaves_everything_off(hand):  # R-X12
    ticket = hand.asker.send(hand.order(("counter", "source"), ("counter", "source")), "one")
    leave(hand, "one")
    assert hand.edited(hand.asker.gate.replies[ticket].number) == [""]
    assert set(hand.states.values()) == {"OFF"}


def test_everybody_stops_and_only_a_holder_lets_go_on(hand):  # law 27
    hand.change(spawn=["counter"], on=["counter"], session="one")
    assert hand.asker.ask(request.Stop("enough"), "two") == request.Done()
    assert hand.states == {"counter": "OFF"}
    assert "reset it first" in hand.change(on=["counter"], session="one")
    assert "only a holder (one)" in hand.outcome(hand.asker.ask(live.Reset(), "two"))
    assert hand.asker.ask(live.Reset(), "one") == request.Done()
    assert hand.states == {"counter": "OFF"}
    assert hand.change(on=["counter"], session="one") == ""


def test_where_nobody_holds_anything_everybody_lets_go_on(hand):  # law 27
    hand.asker.ask(request.Stop("enough"), "two")
    assert hand.asker.ask(live.Reset(), "three") == request.Done()


def test_what_is_on_its_way_is_turned_off_while_stopped(hand):  # law 27
    hand.change(spawn=["counter"], on=["counter"])
    hand.asker.ask(request.Stop("enough"))
    assert hand.change(kill=["counter"]) == ""


def test_an_application_does_not_begin_where_others_hold_or_tasks_live(hand):  # law 4, R-X12
    hand.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m1"})
    hand.change(spawn=["counter"], session="one", subsystem="flow0")
    assert "held by one" in perform(hand, "two").reason
    answer = perform(hand, "one")
    assert answer.reason == "subsystem flow0 has tasks already (counter); kill them, or use another subsystem"
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
    assert "session one" in result.cause
    assert perform(hand, "two") == request.Done()


def test_a_run_that_was_begun_to_go_on_goes_on(hand):  # R-X12
    perform(hand, "one", on_loss="run")
    leave(hand, "one")
    assert hand.asker.to_the_end().completed


def test_an_answer_to_an_application_is_for_who_began_it(hand):  # R-X12, law 25
    hand.shop = rail()
    hand.asker.ask(request.Prepare(hand.shop.plan([action("mass", "servo")]), ()), "one")
    hand.asker.ask(request.Begin(may_ask=True), "one")
    hand.work()
    assert "held by one" in hand.outcome(hand.asker.ask(request.Reply("flow0", "servo", "1.0"), "two"))
    assert hand.asker.ask(request.Reply("flow0", "servo", "1.0"), "one") == request.Done()
    assert hand.asker.to_the_end().completed


def test_the_servo_of_one_holder_is_not_answered_by_another(hand):  # R-X12
    hand.shop = rail()
    hand.task("servo", SERVO)
    hand.change(spawn=["mass", "servo"], on=["mass", "servo"], session="one")
    assert "held by one" in hand.outcome(hand.asker.ask(request.Reply("s0", "servo", "1.0"), "two"))
    assert hand.states["servo"] == "ASKING"
