import pytest

from kit.plans import build
from onika.engine.news import Failed, Run, Spawned
from onika.engine.orders import Spawn
from onika.wire.plan import Do, Halt
from onika.words.reason import Reason

REACH = build.job("move", "puma", trigger="move", arguments="1 2", rates={"puma": 50.0}, synch_tag="meet")
GRASP = build.job("grip", "puma", trigger="grip")


def test_the_names_of_a_flow_are_the_union_of_its_tasks_as_first_named():
    assert build.names([REACH, GRASP, REACH]) == ("move", "puma", "grip")


def test_a_plan_holds_the_jobs_as_they_were_given():
    plan = build.plan([REACH, GRASP], [GRASP])
    assert [len(flow.actions) for flow in plan.flows] == [2, 1]
    action = plan.flows[0].actions[0]
    assert (action.tasks, action.arguments, action.rates) == (("move", "puma"), "1 2", (("puma", 50.0),))
    assert (action.target, action.synch_tag) == ("target", "meet")
    assert plan.flows[0].actions[1].target is None
    assert [task.name for task in plan.flows[1].tasks] == ["grip", "puma"]


def test_a_run_of_an_engine_begins_with_the_spawns_of_its_flows():
    assert build.engine([REACH, GRASP], [GRASP]).feed(Run()) == build.spawns([REACH, GRASP], [GRASP])
    assert build.spawns([GRASP]) == [Spawn(0, "grip"), Spawn(0, "puma")]


def test_a_task_is_periodic_and_has_no_ports():
    task = build.task("filter", frequency=None)
    assert (task.name, task.type, task.frequency) == ("filter", "periodic", None)
    assert task.invar == task.outvar == task.inconst == task.outconst == ()


def test_a_flow_holds_its_program_and_who_begins_it():
    whole = build.plan([GRASP], build.flow([REACH, GRASP], (Do(1), Do(0), Halt()), parent=0))
    assert (whole.flows[0].program, whole.flows[0].parent) == ((), None)
    assert (whole.flows[1].program, whole.flows[1].parent) == ((Do(1), Do(0), Halt()), 0)
    assert [task.name for task in whole.flows[1].tasks] == ["move", "puma", "grip"]
    assert build.spawns([], build.flow([REACH])) == [Spawn(1, "move"), Spawn(1, "puma")]


def test_a_no_op_has_no_tasks_and_may_have_a_tag_and_a_breakpoint():
    action = build.plan([build.noop("meet", marker=True)]).flows[0].actions[0]
    assert (action.tasks, action.is_noop, action.synch_tag, action.marker) == ((), True, "meet", True)
    usual = build.plan([GRASP, build.job("move", marker=True)]).flows[0].actions
    assert [(action.is_noop, action.marker) for action in usual] == [(False, False), (False, True)]


@pytest.mark.parametrize(("stands_still", "orders"), [(True, ["Moved"]), (False, ["Kill", "Kill"])])
def test_an_engine_stands_still_at_an_error_if_that_is_said(stands_still, orders):
    engine = build.engine([GRASP], stands_still=stands_still)
    for news in (Run(), Spawned(0, "grip"), Spawned(0, "puma")):
        engine.feed(news)
    assert [type(order).__name__ for order in engine.feed(Failed(0, "grip", Reason.plain("x")))] == orders
