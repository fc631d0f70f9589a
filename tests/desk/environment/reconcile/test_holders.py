from onika.desk.environment.reconcile import holders
from onika.wire import event, steer
from onika.wire.runtime_standing import Standing, SubsystemStanding
from onika.wire.view import HoldView, RuntimeView
from onika.words.reason import NOTHING, Reason


def standing(*subsystems):
    homes = tuple(SubsystemStanding(name, holder, application, ()) for name, holder, application in subsystems)
    return Standing(homes, (), (), False, False, 0.0)


def test_what_was_told_of_a_holder_counts_as_long_as_he_holds_it():  # R-X12
    holds = {"main": HoldView("ann#1", since_at_s=5.0), "gone": HoldView("ann#1")}
    same = holders.surveyed(holds, standing(("main", "ann#1", "")))
    assert same == {"main": HoldView("ann#1", since_at_s=5.0)}
    assert holders.surveyed(holds, standing(("main", "bob#2", ""))) == {"main": HoldView("bob#2")}


def test_who_was_silent_is_remembered_and_who_released_is_not():  # R-X12
    runtime = RuntimeView(holds={"main": HoldView("ann#1", "play", "running")})
    lost = holders.changed(
        runtime, event.Held("main", "", Reason.plain("its holder ann#1 is gone")), "ann#1", 9.0
    ).holds["main"]
    assert (lost.holder, lost.former, lost.was_here, lost.since_at_s) == ("", "ann#1", True, 9.0)
    assert (lost.application, lost.state) == ("play", "running")
    assert (
        not holders.changed(runtime, event.Held("main", "", Reason.plain("gone")), "bob#2", 9.0).holds["main"].was_here
    )
    released = holders.changed(runtime, event.Held("main", ""), "ann#1", 9.0).holds["main"]
    assert (released.former, released.was_here) == ("", False)
    handed = holders.changed(
        runtime, event.Held("main", "bob#2", Reason.plain("ann#1 has handed it over")), "ann#1", 9.0
    )
    assert (handed.holds["main"].former, str(handed.holds["main"].cause)) == ("", "ann#1 has handed it over")


def test_an_offer_ends_at_its_time_or_with_its_outcome():  # R-X12
    runtime = RuntimeView(holds={"main": HoldView("ann#1")})
    offered = holders.offered(runtime, event.Offered("main", "ann#1", "bob#2"), 100.0)
    assert (offered.holds["main"].offered_to, offered.holds["main"].offered_until_s) == ("bob#2", 160.0)
    over = holders.offered(offered, event.Offered("main", "ann#1", "bob#2", Reason.plain("withdrawn")), 101.0)
    assert over.holds["main"] == HoldView("ann#1")
    assert holders.offered(runtime, event.Offered("far", "ann#1", "bob#2"), 1.0) is runtime


def test_where_flows_are_is_told_one_by_one_or_all_together():  # R-X03
    runtime = RuntimeView(holds={"flow0": HoldView(application="play")})
    moved = holders.moved(runtime, event.Moved("flow0", "paused", 1, 1.0))
    assert moved.holds["flow0"].state == "paused"
    assert holders.moved(moved, event.Moved("flow0", "paused", 1, 2.0)) is moved
    assert holders.moved(moved, event.Moved("far", "paused", 1, 2.0)) is moved
    all_ = steer.Positions((steer.Position("flow0", "running", 2), steer.Position("far", "done", 2)))
    assert holders.placed(moved, all_).holds["flow0"].state == "running"


def test_the_flows_of_a_run_are_found_by_one_of_them():  # R-X12
    run = {"a": HoldView("", "play"), "b": HoldView("", "play"), "c": HoldView("x#1", "play"), "d": HoldView()}
    assert holders.flows_with(run, "a") == ("a", "b")
    assert holders.flows_with(run, "d") == ("d",)


ASKED = event.Asked("flow0", "servo", NOTHING, (), 0.5)


def test_what_a_task_of_an_application_asks_is_known_until_it_asks_no_more():  # R-X12, R-C13
    runtime = RuntimeView(holds={"flow0": HoldView("ann#1", "play"), "main": HoldView("ann#1")})
    asks = holders.with_question(runtime, ASKED)
    assert list(asks.holds["flow0"].asks) == ["servo"]
    assert holders.turned(asks, event.TaskState("flow0", "servo", "ASKING", 1.0)) is asks
    lost = holders.changed(asks, event.Held("flow0", "", Reason.plain("gone")), "", 9.0)
    assert list(lost.holds["flow0"].asks) == ["servo"]
    assert holders.turned(lost, event.TaskState("flow0", "servo", "ON", 1.0)).holds["flow0"].asks == {}
    by_hand = event.Asked("main", "servo", NOTHING, (), 0.5)
    assert holders.with_question(runtime, by_hand) is runtime


def test_whoever_comes_later_is_told_what_is_asked_and_what_a_loss_means():  # R-X12
    home = SubsystemStanding("flow0", "ann#1", "play", (), (ASKED,), "finish")
    there = Standing((home,), (), (), False, False, 0.0)
    holds = holders.surveyed({}, there)
    assert (list(holds["flow0"].asks), holds["flow0"].on_loss) == (["servo"], "finish")
    again = holders.surveyed(holds, there)
    assert again["flow0"].asks["servo"] is holds["flow0"].asks["servo"]  # what is put aside stays aside
    assert holders.surveyed(again, standing(("flow0", "ann#1", "")))["flow0"].asks == {}
