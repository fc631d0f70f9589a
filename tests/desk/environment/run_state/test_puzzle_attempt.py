from dataclasses import replace

import pytest
from msgspec import structs

from onika.desk.environment.run_state.puzzle_attempt import PuzzleAttempt
from onika.desk.plan.preparation import prepare_run
from onika.model.puzzle import Puzzle
from onika.store.site import open_site
from onika.wire import event
from onika.wire.view import RunView, StepRunView
from onika.words.reason import NOTHING, Reason

PLAN = prepare_run("two_arms", open_site([], {}, None)).plan
PUZZLE = Puzzle("p", (), (), ("flow1/Q_MEZ[0] > 0.5", "LAMP == 1"), actions=4, seconds=6.0)
RUN = RunView("a1", "two_arms", 1, is_completed=True, steps={"1": StepRunView("done", times=1)})
GOOD = {"flow1/Q_MEZ": [0.8, 0.0], "flow0/LAMP": 1}


def attempt(uncounted=NOTHING, **changes):
    return PuzzleAttempt.of(replace(PUZZLE, **changes), PLAN, uncounted)


def ended(values, completed=True, runtime_s=5.0):
    return event.Result(completed, NOTHING, 4, 4, runtime_s, 0.1, values, (), "")


def test_the_runtime_is_asked_for_the_variables_of_the_goal_where_the_flows_live():  # R-G10
    assert attempt().watch == ("flow1/Q_MEZ", "flow0/LAMP")
    flows = tuple(structs.replace(flow, subsystem=f"other{n}") for n, flow in enumerate(PLAN.flows))
    moved = PuzzleAttempt.of(PUZZLE, structs.replace(PLAN, flows=flows), NOTHING)
    assert moved.watch == ("other1/Q_MEZ", "other0/LAMP")
    values = {"other1/Q_MEZ": [0.8], "other0/LAMP": 1}
    assert moved.result(RUN, ended(values)).is_solved


def test_a_run_that_reaches_all_goals_solves_it_and_has_stars():  # R-G10
    result = attempt().result(RUN, ended(GOOD))
    assert (result.is_solved, result.stars, result.actions, result.took_s) == (True, 3, 4, 5.0)
    assert attempt().result(RUN, ended(GOOD, runtime_s=7.0)).stars == 2
    assert attempt(actions=3).result(RUN, ended(GOOD, runtime_s=7.0)).stars == 1


@pytest.mark.parametrize("values", [{}, {"flow0/LAMP": 1}, {**GOOD, "flow0/LAMP": 0}, {**GOOD, "flow1/Q_MEZ": [0.1]}])
def test_one_goal_that_is_not_met_is_enough_to_miss_it(values):  # R-G10
    result = attempt().result(RUN, ended(values))
    assert not result.is_solved and result.stars == 0
    assert not all(goal.is_met for goal in result.goals)


def test_what_was_found_is_told_with_each_goal():  # R-G10
    goals = attempt().result(RUN, ended({"flow1/Q_MEZ": [0.25, 0.0]})).goals
    assert [(goal.text, goal.is_met, goal.found) for goal in goals] == [
        ("flow1/Q_MEZ[0] > 0.5", False, "0.2500"),
        ("LAMP == 1", False, ""),
    ]


def test_what_is_nothing_but_dust_is_told_as_nothing():  # R-G10
    assert attempt().result(RUN, ended({"flow1/Q_MEZ": [-1.69e-16]})).goals[0].found == "0.0000"


def test_a_variable_that_no_task_has_is_not_asked_for_and_never_met():  # R-G10
    lone = attempt(expectations=("NOBODY == 0", "flow7/LAMP == 1"))
    assert lone.watch == ()
    assert not lone.result(RUN, ended(GOOD)).is_solved


def test_a_run_that_was_aborted_solves_nothing():  # R-G10
    assert not attempt().result(structs.replace(RUN, is_completed=False), ended(GOOD, completed=False)).is_solved


def test_who_leaves_out_an_action_has_not_solved_it():  # R-G10
    left = structs.replace(RUN, steps={"1": StepRunView("left", times=0)})
    result = attempt().result(left, ended(GOOD))
    assert (result.is_solved, result.uncounted.key) == (False, "run.puzzle_left_out")


def test_a_run_that_does_not_count_from_its_beginning_solves_nothing():  # R-G10
    result = attempt(Reason.of("run.puzzle_not_put_back")).result(RUN, ended(GOOD))
    assert (result.is_solved, result.uncounted.key) == (False, "run.puzzle_not_put_back")
