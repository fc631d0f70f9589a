"""Stories of users who pause, step, skip and let pass (§5.9.2, R-E07, R-E13)."""

import pytest

from kit.engine.play import Play
from kit.engine.play_lines import JOB, NOOP, begins, ends, goes_on, opened, passes, started
from kit.plans import build
from kit.plans.flow_program import bottom, program
from onika.engine.news import Abort, Killed, Run, Spawned, TurnedOn
from onika.engine.orders import Done, End, Kill, Launch, Moved, Off, RunNote, Settle, Switch, Together
from onika.wire.plan import Do
from onika.wire.steer import Leave, Mark, Pass, Pause, Recover, Resume, Skip, Step
from onika.words.reason import Reason

MEET = build.job("move", trigger="move", synch_tag="meet")
WILL_PAUSE = "pauses after its current action"


def will_pause(flow, index, state="running"):
    return Moved(flow, state, index, text=Reason.plain(WILL_PAUSE))


def paused(flow, index):
    return Moved(flow, "paused", index)


def left(flow, index):
    """The user leaves an action whose trigger is ON."""
    return [RunNote(flow, Reason.plain(f"test.appl flow {flow} action {index}: left by the user")), Off(flow, "move")]


# Pause


def test_a_pause_comes_after_the_current_action_and_ends_when_the_user_goes_on():  # R-E07
    assert (
        started([JOB, JOB])
        >> Pause("0") << will_pause(0, 0)
        >> ends(0) << Done(0, 0) << paused(0, 0)
        >> Resume("0") << goes_on(0, 1)
        >> ends(0) << Done(0, 1) << Moved(0, "done", 1) << Settle()
    )  # fmt: skip


def test_a_pause_can_be_taken_back_before_it_comes():  # R-E07
    assert (
        started([JOB, JOB])
        >> Pause("0") << will_pause(0, 0)
        >> Resume("0") << Moved(0, "running", 0, text=Reason.plain("does not pause"))
        >> ends(0) << Done(0, 0) << begins(0, 1)
    )  # fmt: skip


def test_a_pause_before_the_first_action_holds_the_flow_when_its_tasks_live():  # R-E07
    assert (
        opened([JOB])
        >> Pause("0") << Moved(0, "spawning", -1, text=Reason.plain("pauses before its first action"))
        >> Spawned(0, "move") << paused(0, -1)
        >> Resume("0") << goes_on(0, 0)
    )  # fmt: skip


def test_a_pause_holds_one_flow_and_the_others_run_on():  # R-E07
    play = started([JOB, JOB], [JOB, JOB], first=[Together("", (0, 1)), *begins(0, 0), *begins(1, 0)])
    assert (
        play
        >> Pause("1") << will_pause(1, 0)
        >> ends(0) << Done(0, 0) << begins(0, 1)
        >> ends(1) << Done(1, 0) << paused(1, 0)
        >> ends(0) << Done(0, 1) << Moved(0, "done", 1)
        >> Resume("1") << goes_on(1, 1)
        >> ends(1) << Done(1, 1) << Moved(1, "done", 1) << Settle()
    )  # fmt: skip


def test_a_pause_after_the_last_action_keeps_the_application_from_ending():  # R-E07, R-E14
    assert (
        started([JOB])
        >> Pause("0") << will_pause(0, 0)
        >> ends(0) << Done(0, 0) << paused(0, 0)
        >> Resume("0") << Moved(0, "done", 0) << Settle()
    )  # fmt: skip


def waiting():
    """Flow 0 waits at a tag for flow 1, whose first action runs."""
    return (
        started([JOB, MEET, JOB], [JOB, MEET], first=[Together("", (0, 1)), *begins(0, 0), *begins(1, 0)])
        >> ends(0) << Done(0, 0) << waits(0, 1)
    )  # fmt: skip


def waits(flow, other, after=0, text=""):
    return Moved(flow, "waiting", after, "meet", (other,), text)


def test_a_flow_that_waits_pauses_at_once_and_is_waited_for():  # R-E07, reading 26
    assert (
        waiting()
        >> Pause("0") << paused(0, 0)
        >> ends(1) << Done(1, 0) << waits(1, 0)
        >> Resume("0") << Together("meet", (0, 1)) << goes_on(0, 1) << goes_on(1, 1)
    )  # fmt: skip


def test_a_flow_that_was_paused_at_a_tag_waits_again_when_it_goes_on():  # R-E07
    assert (
        waiting()
        >> Pause("0") << paused(0, 0)
        >> Resume("0") << waits(0, 1)
        >> ends(1) << Done(1, 0) << Together("meet", (0, 1)) << goes_on(0, 1) << begins(1, 1)
    )  # fmt: skip


def test_who_is_paused_cannot_be_paused_and_who_is_not_cannot_go_on():  # R-E07
    play = started([JOB, JOB]).refuses(Resume("0"), "expected flow 0 to be paused, found it running")
    assert (
        play
        >> Pause("0") << will_pause(0, 0)
        >> ends(0) << Done(0, 0) << paused(0, 0)
    ).refuses(Pause("0"), "flow 0 is paused already")  # fmt: skip


