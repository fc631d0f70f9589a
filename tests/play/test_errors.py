"""Stories of errors that stop a flow, and of users who clear them and go on (§4.5.2, §5.9.2, R-E08, reading 28)."""

import pytest

from kit.engine.error_lines import REACH, clearing, finish, on, running, started, stopped, where
from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Abort, Cleared, Failed, Finished, Killed, Refused, Run, Spawned, TurnedOn
from onika.engine.orders import Began, Clear, Done, End, Kill, Moved, Off, RunNote, Switch
from onika.wire.steer import Recover
from onika.words.reason import Reason


def test_an_error_stops_the_flow_with_its_trigger_off_and_the_step_is_repeated_with_the_same_target():  # R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
        >> finish() << Done(0, 0) << Switch(0, (), on("move", arguments="3 4")) << Began(0, 1)
    )  # fmt: skip


def test_an_error_of_the_trigger_itself_leaves_the_others_on_and_only_it_comes_back():  # R-E08
    assert (
        started()
        >> Failed(0, "move", Reason.plain("out of reach")) << stopped(task="move", text="out of reach")
        >> Recover("0") << clearing() << Clear(0, "move")
        >> Cleared(0, "move") << Switch(0, (), on("move")) << running(0)
    )  # fmt: skip


def test_two_tasks_in_error_are_both_cleared_and_come_on_in_one_switch():  # R-E08
    job = build.job("move", "pd", "puma", trigger="move", arguments="1 2")
    assert (
        started([job])
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Failed(0, "pd", Reason.plain("no number")) << stopped(task="pd", text="no number")
        >> Recover("0") << clearing() << Clear(0, "pd") << Clear(0, "puma")
        >> Cleared(0, "puma")
        >> Cleared(0, "pd") << Switch(0, (), on("move", "pd", "puma")) << running(0)
    )  # fmt: skip


def test_the_trigger_may_fail_after_another_task():  # R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Failed(0, "move", Reason.plain("gave up")) << stopped(task="move", text="gave up")
        >> Recover("0") << clearing() << Clear(0, "move") << Clear(0, "puma")
        >> [Cleared(0, "move")]
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
    )  # fmt: skip


def test_an_error_that_comes_again_stops_the_flow_again():  # R-E08
    play = started()
    for _ in range(3):
        play = (
            play
            >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
            >> Recover("0") << clearing() << Clear(0, "puma")
            >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
            >> [TurnedOn(0, "puma"), TurnedOn(0, "move")]
        )  # fmt: skip
    assert play >> Finished(0, "move") << Done(0, 0) << Switch(0, (), on("move", arguments="3 4")) << Began(0, 1)


def test_a_task_that_fails_while_it_is_cleared_leaves_the_flow_stopped():  # R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Failed(0, "puma", Reason.plain("panic button")) << stopped(text="panic button")
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
    )  # fmt: skip


def test_a_task_that_will_not_be_cleared_leaves_the_flow_stopped_with_the_reason():  # R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Refused(0, "puma", Reason.plain("panic button"))
        << Moved(0, "stopped", 0, text=Reason.plain(f"{where(0, 0)}: puma is not cleared: panic button"))
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
    )  # fmt: skip


def two_failed():
    """The flow stands still for two tasks."""
    job = build.job("move", "pd", "puma", trigger="move", arguments="1 2")
    return (
        started([job])
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Failed(0, "pd", Reason.plain("no number")) << stopped(task="pd", text="no number")
        >> Recover("0") << clearing() << Clear(0, "pd") << Clear(0, "puma")
    )  # fmt: skip


def test_of_two_that_will_not_be_cleared_both_reasons_are_told():  # R-E08
    assert (
        two_failed()
        >> Refused(0, "pd", Reason.plain("no number"))
            << Moved(0, "stopped", 0, text=Reason.plain(f"{where(0, 0)}: pd is not cleared: no number"))
        >> Refused(0, "puma", Reason.plain("panic button"))
            << RunNote(0, Reason.plain(f"{where(0, 0)}: puma is not cleared: panic button"))
        >> Recover("0") << clearing() << Clear(0, "pd") << Clear(0, "puma")
    )  # fmt: skip


