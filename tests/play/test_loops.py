"""Stories of loops by value and by condition (§4.4.7, Table 9, R-E05, R-D13, readings 21 to 23)."""

import pytest

from kit.engine.play_lines import JOB, NOOP, begins, ends, passes, started
from kit.plans import build
from kit.plans.flow_program import bottom, program, top
from onika.engine.news import Abort, Killed, Run, Spawned, TurnedOn
from onika.engine.orders import Done, End, Kill, Moved, RunNote, Settle
from onika.wire.plan import Do
from onika.wire.steer import Leave, Skip
from onika.words.reason import Reason

TWO_THEN_ONE = program(bottom("round", Do(0), Do(1)), Do(2))
TESTED = program(top("round", Do(0), Do(1)), Do(2))
INNER = program(bottom("outer", Do(0), bottom("inner", Do(1)), Do(2)), Do(3))


def done(index):
    return [Done(0, index), Moved(0, "done", index), Settle()]


def test_a_bottom_test_that_says_continue_leads_back_to_the_anchor_and_else_on():  # R-E05
    assert (
        started(build.flow([JOB] * 3, TWO_THEN_ONE))
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 0)
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=False) << Done(0, 1) << begins(0, 2)
        >> ends(0, loop=True) << done(2)
    )  # fmt: skip


def test_only_the_last_action_of_a_bottom_test_loop_is_asked():  # R-E05
    assert (
        started(build.flow([JOB] * 3, TWO_THEN_ONE))
        >> ends(0, loop=True) << Done(0, 0) << begins(0, 1)
        >> ends(0) << Done(0, 1) << begins(0, 2)
    )  # fmt: skip


def test_a_top_test_that_says_continue_leads_into_the_body_and_the_body_back_to_the_test():  # R-E05, §4.4.7.3
    assert (
        started(build.flow([JOB] * 3, TESTED))
        >> ends(0, loop=True) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=False) << Done(0, 1) << begins(0, 0)
        >> ends(0, loop=True) << Done(0, 0) << begins(0, 1)
        >> ends(0) << Done(0, 1) << begins(0, 0)
        >> ends(0, loop=False) << Done(0, 0) << begins(0, 2)
    )  # fmt: skip


def test_a_top_test_that_says_no_at_once_leaves_the_body_out():  # R-E05
    assert started(build.flow([JOB] * 3, TESTED)) >> ends(0) << Done(0, 0) << begins(0, 2)


@pytest.mark.parametrize("value", [True, False])
def test_a_condition_at_the_bottom_counts_and_the_value_does_not(value):  # R-D13
    holds = {"X > 1": True}
    script = program(bottom("round", Do(0), condition="X > 1"), Do(1))
    play = started(build.flow([JOB] * 2, script), judge=lambda _flow, condition: holds[condition])
    play = play >> ends(0, loop=value) << Done(0, 0) << begins(0, 0)
    holds["X > 1"] = False
    assert play >> ends(0, loop=value) << Done(0, 0) << begins(0, 1)


@pytest.mark.parametrize("value", [True, False])
def test_a_condition_at_the_top_counts_and_the_value_does_not(value):  # R-D13
    holds = {"X > 1": True}
    script = program(top("round", Do(0), Do(1), condition="X > 1"), Do(2))
    play = started(build.flow([JOB] * 3, script), judge=lambda _flow, condition: holds[condition])
    play = play >> ends(0, loop=value) << Done(0, 0) << begins(0, 1) >> ends(0) << Done(0, 1) << begins(0, 0)
    holds["X > 1"] = False
    assert play >> ends(0, loop=value) << Done(0, 0) << begins(0, 2)


def test_a_condition_is_judged_on_the_variables_of_its_own_flow():  # R-D13
    questions = []
    flow = build.flow([JOB], program(bottom("round", Do(0), condition="X > 1")))
    engine = build.engine([NOOP], flow, judge=lambda number, condition: questions.append((number, condition)) or False)
    for news in (Run(), Spawned(1, "move"), *ends(1)):
        engine.feed(news)
    assert questions == [(1, "X > 1")]


def test_a_no_op_as_the_test_makes_a_loop_without_an_end():  # R-E05, R-D11
    script = program(bottom("round", Do(0), Do(1)), Do(2))
    play = started(build.flow([JOB, NOOP, JOB], script))
    for _ in range(5):
        play = play >> ends(0) << Done(0, 0) << passes(0, 1) << begins(0, 0)
    assert (
        play
        >> Leave("0") << Moved(0, "running", 0, text=Reason.plain("leaves the loop round at its next test"))
        >> ends(0) << Done(0, 0) << passes(0, 1) << begins(0, 2)
    )  # fmt: skip


def test_a_no_op_as_the_test_at_the_top_makes_a_loop_without_an_end():  # R-E05, R-D11
    play = started(
        build.flow([NOOP, JOB, JOB], program(top("round", Do(0), Do(1)), Do(2))), first=passes(0, 0) + begins(0, 1)
    )
    for _ in range(3):
        play = play >> ends(0, loop=False) << Done(0, 1) << passes(0, 0) << begins(0, 1)
    assert play >> Abort(Reason.plain("enough")) << Kill(0, "move")