# Step


def test_a_step_is_one_action():  # R-E07
    assert (
        started([JOB, JOB, JOB])
        >> Step("0") << will_pause(0, 0)
        >> ends(0) << Done(0, 0) << paused(0, 0)
        >> Step("0") << goes_on(0, 1)
        >> ends(0) << Done(0, 1) << paused(0, 1)
        >> Step("0") << goes_on(0, 2)
        >> ends(0) << Done(0, 2) << paused(0, 2)
        >> Step("0") << Moved(0, "done", 2) << Settle()
    )  # fmt: skip


def test_a_no_op_is_a_step():  # R-E07, R-D11
    play = started([JOB, NOOP, NOOP, JOB]) >> Step("0") << will_pause(0, 0) >> ends(0) << Done(0, 0) << paused(0, 0)
    assert (
        play
        >> Step("0") << passes(0, 1) << paused(0, 1)
        >> Step("0") << passes(0, 2) << paused(0, 2)
        >> Step("0") << goes_on(0, 3)
    )  # fmt: skip


def test_a_step_to_a_tag_waits_there_and_pauses_after_its_action():  # R-E07, reading 26
    assert (
        waiting()
        >> Pause("0") << paused(0, 0)
        >> Step("0") << waits(0, 1)
        >> ends(1) << Done(1, 0) << Together("meet", (0, 1)) << goes_on(0, 1) << begins(1, 1)
        >> ends(0) << Done(0, 1) << paused(0, 1)
    )  # fmt: skip


def test_steps_go_round_a_loop():  # R-E07
    play = started(build.flow([JOB, JOB], program(bottom("round", Do(0)), Do(1)))) >> Step("0") << will_pause(0, 0)
    play = play >> ends(0, loop=True) << Done(0, 0) << paused(0, 0)
    assert play >> Step("0") << goes_on(0, 0) >> ends(0) << Done(0, 0) << paused(0, 0) >> Step("0") << goes_on(0, 1)


# Skip


def test_a_skip_leaves_the_action_at_once_and_goes_to_the_next():  # R-E07
    play = started([JOB, JOB]) >> TurnedOn(0, "move")
    play = play >> Skip("0") << left(0, 0)[:1] << begins(0, 1, ["move"])
    assert play >> ends(0) << Done(0, 1) << Moved(0, "done", 1) << Settle()


def test_a_skip_of_the_last_action_ends_the_flow():  # R-E07
    play = started([JOB]) >> TurnedOn(0, "move")
    assert play >> Skip("0") << left(0, 0) << Moved(0, "done", 0) << Settle()


@pytest.mark.parametrize("to", [0, 1, 3])
def test_a_skip_goes_to_any_action_forwards_and_backwards_and_nothing_between_is_carried_out(to):  # R-E13
    play = started([JOB, JOB, JOB, JOB]) >> ends(0) << Done(0, 0) << begins(0, 1) >> TurnedOn(0, "move")
    assert play >> Skip("0", to) << left(0, 1)[:1] << begins(0, to, ["move"])


def test_a_skip_into_a_loop_goes_round_in_it():  # R-E13
    script = program(Do(0), bottom("round", Do(1), Do(2)), Do(3))
    assert (
        started(build.flow([JOB] * 4, script)) >> TurnedOn(0, "move")
        >> Skip("0", 2) << left(0, 0)[:1] << begins(0, 2, ["move"])
        >> ends(0, loop=True) << Done(0, 2) << begins(0, 1)
    )  # fmt: skip


def test_a_skip_to_an_action_with_a_tag_waits_at_it():  # R-E13, reading 26
    play = started([JOB, JOB, MEET], [JOB, MEET], first=[Together("", (0, 1)), *begins(0, 0), *begins(1, 0)])
    assert (
        play >> TurnedOn(0, "move")
        >> Skip("0", 2) << left(0, 0) << waits(0, 1)
        >> ends(1) << Done(1, 0) << Together("meet", (0, 1)) << goes_on(0, 2) << begins(1, 1)
    )  # fmt: skip


def test_a_skip_from_a_tag_is_no_visit_of_it():  # R-E13, reading 26
    assert (
        waiting()
        >> Skip("0", 2) << goes_on(0, 2)
        >> ends(1) << Done(1, 0) << waits(1, 0)
        >> ends(0) << Done(0, 2) << Moved(0, "done", 2) << waits(1, 0, text="flow 0 has ended and will not come")
        >> Pass("1") << goes_on(1, 1)
    )  # fmt: skip


def test_a_skip_from_a_pause_goes_on_there():  # R-E13
    play = started([JOB, JOB, JOB]) >> Pause("0") << will_pause(0, 0) >> ends(0) << Done(0, 0) << paused(0, 0)
    assert play >> Skip("0", 2) << goes_on(0, 2)


