from kit.plans.plan_builder import action
from kit.runtime.live_edits import LiveEdits
from kit.worlds.rail_world import rail_tasks
from onika.wire import event, request
from onika.words.reason import Reason


def performed(*goals, session="me", **begin):
    """A hand whose application has begun."""
    hand = LiveEdits()
    hand.shop = rail_tasks()
    plan = hand.shop.plan([action("mass", "servo", arguments=goal) for goal in goals])
    hand.asker.ask(request.Prepare(plan, ()), session)
    hand.asker.ask(request.Begin(**begin), session)
    return hand, hand.asker.program.subsystems.runs[0]


def test_a_run_knows_who_began_it_and_where_it_is():  # R-X12
    _, run = performed("1.0", session="one", on_loss="run")
    assert (run.session, run.application, run.names) == ("one", "test", ("flow0",))
    assert run.on_loss == "run"
    assert set(run.members("flow0")) == {"mass", "servo"}


def test_its_events_are_for_who_began_it_and_for_listeners_of_its_subsystem():  # R-X12
    hand, _ = performed("1.0", session="one")
    hand.asker.to_the_end()
    ours = [message for message in hand.asker.server.deliveries if not isinstance(message[2], event.Drive)]
    assert {(where, who) for where, who, _ in ours if not where.startswith("@")} == {("flow0", "one")}


def test_who_has_lost_it_by_being_silent_hears_how_it_ends():  # R-X12
    hand, run = performed("1.0", session="one")
    run.abandon(Reason.of("host.holder_silent", session="one", seconds=0.25), 0)
    assert run.session == ""
    hand.asker.to_the_end()
    (result,) = [one for one in hand.asker.server.deliveries if isinstance(one[2], event.Result)]
    assert result[1] == "one" and "has been silent" in str(result[2].cause)


def test_who_takes_it_over_hears_it_from_then_on():  # R-X12
    hand, run = performed("1.0", session="one")
    run.pass_on("two")
    hand.asker.to_the_end()
    assert {who for _, who, told in hand.asker.server.deliveries if isinstance(told, event.Result)} == {"two"}


def test_its_result_is_told_once_and_last():  # R-E14
    hand, run = performed("1.0", "2.0")
    assert not run.is_through(lambda: True)
    result = hand.asker.to_the_end()
    assert hand.asker.of(event.Result) == [result]
    assert (result.done, result.of, result.completed) == (2, 2, True)
    assert hand.asker.program.subsystems.runs == []


def test_it_is_through_only_when_every_drive_holds():  # law 17
    _, run = performed("1.0")
    run.runner.is_over = True
    assert not run.is_through(lambda: False)
    assert run.is_through(lambda: True)


def test_its_result_names_its_tasks_that_had_to_do_with_the_outside():  # law 15
    _, run = performed("1.0")
    assert run.result("digest", ("flow0/mass", "elsewhere/view")).outside == ("flow0/mass",)
