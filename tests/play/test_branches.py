"""Stories of branches, chosen by a value or by conditions (§4.3.2, R-D10, R-D13, R-E06, readings 19 to 21)."""

import pytest

from kit.engine.play_lines import JOB, NOOP, begins, ends, goes_on, passes, started
from kit.plans import build
from kit.plans.flow_program import bottom, branch, nested, program, top
from onika.engine.news import TurnedOn
from onika.engine.orders import Done, Moved, RunNote, Settle, Together
from onika.wire.plan import Do, Halt
from onika.wire.steer import Pause, Resume, Skip
from onika.words.reason import Reason

THREE = program(Do(0), branch([Do(1)], [Do(2)], [Do(3)], name="sort"), Do(4))


@pytest.mark.parametrize("choice", [0, 1, 2])
def test_the_action_before_chooses_the_flow(choice):  # R-D10, reading 19
    assert (
        started(build.flow([JOB] * 5, THREE))
        >> ends(0, choice) << Done(0, 0) << begins(0, 1 + choice)
        >> ends(0) << Done(0, 1 + choice) << begins(0, 4)
    )  # fmt: skip


@pytest.mark.parametrize("choice", [3, 17])
def test_a_value_beyond_the_number_of_flows_takes_flow_0_and_both_numbers_are_told(choice):  # reading 20
    sentence = (
        f"test.appl flow 0 action 0: sort has 3 flows and the action before it asks for flow {choice}: flow 0 is taken"
    )
    assert (
        started(build.flow([JOB] * 5, THREE))
        >> ends(0, choice)
        << Done(0, 0)
        << RunNote(0, Reason.plain(sentence))
        << begins(0, 1)
    )


def test_a_value_before_a_single_flow_means_nothing_and_is_not_told():  # reading 20
    script = program(Do(0), branch([Do(1)]))
    assert started(build.flow([JOB] * 2, script)) >> ends(0, 2) << Done(0, 0) << begins(0, 1)


def test_a_branch_without_actions_is_legal():
    script = program(Do(0), branch([], [Do(1)]), Do(2))
    assert started(build.flow([JOB] * 3, script)) >> ends(0, 0) << Done(0, 0) << begins(0, 2)


def test_a_conditional_that_comes_first_takes_flow_0():  # reading 21, R-D10
    script = program(branch([Do(0)], [Do(1)]), Do(2))
    assert started(build.flow([JOB] * 3, script)) >> ends(0, 1) << Done(0, 0) << begins(0, 2)


def test_a_conditional_after_a_skip_takes_flow_0():  # reading 21
    play = started(build.flow([JOB] * 5, THREE)) >> TurnedOn(0, "move")
    left = RunNote(0, Reason.plain("test.appl flow 0 action 0: left by the user"))
    assert play >> Skip("0") << left << begins(0, 1, ["move"])


def test_a_conditional_after_a_nested_application_takes_the_value_of_its_last_executed_action():  # reading 21
    script = program(Do(0), branch([Do(1), Do(2)], [Do(3)]), branch([Do(4)], [Do(5)]))
    assert (
        started(build.flow([JOB] * 6, script))
        >> ends(0, 1) << Done(0, 0) << begins(0, 3)
        >> ends(0, 1) << Done(0, 3) << begins(0, 5)
    )  # fmt: skip


def test_a_conditional_after_an_empty_branch_still_has_the_value_before_it():  # reading 21
    script = program(Do(0), branch([Do(1)], []), branch([Do(2)], [Do(3)]))
    assert started(build.flow([JOB] * 4, script)) >> ends(0, 1) << Done(0, 0) << begins(0, 3)


def test_a_conditional_after_a_no_op_takes_flow_0():  # R-D11
    script = program(Do(0), Do(1), branch([Do(2)], [Do(3)]))
    assert (
        started(build.flow([JOB, NOOP, JOB, JOB], script)) >> ends(0, 1) << Done(0, 0) << passes(0, 1) << begins(0, 2)
    )