def test_a_skip_ends_an_action_without_a_trigger():  # R-E07
    hold = build.job("puma")
    play = (
        Play(build.engine([hold, hold]))
        >> Run() << build.spawns([hold])
        >> Spawned(0, "puma") << Switch(0, (), (Launch("puma", "", 100.0),)) << begins(0, 0)[1:]
        << RunNote(0, Reason.plain("test.appl flow 0 action 0: action 0 has no trigger: it goes on until you skip it"))
    )  # fmt: skip
    assert (
        play >> TurnedOn(0, "puma")
        >> Skip("0") << RunNote(0, Reason.plain("test.appl flow 0 action 0: left by the user"))
        << Switch(0, (), ()) << begins(0, 1)[1:]
        << RunNote(0, Reason.plain("test.appl flow 0 action 1: action 1 has no trigger: it goes on until you skip it"))
    )  # fmt: skip


def test_a_trigger_that_finishes_after_the_skip_ends_nothing():  # R-E07
    play = started([JOB, JOB, JOB]) >> TurnedOn(0, "move") >> Skip("0") << left(0, 0)[:1] << begins(0, 1, ["move"])
    ignored = RunNote(
        0, Reason.plain("test.appl flow 0 action 1: move has finished, which ends no action now: ignored")
    )
    assert play >> ends(0)[1:] << ignored >> ends(0) << Done(0, 1) << begins(0, 2)


@pytest.mark.parametrize("action", [-1, 2, 17])
def test_there_is_no_skip_to_an_action_that_is_not_there(action):  # R-E13
    why = f"expected an action from 1 to 2 of flow 0, found {action + 1}"
    assert started([JOB, JOB]).refuses(Skip("0", action), why)


def test_a_flow_that_waits_is_let_pass_and_not_sent_to_the_next_action():  # R-E07
    assert waiting().refuses(Skip("0"), "waits at a tag; let it pass, or skip to an action")


# Pass


def test_a_waiting_flow_is_let_pass_and_counts_as_having_been_there():  # R-E07, reading 26
    assert (
        waiting()
        >> Pass("0") << goes_on(0, 1)
        >> ends(1) << Done(1, 0) << begins(1, 1)
    )  # fmt: skip


def test_two_visits_let_pass_are_two_visits_that_nobody_waits_for():  # reading 26
    flows = [MEET, MEET, JOB], [JOB, MEET, MEET]
    assert (
        started(*flows, first=[waits(0, 1, after=-1), *begins(1, 0)])
        >> Pass("0") << goes_on(0, 0)
        >> ends(0) << Done(0, 0) << waits(0, 1)
        >> Pass("0") << goes_on(0, 1)
        >> ends(1) << Done(1, 0) << begins(1, 1)
        >> ends(1) << Done(1, 1) << begins(1, 2)
    )  # fmt: skip


def test_one_of_three_is_let_pass_and_the_other_two_meet():  # reading 26
    first = [*(Moved(flow, "waiting", -1, "meet", others) for flow, others in ((0, (1, 2)), (1, (2,)))), *begins(2, 0)]
    assert (
        started([MEET], [MEET], [JOB, MEET], first=first)
        >> Pass("0") << goes_on(0, 0)
        >> ends(2) << Done(2, 0) << Together("meet", (1, 2)) << goes_on(1, 0) << begins(2, 1)
    )  # fmt: skip


def test_only_who_waits_is_let_pass():  # R-E07
    assert started([JOB, JOB]).refuses(Pass("0"), "expected flow 0 to be waiting for another flow, found it running")


# At any time


EVERYTHING = [Pause("0"), Resume("0"), Step("0"), Skip("0"), Skip("0", 0), Pass("0"), Leave("0"), Recover("0")]


@pytest.mark.parametrize("news", EVERYTHING)
def test_before_the_run_nothing_is_steered(news):  # R-E07
    assert Play(build.engine([JOB])).refuses(news, "expected flow 0 to be")


@pytest.mark.parametrize("news", EVERYTHING)
def test_a_flow_that_is_done_is_not_steered(news):  # R-E07
    play = started([JOB]) >> ends(0) << Done(0, 0) << Moved(0, "done", 0) << Settle()
    assert play.refuses(news, "found it done")


@pytest.mark.parametrize("news", EVERYTHING)
def test_after_an_abort_nothing_is_steered_not_even_a_pause_that_was_to_come(news):  # R-E07
    play = started([JOB, JOB]) >> Pause("0") << will_pause(0, 0) >> Abort(Reason.plain("stop")) << Kill(0, "move")
    assert play.refuses(news, "found it killing") >> Killed(0, "move") << End(False, Reason.plain("stop"))


@pytest.mark.parametrize("flow", ["", "1"])
@pytest.mark.parametrize("kind", [Pause, Resume, Step, Skip, Pass, Leave, Recover, lambda flow: Mark(flow, 0)])
def test_a_flow_that_is_not_there_is_not_steered(kind, flow):
    assert started([JOB]).refuses(kind(flow), f"expected one of the flows 0, found {flow or 'none'}")
