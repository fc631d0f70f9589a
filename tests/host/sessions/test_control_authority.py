import pytest

from kit.runtime.live_edits import live_edits_with_tasks
from kit.runtime.sessions import leave, there
from kit.worlds.rail_world import rail_tasks
from onika.wire import event, holding, live, request, steer
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason


@pytest.fixture
def hand():
    return live_edits_with_tasks()


def held(hand):
    return [(message.subsystem, message.holder) for message in hand.asker.of(event.Held)]


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
    "wish",
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
    ids=lambda wish: type(wish).__name__,
)
def test_what_changes_a_subsystem_is_for_its_holder(hand, wish):  # R-X12
    hand.change(spawn=["counter"], on=["counter"], session="one")
    before = hand.standing()
    answer = hand.asker.ask(wish, "two")
    assert isinstance(answer, request.Refused)
    assert "held by one" in str(answer.reason)
    assert hand.standing() == before


def test_everybody_looks(hand):  # R-X12
    hand.change(spawn=["counter"], on=["counter"], session="one")
    for wish in (live.Survey(), live.Read("s0"), live.Status(), live.Check("s0"), live.Get("s0", "counter", "X")):
        answer = hand.asker.ask(wish, "two")
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
    assert hand.asker.program.subsystems.tables == {}


def test_a_holder_that_is_gone_leaves_its_tasks_off_and_its_subsystem_free(hand):  # R-X12
    hand.change(spawn=["counter", "source"], on=["counter"], session="one")
    hand.change(spawn=["counter"], on=["counter"], session="two", subsystem="s1")
    leave(hand, "one")
    assert hand.states == {"counter": "OFF", "source": "OFF"}
    assert hand.asker.states("s1") == {"counter": "ON"}
    assert not any(task.is_wanted_on for task in hand.standing().values())
    assert hand.change(on=["counter"], session="two") == ""


def test_hardware_of_a_holder_that_is_gone_holds(hand):  # R-X12, law 17
    hand.shop = rail_tasks()
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
    assert hand.edited(hand.asker.server.replies[ticket].number) == [""]
    assert set(hand.states.values()) == {"OFF"}


def test_everybody_stops_and_only_a_holder_lets_go_on(hand):  # law 27
    hand.change(spawn=["counter"], on=["counter"], session="one")
    assert hand.asker.ask(request.Stop(Reason.plain("enough")), "two") == request.Done()
    assert hand.states == {"counter": "OFF"}
    assert "reset it first" in hand.change(on=["counter"], session="one")
    assert "only a holder (one)" in hand.outcome(hand.asker.ask(live.Reset(), "two"))
    assert hand.asker.ask(live.Reset(), "one") == request.Done()
    assert hand.states == {"counter": "OFF"}
    assert hand.change(on=["counter"], session="one") == ""


def test_where_nobody_holds_anything_everybody_lets_go_on(hand):  # law 27
    hand.asker.ask(request.Stop(Reason.plain("enough")), "two")
    assert hand.asker.ask(live.Reset(), "three") == request.Done()


def test_what_is_on_its_way_is_turned_off_while_stopped(hand):  # law 27
    hand.change(spawn=["counter"], on=["counter"])
    hand.asker.ask(request.Stop(Reason.plain("enough")))
    assert hand.change(kill=["counter"]) == ""


def offers(hand):
    return [(message.holder, message.to, str(message.outcome)) for message in hand.asker.of(event.Offered)]


def test_a_subsystem_is_handed_over_while_it_moves(hand):  # R-X12
    there(hand, "two")
    hand.change(spawn=["counter"], on=["counter"], session="one")
    assert hand.asker.ask(holding.Hand("s0", "two"), "one") == request.Done()
    assert hand.change(off=["counter"], session="two").startswith("subsystem s0 is held by one")
    assert hand.asker.ask(live.Take("s0"), "two") == request.Done()
    assert hand.states == {"counter": "ON"}
    assert held(hand) == [("s0", "one"), ("s0", "two")]
    assert offers(hand) == [("one", "two", ""), ("one", "two", "accepted")]
    assert hand.change(off=["counter"], session="one").startswith("subsystem s0 is held by two")