def test_a_conditional_after_a_loop_takes_the_value_of_its_last_round():  # reading 21
    script = program(bottom("round", Do(0)), branch([Do(1)], [Do(2)]))
    assert (
        started(build.flow([JOB] * 3, script))
        >> ends(0, 0, loop=True) << Done(0, 0) << begins(0, 0)
        >> ends(0, 1, loop=False) << Done(0, 0) << begins(0, 2)
    )  # fmt: skip


def test_a_conditional_after_a_nested_parallel_application_takes_the_value_of_the_flow_it_stands_in():  # reading 21
    script = program(Do(0), nested([(1, 0)], Do(1)), branch([Do(2)], [Do(3)]))
    child = build.flow([JOB], (Do(0), Halt()), parent=0)
    assert (
        started(build.flow([JOB] * 4, script), child)
        >> ends(0) << Done(0, 0) << together_at_a_fork(0, 1, 1)
        >> ends(0, 1) << Done(0, 1) << Moved(0, "joining", 1, waits_for=(1,))
        >> ends(1, 0) << Done(1, 0) << Moved(1, "done", 0) << goes_on(0, 3)
    )  # fmt: skip


def together_at_a_fork(flow, index, child):
    return [Together("", (flow, child)), *begins(flow, index), *goes_on(child, 0)]


def test_the_value_is_remembered_in_a_pause():  # R-E07, R-D10
    assert (
        started(build.flow([JOB] * 5, THREE))
        >> Pause("0") << Moved(0, "running", 0, text=Reason.plain("pauses after its current action"))
        >> ends(0, 2) << Done(0, 0) << Moved(0, "paused", 0)
        >> Resume("0") << goes_on(0, 3)
    )  # fmt: skip


@pytest.mark.parametrize(("holding", "index"), [({"A", "B"}, 1), ({"B"}, 2), (set(), 3)])
def test_the_first_condition_that_holds_chooses_else_the_last_flow(holding, index):  # R-D13
    script = program(Do(0), branch([Do(1)], [Do(2)], [Do(3)], conditions=("A", "B")), Do(4))
    play = started(build.flow([JOB] * 5, script), judge=lambda _flow, condition: condition in holding)
    assert play >> ends(0, 1) << Done(0, 0) << begins(0, index) >> ends(0) << Done(0, index) << begins(0, 4)


def test_branches_stand_in_branches():  # R-E06
    script = program(Do(0), branch([Do(1)], [Do(2), branch([Do(3)], [Do(4)])]), Do(5))
    assert (
        started(build.flow([JOB] * 6, script))
        >> ends(0, 1) << Done(0, 0) << begins(0, 2)
        >> ends(0, 1) << Done(0, 2) << begins(0, 4)
        >> ends(0, 1) << Done(0, 4) << begins(0, 5)
        >> ends(0) << Done(0, 5) << Moved(0, "done", 5) << Settle()
    )  # fmt: skip


def test_the_last_action_of_a_branch_may_be_the_test_of_a_loop_around_it():  # reading 22
    script = program(bottom("round", Do(0), branch([Do(1)], [Do(2)])), Do(3))
    assert (
        started(build.flow([JOB] * 4, script))
        >> ends(0, 1) << Done(0, 0) << begins(0, 2)
        >> ends(0, loop=True) << Done(0, 2) << begins(0, 0)
        >> ends(0, 0) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=False) << Done(0, 1) << begins(0, 3)
    )  # fmt: skip


def test_one_value_says_both_whether_to_go_round_and_where():  # reading 19
    script = program(top("round", Do(0), branch([Do(1)], [Do(2)])), Do(3))
    assert (
        started(build.flow([JOB] * 4, script))
        >> ends(0, 1, loop=True) << Done(0, 0) << begins(0, 2)
        >> ends(0) << Done(0, 2) << begins(0, 0)
        >> ends(0, 1, loop=False) << Done(0, 0) << begins(0, 3)
    )  # fmt: skip
