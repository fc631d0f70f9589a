import pytest

from onika.engine.flow import FlowState
from onika.engine.orders import Began, Done, Kill, Note, Spawn, Start, Switch
from onika.engine.progress import Progress
from onika.engine.step import steps
from onika.testing import build

REACH = build.job("move", "puma", trigger="move", arguments="1 2")
GRASP = build.job("grip", "puma", trigger="grip")


def progress(*jobs, others=(), ranks=None):
    planned = build.plan(jobs).flows[0]
    ranks = ranks or {name: place for place, name in enumerate(build.names(jobs))}
    return Progress(
        0, planned, steps(planned, {i: job.trigger for i, job in enumerate(jobs)}, set(others), ranks), ranks
    )


def running(*jobs, others=()):
    """A flow in its first action, all of whose tasks have said that they are ON."""
    flow = progress(*jobs, others=others)
    flow.spawn()
    flow.begin()
    for name in jobs[0].tasks:
        flow.turned_on(name)
    return flow


def test_spawning_orders_the_union_of_the_tasks_once_each():  # R-E02
    flow = progress(REACH, GRASP, REACH)
    assert flow.spawn() == [Spawn(0, "move"), Spawn(0, "puma"), Spawn(0, "grip")]


def test_a_flow_is_spawned_when_no_task_is_awaited():
    flow = progress(REACH)
    flow.spawn()
    flow.spawned("puma")
    assert not flow.is_spawned
    assert flow.is_unborn("move")
    flow.spawned("move")
    assert flow.is_spawned


def test_the_first_action_turns_all_its_tasks_on():
    flow = progress(REACH)
    flow.spawn()
    assert flow.begin() == [Switch(0, (), (Start("move", "1 2", 100.0), Start("puma", "", 100.0))), Began(0, 0)]


def test_the_next_action_leaves_common_tasks_alone():  # R-E02, law 6
    flow = running(REACH, GRASP)
    assert flow.finished("move") == [Done(0, 0)]
    assert flow.begin() == [Switch(0, (), (Start("grip", "", 100.0),)), Began(0, 1)]


def test_a_trigger_that_is_still_on_is_turned_off_and_on_again():
    flow = running(build.job("a", "b", trigger="a"), build.job("b", trigger="b", arguments="7"), others=["b"])
    flow.finished("a")
    assert flow.begin() == [Switch(0, ("b",), (Start("b", "7", 100.0),)), Began(0, 1)]


def test_a_kept_task_gets_the_rate_of_the_new_action_and_its_own_back_after_it():  # decision 13
    flow = running(REACH, build.job("grip", "puma", trigger="grip", rates={"puma": 50.0}), REACH)
    flow.finished("move")
    switch, _ = flow.begin()
    assert switch.kept_rates == (("puma", 50.0),)
    flow.turned_on("grip")
    flow.finished("grip")
    switch, _ = flow.begin()
    assert switch.kept_rates == (("puma", 100.0),)


def test_a_task_that_is_on_but_no_trigger_of_the_action_does_not_end_it():  # decision 16
    assert running(REACH).finished("puma") is None


def test_a_trigger_that_has_not_said_that_it_is_on_does_not_end_the_action():
    flow = running(REACH, REACH)
    flow.finished("move")
    flow.begin()
    assert flow.finished("move") is None
    flow.turned_on("move")
    assert flow.finished("move") == [Done(0, 1)]


def test_a_waiting_flow_takes_no_finish():
    flow = running(REACH, GRASP, others=["puma"])
    flow.finished("move")
    flow.hold()
    assert flow.finished("puma") is None


def test_a_task_that_went_off_comes_on_with_the_next_action_that_needs_it():
    flow = running(REACH, GRASP)
    assert flow.switched_off("puma")
    flow.finished("move")
    switch, _ = flow.begin()
    assert [start.task for start in switch.on] == ["puma", "grip"]


def test_a_task_that_was_kept_on_is_believed_when_it_goes_off():
    flow = running(build.job("a", "see", trigger="a"), build.job("a", "see", trigger="a"))
    flow.finished("a")
    flow.begin()
    assert flow.switched_off("see")


def test_late_word_of_a_task_that_went_off_before_it_came_on_again_is_not_believed():
    flow = running(build.job("a", "see", trigger="a"), build.job("a", trigger="a"), build.job("a", "see", trigger="a"))
    for _ in range(2):
        flow.turned_on("a")
        flow.finished("a")
        flow.begin()
    assert not flow.switched_off("see")
    flow.turned_on("see")
    assert flow.switched_off("see")


def test_a_failed_task_stays_off():  # decision 17
    flow = running(build.job("move", "view", trigger="move"), build.job("move", "view", trigger="move"))
    flow.failed("view")
    flow.finished("move")
    assert flow.begin() == [Switch(0, (), (Start("move", "", 100.0),)), Began(0, 1)]


def test_a_job_without_a_trigger_is_noted():
    flow = progress(build.job("puma"))
    flow.spawn()
    note = flow.begin()[-1]
    assert isinstance(note, Note)
    assert "no trigger" in note.text


def test_all_living_tasks_are_killed_in_the_order_of_their_ranks():
    flow = progress(REACH, GRASP, ranks={"puma": 0, "move": 1, "grip": 2})
    flow.spawn()
    flow.gone("move")
    assert flow.kill() == [Kill(0, "puma"), Kill(0, "grip")]


def test_a_flow_ends_when_its_last_task_is_gone():
    flow = running(REACH)
    flow.kill()
    flow.gone("move")
    assert flow.state is FlowState.KILLING
    flow.gone("puma")
    assert flow.state is FlowState.ENDED


def test_a_flow_without_living_tasks_ends_at_once():
    flow = progress(REACH)
    assert flow.kill() == []
    assert flow.state is FlowState.ENDED


def test_a_flow_that_is_killed_begins_nothing():
    flow = running(REACH, GRASP)
    flow.kill()
    with pytest.raises(ValueError, match="killing"):
        flow.begin()


def test_messages_say_the_parameter_file_before_the_first_action_and_the_action_then():
    flow = progress(REACH)
    flow.spawn()
    assert flow.where("puma") == "puma.rmod: puma"
    flow.begin()
    assert flow.where("puma") == "test.appl flow 0 action 0: puma"
