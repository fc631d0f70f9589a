from onika.engine.news import Run
from onika.engine.orders import Spawn
from onika.testing import build

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
