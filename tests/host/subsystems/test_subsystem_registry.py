import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import live_edits_with_tasks
from kit.worlds.rail_world import rail_tasks
from onika.runtime import command, news
from onika.wire import event, live, request
from onika.words.reason import Reason


@pytest.fixture
def hand():
    return live_edits_with_tasks(("rt0", "rt1"), counter="rt1")


@pytest.fixture
def subsystems(hand):
    return hand.asker.program.subsystems


def perform(hand, *goals, **begin):
    hand.shop = rail_tasks()
    plan = hand.shop.plan([action("mass", "servo", arguments=goal) for goal in goals])
    hand.asker.ask(request.Prepare(plan, ()))
    return hand.asker.ask(request.Begin(**begin))


def test_the_clock_stands_where_nothing_wants_it_to_go_on(hand, subsystems):  # law 15
    hand.change(spawn=["counter"], on=["counter"])
    hand.work()
    assert hand.driver.now == 0
    assert not subsystems.is_moving
    hand.let_pass(0.5)
    assert hand.driver.now == 500_000_000
    assert not subsystems.is_moving


def test_seconds_are_let_pass_for_several_who_ask_at_once(hand):  # law 15
    first, second = hand.asker.send(live.Advance(1.0)), hand.asker.send(live.Advance(0.5))
    hand.asker.program.advance(10**9)
    assert hand.asker.server.replies[first] == hand.asker.server.replies[second] == request.Done()
    assert hand.driver.now == 10**9


def test_the_clock_stands_while_an_application_asks(hand, subsystems):  # law 15
    perform(hand, "", may_ask=True)
    hand.work()
    assert subsystems.is_asking
    ticket = hand.asker.send(live.Advance(1.0))
    hand.work()
    assert ticket not in hand.asker.server.replies
    hand.asker.ask(request.Reply("flow0", "servo", "1.0"))
    hand.work()
    assert hand.asker.server.replies[ticket] == request.Done()


def test_two_applications_and_a_hand_live_side_by_side(hand, subsystems):  # R-A06
    hand.change(spawn=["counter"], on=["counter"])
    assert perform(hand, "1.0") == request.Done()
    hand.asker.to_the_end()
    assert subsystems.runs == []
    assert hand.states == {"counter": "ON"}
    assert hand.values("X", subsystem="flow0")["X"][0] == pytest.approx(1.0, abs=0.05)
    assert hand.values("COUNT")["COUNT"] > 10


def test_a_subsystem_is_made_anew_for_each_run_and_by_hand(hand, subsystems):  # law 4
    perform(hand, "1.0")
    hand.asker.to_the_end()
    first = subsystems.tables["flow0"]
    perform(hand, "1.0")
    hand.asker.to_the_end()
    assert subsystems.tables["flow0"] is not first
    hand.shop = rail_tasks()
    assert hand.change(spawn=["mass"], subsystem="flow0") == ""
    assert hand.values("FORCE", subsystem="flow0")["FORCE"] == 0.0


def test_a_unit_that_is_lost_is_told_to_everybody_and_takes_its_tasks_along(hand, subsystems):  # R-E10
    hand.change(spawn=["counter", "source"], on=["counter", "source"])
    hand.driver.lose("rt1")
    assert subsystems.lost_units == {"rt1": Reason.plain("processing unit rt1 was lost")}
    assert (
        "",
        "",
        event.Lost("rt1", Reason.plain("processing unit rt1 was lost"), 0.0),
    ) in hand.asker.server.deliveries
    killed = [message for message in hand.asker.of(event.TaskState) if message.state == "KILLED"]
    assert [message.task for message in killed] == ["counter"]
    assert hand.states == {"source": "ON"}
    assert hand.change(off=["source"]) == ""


def test_a_unit_that_is_lost_ends_the_application_that_needs_it(hand):  # R-E10
    perform(hand, "5.0")
    hand.asker.send(live.Advance(0.2))
    hand.asker.program.advance(1)
    hand.driver.lose("rt0")
    result = hand.asker.to_the_end()
    assert (result.completed, str(result.cause)) == (False, "processing unit rt0 was lost")


def test_the_device_server_is_lost_without_the_tasks(hand, subsystems):  # law 17
    hand.change(spawn=["counter"], on=["counter"])
    subsystems.lost("", Reason.plain("the device server was lost"), 5)
    assert hand.asker.of(event.Lost) == [event.Lost("device server", Reason.plain("the device server was lost"), 5e-9)]
    assert hand.states == {"counter": "ON"}
    assert subsystems.lost_units == {}


def test_a_task_is_put_on_the_unit_it_names_or_on_one_that_lives(subsystems):  # reading 12
    assert (subsystems.unit("rt1"), subsystems.unit("unknown")) == ("rt1", "rt0")
    subsystems.lost("rt0", Reason.plain("gone"), 0)
    assert (subsystems.unit("rt0"), subsystems.unit("unknown")) == ("rt0", "rt1")
    assert [str(subsystems.gone(unit)) for unit in ("rt0", "rt1", "unknown")] == ["gone", "", ""]


def test_loads_are_not_asked_for_in_virtual_time(hand):  # law 14
    hand.change(spawn=["counter"], on=["counter"])
    hand.let_pass(3.0)
    assert not any(isinstance(order, command.Load) for _, order in hand.driver.commands)


def test_words_of_nobody_are_told_to_nobody(hand, subsystems):
    before = list(hand.asker.server.events)
    for word in (news.Changed("s9", "x", "ON", 1), news.Got("s9", "x", "y", 1), news.Initialised("s0", "x")):
        subsystems.hear("rt0", word, 1)
    assert hand.asker.server.events == before


def test_an_event_of_a_subsystem_is_heard_by_its_listeners_and_its_holder(hand):  # R-X12
    hand.change(spawn=["counter"], session="one")
    receivers = {
        (where, who) for where, who, message in hand.asker.server.deliveries if isinstance(message, event.TaskState)
    }
    assert receivers == {("s0", "one")}


def test_a_drive_is_told_in_the_time_of_the_run_that_uses_it(hand, subsystems):  # law 24
    hand.let_pass(0.5)
    assert perform(hand, "1.0") == request.Done()
    result = hand.asker.to_the_end()
    drives = hand.asker.of(event.Drive)
    assert [drive.state for drive in drives] == ["DRIVEN", "HELD"]
    assert drives[-1].at_s == pytest.approx(result.runtime_s) and drives[0].at_s < 0.1
    assert subsystems.run_began("yard:m0") == 0  # nobody uses it any more