def test_what_is_offered_is_for_the_one_it_is_offered_to(hand):  # R-X12
    there(hand, "two", "three")
    hand.change(spawn=["counter"], session="one")
    hand.asker.ask(holding.Hand("s0", "two"), "one")
    assert str(hand.asker.ask(live.Take("s0"), "three").reason) == "subsystem s0 is held by one"
    assert isinstance(hand.asker.ask(holding.Decline("s0"), "three"), request.Refused)
    assert hand.asker.ask(holding.Decline("s0"), "two") == request.Done()
    assert str(hand.asker.ask(live.Take("s0"), "two").reason) == "subsystem s0 is held by one"
    assert offers(hand)[-1] == ("one", "two", "two declines")


def test_an_offer_is_withdrawn_and_ends_with_either_side(hand):  # R-X12
    there(hand, "two", "three")
    hand.change(spawn=["counter"], session="one")
    for to in ("two", "three"):
        hand.asker.ask(holding.Hand("s0", to), "one")
    hand.asker.ask(holding.Hand("s0"), "one")
    hand.asker.ask(holding.Hand("s0", "two"), "one")
    leave(hand, "two")
    hand.asker.ask(holding.Hand("s0", "three"), "one")
    hand.asker.ask(live.Release("s0"), "one")
    ends = [outcome for _, _, outcome in offers(hand) if outcome]
    assert ends == ["withdrawn", "withdrawn", "two is gone", "it is released"]
    assert isinstance(hand.asker.ask(holding.Hand("s0"), "one"), request.Refused)


@pytest.mark.parametrize(
    ("session", "to", "reason"),
    [
        ("two", "one", "subsystem s0 is held by one; only its holder hands it over"),
        ("one", "nobody", "expected one of those who are there (two), found nobody"),
        ("one", "one", "expected one of those who are there (two), found one"),
        ("one", "two", "two only watches and can take nothing"),
    ],
)
def test_what_cannot_be_handed_over_is_refused_with_the_reason(hand, session, to, reason):  # R-X12
    hand.asker.ask(holding.OnlyWatch() if to == "two" else holding.Sessions(), "two")
    hand.change(spawn=["counter"], session="one")
    assert str(hand.asker.ask(holding.Hand("s0", to), session).reason) == reason


def test_a_user_with_one_session_is_enough_of_a_name(hand):  # R-X12
    there(hand, "ada#2", "bob#3", "bob#4")
    hand.change(spawn=["counter"], session="one")
    assert hand.asker.ask(holding.Hand("s0", "ada"), "one") == request.Done()
    assert "bob#3, bob#4" in str(hand.asker.ask(holding.Hand("s0", "bob"), "one").reason)


def test_who_only_watches_changes_nothing_and_may_stop(hand):  # R-X12, law 27
    assert hand.asker.ask(holding.OnlyWatch(), "two") == request.Done()
    for wish in (
        live.Take("s0"),
        live.Change("s0"),
        live.Reset(),
        request.Abort(Reason.plain("no")),
        steer.Resume("s0"),
    ):
        assert "only watches" in str(hand.asker.ask(wish, "two").reason)
    assert isinstance(hand.asker.ask(live.Survey(), "two"), Standing)
    assert hand.asker.ask(request.Stop(Reason.plain("enough")), "two") == request.Done()


def test_a_holder_releases_before_it_only_watches(hand):  # R-X12
    hand.change(spawn=["counter"], session="one")
    assert "holds s0" in str(hand.asker.ask(holding.OnlyWatch(), "one").reason)
    hand.asker.ask(live.Release("s0"), "one")
    assert hand.asker.ask(holding.OnlyWatch(), "one") == request.Done()
    there_now = hand.asker.ask(holding.Sessions(), "two").sessions
    assert [(session.name, session.only_watches) for session in there_now] == [("one", True), ("two", False)]