def test_a_task_that_was_cleared_twice_does_no_harm_when_the_second_time_is_refused():  # R-E08
    assert (
        two_failed()
        >> Failed(0, "puma", Reason.plain("joint limit")) << stopped()
        >> Recover("0") << clearing() << Clear(0, "pd") << Clear(0, "puma")
        >> [Cleared(0, "pd"), Refused(0, "pd", Reason.plain("it is OFF"))]
        >> Cleared(0, "puma") << Switch(0, (), on("move", "pd", "puma")) << running(0)
    )  # fmt: skip


def test_a_task_that_was_cleared_before_the_user_says_so_is_not_cleared_again():  # R-E08
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Cleared(0, "puma")
        >> Recover("0") << clearing() << Switch(0, (), on("move", "puma")) << running(0)
    )  # fmt: skip


def test_a_task_that_would_not_come_on_stops_the_flow_and_the_step_can_be_repeated():  # R-E08
    text = f"{where(0, 0)}: move cannot be turned on: endpoint 9 is above 3.1"
    assert (
        started()
        >> Refused(0, "move", Reason.plain("endpoint 9 is above 3.1"))
            << Moved(0, "stopped", 0, text=Reason.plain(text))
        >> Recover("0") << clearing() << Switch(0, (), on("move")) << running(0)
    )  # fmt: skip


def test_a_task_that_had_no_part_in_the_action_stays_off_when_it_is_cleared():  # R-E08
    other = build.job("move", "grip", trigger="move", arguments="3 4")
    assert (
        started([REACH, other])
        >> Failed(0, "grip", Reason.plain("no air")) << Off(0, "move") << stopped(task="grip", text="no air")
        >> Recover("0") << clearing() << Clear(0, "grip")
        >> Cleared(0, "grip") << Switch(0, (), on("move")) << running(0)
    )  # fmt: skip


def test_every_trigger_of_the_action_goes_off_at_an_error_and_comes_back():  # R-E08, reading 16
    job = build.job("move", "timer", "puma", trigger="move", arguments="1 2")
    assert (
        started([job], others=[(0, "timer")])
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << Off(0, "timer") << stopped()
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "timer", "puma")) << running(0)
    )  # fmt: skip


def test_a_finish_that_comes_after_the_error_does_not_end_the_action():  # R-E08
    ignored = RunNote(0, Reason.plain(f"{where(0, 0)}: move has finished, which ends no action now: ignored"))
    assert (
        started()
        >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
        >> Finished(0, "move") << ignored
        >> Recover("0") << clearing() << Clear(0, "puma")
        >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
    )  # fmt: skip


def test_an_error_of_a_passive_task_stops_nobody():  # reading 17
    job = build.job("move", "view", trigger="move", arguments="1 2")
    sentence = f"{where(0, 0)}: view is in error and stays off, the job goes on: no screen"
    assert (
        started([job], passive=[(0, "view")])
        >> Failed(0, "view", Reason.plain("no screen"))
        << RunNote(0, Reason.plain(sentence))
    )


def test_what_failed_can_be_asked():  # R-X06
    play = started() >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
    assert (play.position(0).state, play.position(0).failed) == ("stopped", ("puma",))
    play = play >> Recover("0") << clearing() << Clear(0, "puma")
    assert play >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
    assert play.position(0).failed == ()


def test_only_a_flow_in_error_is_recovered():  # R-E08
    assert started().refuses(Recover("0"), "expected flow 0 to be stopped at an error, found it running")


def test_an_error_before_all_tasks_live_ends_the_run():  # R-E08
    engine = build.engine([REACH], stands_still=True)
    play = Play(engine) >> Run() << build.spawns([REACH]) >> Spawned(0, "move")
    assert (
        play
        >> Failed(0, "puma", Reason.plain("no drive")) << Kill(0, "move") << Kill(0, "puma")
        >> [Killed(0, "move")]
        >> Killed(0, "puma") << End(False, Reason.plain("puma.rmod: puma is in error: no drive"))
    )  # fmt: skip


@pytest.mark.parametrize("recovering", [False, True])
def test_a_flow_in_error_can_be_aborted(recovering):  # R-E07, R-E08
    play = started() >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
    play = play >> Recover("0") << clearing() << Clear(0, "puma") if recovering else play
    play = (
        play
        >> Abort(Reason.plain("stop"))
        << Kill(0, "move")
        << Kill(0, "puma")
        >> [Cleared(0, "puma"), Killed(0, "move")]
    )
    assert play >> Killed(0, "puma") << End(False, Reason.plain("stop"))