def test_a_loop_that_takes_no_time_at_all_ends_the_run():  # R-E05
    script = program(Do(0), bottom("round", Do(1)), Do(2))
    cause = "flow 0 goes round for ever without taking any time"
    play = started(build.flow([JOB, NOOP, JOB], script)) >> ends(0) << Done(0, 0) << passes(0, 1) * 2 << Kill(0, "move")
    assert play >> Killed(0, "move") << End(False, Reason.plain(cause))


def test_a_loop_in_a_loop_begins_anew_in_each_round():  # reading 23
    assert (
        started(build.flow([JOB] * 4, INNER))
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 1)
        >> ends(0, loop=False) << Done(0, 1) << begins(0, 2)
        >> ends(0, loop=True) << Done(0, 2) << begins(0, 0)
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(0) << Done(0, 1) << begins(0, 2)
        >> ends(0) << Done(0, 2) << begins(0, 3)
    )  # fmt: skip


def test_two_loops_may_end_at_one_action_where_a_no_op_parts_them():  # reading 23
    script = program(bottom("outer", Do(0), bottom("inner", Do(1)), Do(2)), Do(3))
    assert (
        started(build.flow([JOB, JOB, NOOP, JOB], script))
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=False) << Done(0, 1) << passes(0, 2) << begins(0, 0)
    )  # fmt: skip


def test_the_inner_loop_is_left_first_then_the_outer_one():  # R-E07
    play = started(build.flow([JOB] * 4, INNER)) >> ends(0) << Done(0, 0) << begins(0, 1)
    assert play.position(0).loops == ("outer", "inner")
    assert (
        play
        >> Leave("0")
        << Moved(0, "running", 1, text=Reason.plain("leaves the loop inner at its next test"))
        >> Leave("0")
        << Moved(0, "running", 1, text=Reason.plain("leaves the loop outer at its next test"))
    ).refuses(Leave("0"), "in a loop that it is not leaving yet")
    assert (
        play
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 2)
        >> ends(0, loop=True) << Done(0, 2) << begins(0, 3)
    )  # fmt: skip


def test_a_loop_that_was_left_is_a_loop_again_when_the_flow_comes_back():  # R-E07
    assert (
        started(build.flow([JOB] * 4, INNER))
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> Leave("0") << Moved(0, "running", 1, text=Reason.plain("leaves the loop inner at its next test"))
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 2)
        >> ends(0, loop=True) << Done(0, 2) << begins(0, 0)
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 1)
    )  # fmt: skip


@pytest.mark.parametrize("index", [0, 1])
def test_a_top_test_loop_is_left_from_its_test_and_from_its_body(index):  # R-E07
    play = started(build.flow([JOB] * 3, TESTED))
    play = play if index == 0 else play >> ends(0, loop=True) << Done(0, 0) << begins(0, 1)
    assert (
        play
        >> Leave("0") << Moved(0, "running", index, text=Reason.plain("leaves the loop round at its next test"))
        >> ends(0, loop=True) << Done(0, index) << begins(0, 2)
    )  # fmt: skip


def test_a_loop_with_a_condition_is_left_whatever_that_says():  # R-E07, R-D13
    script = program(bottom("round", Do(0), condition="X > 1"), Do(1))
    assert (
        started(build.flow([JOB] * 2, script), judge=lambda _flow, _condition: True)
        >> Leave("0") << Moved(0, "running", 0, text=Reason.plain("leaves the loop round at its next test"))
        >> ends(0, loop=True) << Done(0, 0) << begins(0, 1)
    )  # fmt: skip


def test_outside_of_a_loop_there_is_none_to_leave():  # R-E07
    play = started(build.flow([JOB] * 2, program(Do(0), bottom("round", Do(1)))))
    assert play.refuses(Leave("0"), "expected flow 0 in a loop")


def test_a_skipped_test_leaves_the_loop():  # reading 22
    play = started(build.flow([JOB] * 3, TWO_THEN_ONE)) >> ends(0) << Done(0, 0) << begins(0, 1) >> TurnedOn(0, "move")
    left = RunNote(0, Reason.plain("test.appl flow 0 action 1: left by the user"))
    assert play >> Skip("0") << left << begins(0, 2, ["move"])


def test_a_skip_out_of_a_loop_forgets_that_it_was_to_be_left():  # R-E13
    play = started(build.flow([JOB] * 3, TWO_THEN_ONE)) >> TurnedOn(0, "move")
    left = RunNote(0, Reason.plain("test.appl flow 0 action 0: left by the user"))
    assert (
        play
        >> Leave("0") << Moved(0, "running", 0, text=Reason.plain("leaves the loop round at its next test"))
        >> Skip("0", 2) << left << begins(0, 2, ["move"]) >> TurnedOn(0, "move")
        >> Skip("0", 1)
            << RunNote(0, Reason.plain("test.appl flow 0 action 2: left by the user")) << begins(0, 1, ["move"])
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 0)
    )  # fmt: skip


def test_a_skip_within_a_loop_remembers_that_it_is_to_be_left():  # R-E07, R-E13
    play = started(build.flow([JOB] * 3, TWO_THEN_ONE)) >> TurnedOn(0, "move")
    assert (
        play
        >> Leave("0") << Moved(0, "running", 0, text=Reason.plain("leaves the loop round at its next test"))
        >> Skip("0")
            << RunNote(0, Reason.plain("test.appl flow 0 action 0: left by the user")) << begins(0, 1, ["move"])
        >> ends(0, loop=True) << Done(0, 1) << begins(0, 2)
    )  # fmt: skip
