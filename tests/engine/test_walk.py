import pytest

from kit.plans import build
from kit.plans.flow_program import bottom, branch, program, top
from onika.engine.program import FlowProgram
from onika.engine.walk import NOOP, FinishValue, walk
from onika.wire.plan import Do, Fork, Halt, Join, Meet, Rest

JOB = build.job("move", trigger="move")
NOTHING = frozenset()


def way(script, noops=(), pc=0, value=None, leaving=NOTHING, holding=(), rests=()):
    actions = 1 + max(instruction.action for instruction in script if isinstance(instruction, Do))
    jobs = [build.noop() if index in noops else JOB for index in range(actions)]
    made = FlowProgram(build.plan(build.flow(jobs, script)).flows[0])
    return walk(made, pc, value, frozenset(leaving), lambda action: action in holding, lambda action: action in rests)


@pytest.mark.parametrize("script", [Do(0), Meet("a"), Fork(((1, 0),)), Halt(), Rest(-1)])
def test_a_walk_ends_at_what_takes_time_or_needs_others(script):
    script = (script, Do(0), *([Join((1,))] if isinstance(script, Fork) else []), Halt())
    end = way(script)
    assert (end.pc, end.passed, end.notes, end.rests, end.is_endless) == (0, (), (), False, False)


def test_a_join_ends_a_walk():
    assert way((Do(0), Fork(()), Join(()), Halt()), pc=2).pc == 2


def test_a_breakpoint_of_an_action_is_passed_since_it_was_asked_for_at_its_end():
    assert way((Do(0), Rest(0), Do(1), Halt()), pc=1).pc == 2


@pytest.mark.parametrize(("holding", "pc"), [(["X"], 1), ([], 2)])
def test_a_breakpoint_of_an_application_is_passed_unless_its_condition_holds(holding, pc):
    assert way((Do(0), Rest(-1, "X"), Do(1), Halt()), pc=1, holding=holding).pc == pc


def test_no_ops_are_passed_and_return_true_and_flow_0():  # R-D11
    end = way(program(Do(0), Do(1), Do(2)), noops=[0, 1], value=FinishValue(2))
    assert (end.pc, end.passed, end.value) == (2, (0, 1), NOOP)
    assert FinishValue(0, loop=True) == NOOP


def test_a_flow_rests_behind_a_no_op_after_which_it_is_to_rest():  # reading 25
    end = way(program(Do(0), Do(1), Do(2)), noops=[0, 1], rests=[0])
    assert (end.pc, end.passed, end.rests) == (1, (0,), True)


def test_without_a_value_flow_0_is_taken_and_loops_are_left():  # readings 21 and 22
    assert way(program(branch([Do(0)], [Do(1)]))).pc == 1
    assert way(program(bottom("round", Do(0)), Do(1)), pc=1).pc == 2
    assert way(program(top("round", Do(0), Do(1)), Do(2)), pc=1).pc == 4


def test_a_loop_that_was_left_need_not_be_left_again():  # R-E07
    script = program(bottom("round", Do(0)), Do(1))
    end = way(script, pc=1, value=FinishValue(0, loop=True), leaving={"round", "other"})
    assert (end.pc, end.left) == (2, {"other"})
    assert way(script, pc=1, value=FinishValue(0, loop=True)).pc == 0


def test_a_loop_that_ends_by_itself_need_not_be_left():  # R-E07
    assert way(program(bottom("round", Do(0)), Do(1)), pc=1, value=FinishValue(), leaving={"round"}).left == NOTHING


def test_a_top_test_loop_is_left_at_the_end_of_its_body_as_well():  # R-E07
    end = way(program(top("round", Do(0), Do(1)), Do(2)), pc=3, value=FinishValue(), leaving={"round"})
    assert (end.pc, end.left) == (4, NOTHING)


def test_a_loop_without_jobs_is_left_when_that_is_wanted_and_endless_else():
    script = program(bottom("round", Do(0)), Do(1))
    assert way(script, noops=[0]).is_endless
    assert way(script, noops=[0], leaving={"round"}).pc == 2


def test_a_loop_without_jobs_ends_when_its_condition_does_not_hold():
    script = program(bottom("round", Do(0), condition="X"), Do(1))
    assert way(script, noops=[0]).pc == 2
    assert way(script, noops=[0], holding=["X"]).is_endless


def test_a_value_too_large_is_noted_with_the_number_of_flows():  # reading 20
    end = way(program(branch([Do(0)], [Do(1)], name="sort")), value=FinishValue(2))
    (note,) = end.notes
    assert (end.pc, str(note)) == (1, "sort has 2 flows and the action before it asks for flow 2: flow 0 is taken")


def test_a_branch_without_a_name_is_called_the_branch():
    (note,) = way(program(branch([Do(0)], [Do(1)])), value=FinishValue(2)).notes
    assert str(note.args["name"]) == "the branch"


def test_conditions_are_asked_in_their_order_and_no_further_than_needed():  # R-D13
    conditions = []
    script = program(branch([Do(0)], [Do(1)], [Do(2)], conditions=("X", "Y")))
    made = FlowProgram(build.plan(build.flow([JOB] * 3, script)).flows[0])
    walk(made, 0, None, NOTHING, lambda condition: conditions.append(condition) or condition == "X", lambda _one: False)
    assert conditions == ["X"]
