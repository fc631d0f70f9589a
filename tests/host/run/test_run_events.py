from msgspec import structs

from kit.plans import build
from onika.engine import orders
from onika.host.run.run_events import RunEvents
from onika.host.run.run_statistics import Meeting
from onika.wire import event
from onika.words.reason import Reason


def only_message(tell):
    events = []
    flows = [build.job("move", trigger="move")], [build.job("move", trigger="move")]
    plan = build.plan(*flows)
    named = [structs.replace(flow, subsystem=name) for flow, name in zip(plan.flows, ("left", "right"), strict=True)]
    run_events = RunEvents(structs.replace(plan, flows=tuple(named)), events.append)
    run_events.began = 1_000_000_000
    tell(run_events)
    (message,) = events
    return message


def test_an_action_is_told_with_its_name_and_how_many_there_are():  # R-E11
    message = only_message(lambda events: events.note(orders.Began(1, 0), 1_500_000_000))
    assert message == event.Began(1, 0, 1, "action 0", 0.5)
    assert only_message(lambda events: events.note(orders.Done(1, 0), 1_500_000_000)) == event.Done(1, 0, 0.5)


def test_a_flow_that_waits_is_told_with_the_names_of_those_it_waits_for():  # R-X03
    moved = orders.Moved(0, "waiting", 3, "meet", (1,), Reason.plain("flow 1 has ended"))
    message = only_message(lambda events: events.note(moved, 1_000_000_000))
    assert message == event.Moved("left", "waiting", 3, 0.0, "meet", ("right",), Reason.plain("flow 1 has ended"))


def test_a_note_names_its_subsystem():  # R-A08
    assert only_message(
        lambda events: events.note(orders.RunNote(1, Reason.plain("so")), 1_000_000_000)
    ) == event.Warned("right", "", Reason.plain("so"), 0)


def test_a_meeting_is_told_in_the_time_of_the_run():  # R-E11
    met = only_message(lambda events: events.met(Meeting("meet", (0, 1), 12.5), 2_000_000_000))
    assert met == event.Met("meet", ("left", "right"), 12.5, 1.0)
