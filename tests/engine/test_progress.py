import pytest

from kit.plans import build
from kit.plans.flow_program import bottom, program, top
from onika.engine.flow import FlowEvent, FlowState
from onika.engine.orders import Began, Done, Launch, Moved, RunNote, Switch
from onika.engine.program import FlowProgram
from onika.engine.progress import Progress
from onika.engine.step import steps
from onika.engine.walk import FinishValue
from onika.wire.plan import Do, Halt

REACH = build.job("move", "puma", trigger="move", arguments="1 2")
GRASP = build.job("grip", "puma", trigger="grip")
ALONE = build.job("move", trigger="move")


def progress(*jobs, others=(), script=(), parent=None, judge=lambda _condition: False):
    planned = build.plan(build.flow(jobs, script, parent)).flows[0]
    ranks = {name: place for place, name in enumerate(build.names(jobs))}
    triggers = {index: job.trigger for index, job in enumerate(jobs)}
    return Progress(0, planned, FlowProgram(planned), steps(planned, triggers, set(others), ranks), ranks, judge)


def running(*jobs, others=(), script=(), judge=lambda _condition: False):
    """A flow in its first action, all of whose tasks have said that they are ON."""
    flow = progress(*jobs, others=others, script=script, judge=judge)
    flow.enter(FlowEvent.SPAWN)
    flow.flow_tasks.spawn()
    flow.begin()
    for name in jobs[0].tasks:
        flow.flow_tasks.turned_on(name)
    return flow


def test_a_flow_is_ready_at_its_first_instruction():
    flow = progress(REACH)
    assert (flow.state, flow.current, flow.step, flow.next) == (FlowState.READY, -1, None, Do(0))


def test_a_nested_flow_stands_at_its_end_until_it_is_begun():  # R-D13
    assert progress(ALONE, ALONE, script=(Do(0), Halt(), Do(1), Halt()), parent=0).place == 3


def test_beginning_switches_and_tells():
    flow = progress(REACH)
    flow.enter(FlowEvent.SPAWN)
    flow.flow_tasks.spawn()
    assert flow.begin() == [Switch(0, (), (Launch("move", "1 2", 100.0), Launch("puma", "", 100.0))), Began(0, 0)]
    assert (flow.state, flow.current, flow.next) == (FlowState.RUNNING, 0, Halt())


def test_only_an_action_can_begin():
    flow = progress()
    with pytest.raises(ValueError, match="expected a Do to begin, found Halt"):
        flow.begin()


def test_a_flow_that_begins_again_after_it_has_stood_tells_that_it_runs():
    flow = running(REACH, GRASP)
    flow.enter(FlowEvent.REST)
    assert flow.begin()[-1] == Moved(0, "running", 1)


def test_a_job_without_a_trigger_is_noted():
    flow = progress(build.job("puma"))
    flow.enter(FlowEvent.SPAWN)
    flow.flow_tasks.spawn()
    note = flow.begin()[-1]
    assert isinstance(note, RunNote)
    assert note.text.key == "engine.no_trigger"


def test_a_task_that_is_on_but_no_trigger_of_the_action_does_not_end_it():  # reading 16
    assert not running(REACH).finished("puma")


def test_a_trigger_that_has_not_said_that_it_is_on_does_not_end_the_action():
    flow = running(REACH, REACH)
    assert flow.finished("move")
    flow.begin()
    assert not flow.finished("move")
    flow.flow_tasks.turned_on("move")
    assert flow.finished("move")


def test_a_flow_that_does_not_run_takes_no_finish():
    flow = running(REACH, GRASP, others=["puma"])
    assert flow.finished("move")
    flow.enter(FlowEvent.HOLD)
    assert not flow.finished("puma")


def test_a_flow_that_is_killed_begins_nothing():
    flow = running(REACH, GRASP)
    flow.enter(FlowEvent.KILL)
    with pytest.raises(ValueError, match="killing"):
        flow.begin()


def test_messages_say_the_parameter_file_before_the_first_action_and_the_action_then():
    flow = progress(REACH)
    assert str(flow.where("puma")) == "puma.rmod: puma"
    flow.enter(FlowEvent.SPAWN)
    flow.flow_tasks.spawn()
    flow.begin()
    assert str(flow.where("puma")) == "test.appl flow 0 action 0: puma"


def test_the_value_of_an_action_leads_the_next_walk():
    flow = running(ALONE, ALONE, script=program(bottom("round", Do(0)), Do(1)))
    assert flow.ends_with(FinishValue(0, loop=True)) == Done(0, 0)
    flow.walk()
    assert flow.next == Do(0)


def test_who_is_sent_elsewhere_has_no_value_and_leaves_only_loops_around_there():  # readings 21 and 22
    flow = running(ALONE, ALONE, ALONE, script=program(bottom("outer", Do(0), bottom("inner", Do(1))), Do(2)))
    flow.ends_with(FinishValue(0, loop=True))
    flow.leaving = frozenset({"outer", "inner"})
    flow.go(0)
    assert (flow.next, flow.leaving) == (Do(0), {"outer"})
    flow.go(2)
    assert (flow.next, flow.leaving) == (Do(2), frozenset())


def test_no_ops_on_the_way_are_told_and_what_is_on_still_belongs_to_the_job_before():  # R-D11
    flow = running(REACH, build.noop(), GRASP)
    flow.ends_with(FinishValue())
    way, orders = flow.walk()
    assert orders == [Began(0, 1), Done(0, 1)]
    assert (way.passed, flow.current, flow.step.name) == ((1,), 1, "action 0")


def test_the_place_of_a_flow_is_that_of_its_action_while_it_runs_and_the_next_one_else():
    flow = running(ALONE, ALONE)
    assert flow.place == 0
    flow.enter(FlowEvent.REST)
    assert flow.place == 1


@pytest.mark.parametrize(("condition", "holds", "rests"), [("", False, True), ("X", True, True), ("X", False, False)])
def test_a_breakpoint_counts_always_or_while_its_condition_holds(condition, holds, rests):
    flow = running(ALONE, judge=lambda _condition: holds)
    assert not flow.rests_after(0)
    flow.breakpoints[0] = condition
    assert flow.rests_after(0) is rests


def test_whatever_changes_what_comes_next_changes_the_revision():
    flow = running(ALONE, ALONE, script=program(top("round", Do(0), Do(1))))
    before = flow.revision
    flow.ends_with(FinishValue())
    assert flow.revision > before
    before = flow.revision
    flow.enter(FlowEvent.REST)
    assert flow.revision > before


def test_the_cases_are_those_of_all_ways_the_action_may_end():
    flow = running(REACH, GRASP, script=program(bottom("round", Do(0)), Do(1)))
    cases = [(case.task, case.choice, case.loop, case.switch.on) for case in flow.cases()]
    assert cases == [
        ("move", None, False, (Launch("grip", "", 100.0),)),
        ("move", None, True, (Launch("move", "1 2", 100.0),)),
    ]


def test_asking_for_cases_changes_nothing():
    flow = running(REACH, GRASP)
    before = (flow.revision, flow.place, flow.current)
    assert flow.cases() == flow.cases()
    assert (flow.revision, flow.place, flow.current) == before
    assert flow.begin()[0] == Switch(0, ("move",), (Launch("grip", "", 100.0),))
