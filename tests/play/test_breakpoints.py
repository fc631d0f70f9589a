"""Stories of breakpoints, with and without conditions (§5.9.2, R-E07, reading 25)."""

import pytest

from kit.engine.play_lines import JOB, begins, ends, goes_on, started
from kit.plans import build
from kit.plans.flow_program import bottom, branch, program
from onika.engine.orders import Done, Moved, Settle
from onika.wire.plan import Do, Rest
from onika.wire.steer import Mark, Resume

MARKED = build.job("move", trigger="move", marker=True)


def paused(index):
    return Moved(0, "paused", index)


def test_a_breakpoint_of_the_file_pauses_after_its_action_also_after_the_last():  # reading 25
    assert (
        started([MARKED, JOB, MARKED])
        >> ends(0) << Done(0, 0) << paused(0)
        >> Resume("0") << goes_on(0, 1)
        >> ends(0) << Done(0, 1) << begins(0, 2)
        >> ends(0) << Done(0, 2) << paused(2)
        >> Resume("0") << Moved(0, "done", 2) << Settle()
    )  # fmt: skip


def test_a_breakpoint_in_a_loop_pauses_every_time_and_the_value_is_not_forgotten():  # reading 25
    assert (
        started(build.flow([JOB, JOB], program(bottom("round", Do(0), Rest(0)), Do(1))))
        >> ends(0, loop=True) << Done(0, 0) << paused(0)
        >> Resume("0") << goes_on(0, 0)
        >> ends(0, loop=True) << Done(0, 0) << paused(0)
        >> Resume("0") << goes_on(0, 0)
        >> ends(0, loop=False) << Done(0, 0) << paused(0)
        >> Resume("0") << goes_on(0, 1)
    )  # fmt: skip


def test_a_breakpoint_under_a_condition_pauses_only_where_that_holds():  # R-E07
    holds = {"X > 1": False}
    script = program(bottom("round", Do(0), Rest(0, "X > 1")), Do(1))
    play = started(build.flow([JOB, JOB], script), judge=lambda _flow, condition: holds[condition])
    play = play >> ends(0, loop=True) << Done(0, 0) << begins(0, 0)
    holds["X > 1"] = True
    assert play >> ends(0, loop=True) << Done(0, 0) << paused(0) >> Resume("0") << goes_on(0, 0)


def test_a_breakpoint_can_be_set_and_removed_in_the_run():  # R-E07
    play = started([JOB, MARKED, JOB, JOB]) >> Mark("0", 0) >> Mark("0", 1, is_set=False)
    assert play.position(0).breakpoints == (0,)
    assert (
        play
        >> ends(0) << Done(0, 0) << paused(0)
        >> Resume("0") << goes_on(0, 1)
        >> ends(0) << Done(0, 1) << begins(0, 2)
    )  # fmt: skip


def test_a_breakpoint_can_be_given_another_condition_in_the_run():  # R-E07
    script = program(Do(0), Rest(0, "X > 1"), Do(1))
    play = started(build.flow([JOB, JOB], script), judge=lambda _flow, condition: condition == "Y")
    assert play >> Mark("0", 0, condition="Y") >> ends(0) << Done(0, 0) << paused(0)


def test_a_breakpoint_that_is_not_there_can_be_removed():
    assert started([JOB, JOB]) >> Mark("0", 0, is_set=False) >> ends(0) << Done(0, 0) << begins(0, 1)


@pytest.mark.parametrize("action", [-1, 2])
def test_there_is_no_breakpoint_after_an_action_that_is_not_there(action):
    assert started([JOB, JOB]).refuses(
        Mark("0", action), f"expected an action from 1 to 2 of flow 0, found {action + 1}"
    )


def test_a_breakpoint_after_a_nested_application_pauses_behind_it_on_every_way():  # reading 25
    script = program(Do(0), branch([Do(1)], [Do(2)]), Rest(-1), Do(3))
    for choice in (0, 1):
        assert (
            started(build.flow([JOB] * 4, script))
            >> ends(0, choice) << Done(0, 0) << begins(0, 1 + choice)
            >> ends(0) << Done(0, 1 + choice) << paused(1 + choice)
            >> Resume("0") << goes_on(0, 3)
        )  # fmt: skip


@pytest.mark.parametrize("holds", [True, False])
def test_a_breakpoint_after_a_nested_application_may_have_a_condition(holds):  # reading 25
    script = program(Do(0), Rest(-1, "X"), Do(1))
    play = started(build.flow([JOB] * 2, script), judge=lambda _flow, _condition: holds)
    assert play >> ends(0) << Done(0, 0) << (paused(0) if holds else begins(0, 1))


def test_two_breakpoints_one_after_the_other_pause_twice():
    script = program(Do(0), Rest(0), Rest(-1), Do(1))
    assert (
        started(build.flow([JOB] * 2, script))
        >> ends(0) << Done(0, 0) << paused(0)
        >> Resume("0") << paused(0)
        >> Resume("0") << goes_on(0, 1)
    )  # fmt: skip
