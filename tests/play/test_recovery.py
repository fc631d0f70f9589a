"""Stories of errors between two actions, and of what else the user may want of a flow in error (R-E08, reading 28)."""

import pytest

from kit.engine.error_lines import AGAIN, MEET, REACH, clearing, finish, on, paused, running, started, stopped, where
from kit.plans import build
from onika.engine.news import Cleared, Failed, Finished, Killed, Refused, Settled
from onika.engine.orders import Began, Clear, Done, End, Kill, Moved, Off, RunNote, Settle, Switch, Together
from onika.wire.steer import Pause, Recover, Resume, Skip, Step
from onika.words.reason import Reason

# Between two actions


def test_a_flow_that_was_paused_pauses_again_with_its_task_back_on_and_nothing_moves():  # R-E08
    assert (
        started()
        >> Pause("0") << Moved(0, "running", 0, text=Reason.plain("pauses after its current action"))
        >> Finished(0, "move") << Done(0, 0) << paused()
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("puma")) << paused()
        >> Resume("0") << Switch(0, (), on("move", arguments="3 4")) << running(1)
    )  # fmt: skip


def test_a_trigger_that_fails_after_its_action_does_not_come_back_in_the_pause():  # R-E08, reading 16
    job = build.job("move", "timer", trigger="move", arguments="1 2")
    assert (
        started([job, job], others=[(0, "timer")])
        >> Pause("0") << Moved(0, "running", 0, text=Reason.plain("pauses after its current action"))
        >> Finished(0, "timer") << Done(0, 0) << paused()
        >> Failed(0, "move", Reason.plain("gave up")) << stopped(task="move", text="gave up")
        >> Recover("0") << clearing() << Clear(0, "move")
        >> Cleared(0, "move") << paused()
        >> Resume("0") << Switch(0, (), on("move", "timer")) << running(1)
    )  # fmt: skip


def waiting():
    """Flow 0 waits at a tag for flow 1."""
    return (
        started([REACH, MEET], [REACH, MEET])
        >> Finished(0, "move") << Done(0, 0) << Moved(0, "waiting", 0, "meet", (1,))
    )  # fmt: skip


def test_a_flow_that_was_waiting_waits_again_with_its_task_back_on():  # R-E08, reading 26
    assert (
        waiting()
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("puma")) << Moved(0, "waiting", 0, "meet", (1,))
        >> Finished(1, "move") << Done(1, 0) << Together("meet", (0, 1))
        << Switch(0, (), on("move", arguments="5 6")) << running(1)
        << Switch(1, (), on("move", arguments="5 6")) << Began(1, 1)
    )  # fmt: skip


def test_the_others_run_on_to_their_next_tag_and_wait_there_for_who_has_stopped():  # reading 28
    assert (
        waiting()
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped()
        >> Finished(1, "move") << Done(1, 0) << Moved(1, "waiting", 0, "meet", (0,))
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("puma")) << Together("meet", (0, 1))
        << Switch(0, (), on("move", arguments="5 6")) << running(1)
        << Switch(1, (), on("move", arguments="5 6")) << running(1, flow=1)
    )  # fmt: skip


def test_an_error_in_an_action_holds_up_nobody_before_his_tag():  # reading 28
    assert (
        started([REACH, MEET], [REACH, AGAIN, MEET])
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Finished(1, "move") << Done(1, 0) << Switch(1, (), on("move", arguments="3 4")) << Began(1, 1)
        >> finish(1) << Done(1, 1) << Moved(1, "waiting", 1, "meet", (0,))
    )  # fmt: skip


def test_a_flow_that_had_waited_behind_a_no_op_gets_its_task_back():  # R-E08, R-D11
    play = (
        started([REACH, build.noop(), MEET], [REACH, MEET])
        >> Finished(0, "move") << Done(0, 0) << Began(0, 1) << Done(0, 1) << Moved(0, "waiting", 1, "meet", (1,))
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped(1)
        >> Recover("0") << clearing(1) << Clear(0, "puma")
    )  # fmt: skip
    assert play >> Cleared(0, "puma") << Switch(0, (), on("puma")) << Moved(0, "waiting", 1, "meet", (1,))


def test_a_flow_that_was_done_is_done_again_and_the_application_ends_after_all():  # R-E08, R-E14
    assert (
        started([REACH])
        >> Finished(0, "move") << Done(0, 0) << Moved(0, "done", 0) << Settle()
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped()
        >> Settled()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("puma")) << Moved(0, "done", 0) << Settle()
        >> Settled() << Kill(0, "move") << Kill(0, "puma")
        >> [Killed(0, "move")]
        >> Killed(0, "puma") << End(True)
    )  # fmt: skip


def test_a_flow_that_was_done_is_sent_nowhere_while_it_is_in_error():  # R-E13
    play = started([REACH, AGAIN]) >> Skip("0", 1) << RunNote(0, Reason.plain(f"{where(0, 0)}: left by the user"))
    play = play << Switch(0, ("move",), on("move", arguments="3 4")) << Began(0, 1) >> finish() << Done(0, 1)
    play = play << Moved(0, "done", 1) << Settle() >> Failed(0, "puma", Reason.plain("joint limit")) << stopped(1)
    assert play.refuses(Skip("0", 0), "found it stopped")


# What else the user may want of a flow in error


def test_a_flow_in_error_can_be_sent_to_another_action_once_it_is_cleared():  # R-E08, R-E13
    assert (
        started([REACH, AGAIN, REACH])
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Skip("0", 2) << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(2)
        >> finish() << Done(0, 2) << Moved(0, "done", 2) << Settle()
    )  # fmt: skip


def test_a_flow_in_error_can_be_sent_to_the_next_action():  # R-E07, R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Skip("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma", arguments="3 4")) << running(1)
    )  # fmt: skip


def test_where_a_flow_in_error_was_sent_it_still_goes_when_clearing_took_two_attempts():  # R-E08, R-E13
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Skip("0", 1) << clearing() << Clear(0, "puma")
        >> Refused(0, "puma", Reason.plain("panic button"))
        << Moved(0, "stopped", 0, text=Reason.plain(f"{where(0, 0)}: puma is not cleared: panic button"))
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma", arguments="3 4")) << running(1)
        >> finish() << Done(0, 1) << Moved(0, "done", 1) << Settle()
    )  # fmt: skip


@pytest.mark.parametrize("kind", [Pause, Step])
def test_a_flow_in_error_pauses_after_the_repeated_step_if_the_user_wants(kind):  # R-E07, R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> kind("0") << Moved(0, "stopped", 0, text=Reason.plain("pauses after its current action"))
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
        >> finish() << Done(0, 0) << paused()
    )  # fmt: skip


def test_a_flow_that_failed_at_a_tag_pauses_there_if_the_user_wants():  # R-E07, R-E08
    assert (
        waiting()
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped()
        >> Pause("0") << Moved(0, "stopped", 0, text=Reason.plain("pauses after its current action"))
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("puma")) << paused()
        >> Resume("0") << Moved(0, "waiting", 0, "meet", (1,))
    )  # fmt: skip
