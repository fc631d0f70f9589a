import pytest

from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.flow_tracker import FlowTracker
from onika.desk.run.wait_condition import WaitCondition
from onika.wire import event, steer
from onika.words.reason import NOTHING

PAUSED, DONE = WaitCondition("paused"), WaitCondition("done")


@pytest.fixture
def where():
    return FlowTracker(FlowIndex((IndexedFlow("flow0", ("a", "b", "c")), IndexedFlow("flow1", ("d",)))))


def moved(flow, state, action=0, text="", **what):
    return event.Moved(f"flow{flow}", state, action, 0.0, text=text, **what)


def hear(where, *events):
    for message in events:
        where.hear(message)


def test_every_flow_has_a_state_an_action_and_whom_it_waits_for(where):  # R-E11, R-X03
    hear(where, moved(1, "running"), event.Began(1, 0, 1, "d", 0.1), event.Done(1, 0, 0.2))
    hear(where, moved(1, "waiting", tag="a", waits_for=("flow0",)))
    spot = where.statuses["flow1"]
    assert (spot.state, spot.action, spot.name, spot.tag, spot.waits_for) == ("waiting", 0, "d", "a", ("flow0",))
    assert where.done == 1


def test_a_moment_comes_once(where):  # R-E07
    hear(where, event.Began(0, 0, 3, "a", 0.0))
    assert where.has_come(WaitCondition("began", "flow0", 0))
    assert not where.has_come(WaitCondition("began", "flow0", 0))


def test_what_came_while_nobody_waited_is_not_lost(where):  # R-E07
    hear(where, event.Began(0, 0, 3, "a", 0.0), event.Done(0, 0, 0.1), event.Began(0, 1, 3, "b", 0.1))
    assert where.has_come(WaitCondition("done", "flow0", 0))
    assert not where.has_come(WaitCondition("began", "flow0", 0))
    assert where.has_come(WaitCondition("began", "flow0", 1))


def test_flows_are_waited_for_one_after_another_in_any_order(where):  # R-E07
    hear(where, moved(1, "done"), moved(0, "done"))
    assert where.has_come(WaitCondition("done", "flow0"))
    assert where.has_come(WaitCondition("done", "flow1"))


def test_every_flow_is_paused_when_the_last_one_is_or_has_nothing_to_do(where):  # R-E07
    hear(where, moved(0, "paused"))
    assert not where.has_come(PAUSED)
    hear(where, moved(1, "done"))
    assert where.has_come(PAUSED)
    assert not where.has_come(PAUSED)


def test_any_flow_that_waits_is_enough(where):  # R-E07
    hear(where, moved(1, "waiting", tag="a"))
    assert where.has_come(WaitCondition("waiting"))


def test_a_pause_before_somebody_steered_is_past(where):  # R-E07
    hear(where, moved(0, "paused"), event.Done(0, 0, 0.1))
    where.steered("flow0")
    assert not where.has_come(WaitCondition("paused", "flow0"))
    assert where.has_come(WaitCondition("done", "flow0", 0))


def test_after_a_skip_what_was_done_before_is_past_too(where):  # R-E13
    hear(where, event.Began(0, 0, 3, "a", 0.0), event.Began(1, 0, 1, "d", 0.0))
    where.steered("flow0", is_skip=True)
    assert not where.has_come(WaitCondition("began", "flow0", 0))
    assert where.has_come(WaitCondition("began", "flow1", 0))


def test_a_word_about_a_flow_that_stays_where_it_is_is_no_new_state(where):  # R-E07
    hear(where, moved(0, "waiting", tag="a"))
    assert where.has_come(WaitCondition("waiting", "flow0"))
    hear(where, moved(0, "waiting", text="leaves the loop at its next test", tag="a"))
    assert not where.has_come(WaitCondition("waiting", "flow0"))


def test_nothing_goes_on_where_all_stand_still_or_are_done(where):  # R-X03
    assert not where.is_stuck
    hear(where, moved(0, "waiting", tag="t a", waits_for=("flow1",)))
    assert not where.is_stuck
    hear(where, moved(1, "paused", 0))
    assert where.is_stuck
    assert str(where.standing()) == "flow0 waits at t a for flow1, flow1 is paused after action 1"
    hear(where, moved(1, "done"), moved(0, "done"))
    assert not where.is_stuck


@pytest.mark.parametrize(
    ("state", "sentence"),
    [
        (moved(0, "stopped", 1), "flow0 has stopped in action 2"),
        (moved(0, "joining", 1, waits_for=("flow0.1",)), "flow0 waits for flow0.1"),
        (moved(0, "joining", 1), "flow0 waits for nested flows"),
    ],
)
def test_who_stands_still_is_said_with_the_reason(where, state, sentence):  # R-X03
    hear(where, state)
    assert str(where.standing()) == sentence


def test_what_the_runtime_says_of_itself_counts_more(where):  # R-E11
    hear(where, moved(0, "paused", 1))
    where.place((steer.Position("flow0", "running", 2), steer.Position("elsewhere", "running", 0)))
    assert (where.statuses["flow0"].state, where.statuses["flow0"].action) == ("running", 2)


def test_a_question_is_open_until_the_task_goes_on(where):  # law 25
    hear(where, event.Asked("flow0", "gauge", NOTHING, (), 0.0))
    assert where.is_asking
    hear(where, event.TaskState("flow0", "gauge", "ON", 0.0))
    assert not where.is_asking


def test_flows_that_are_not_of_this_run_are_not_looked_at(where):
    hear(where, event.Moved("main", "paused", 0, 0.0))
    assert set(where.statuses) == {"flow0", "flow1"}
