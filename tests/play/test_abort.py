"""Stories of runs that are ended before their time (§5.9.2, Table 9, R-E07, R-E08, R-E10)."""

import pytest

from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Abort, Failed, Finished, Illegal, Killed, Refused, Run, Settled, Spawned, TurnedOn
from onika.engine.orders import Began, Done, End, Kill, Launch, Moved, Settle, Switch, Together
from onika.words.reason import NOTHING, Reason

REACH = build.job("move", "puma", trigger="move")
WHERE = "test.appl flow 0 action 0"
KILLS = [Kill(0, "move"), Kill(0, "puma")]


def started():
    """A run in its only action."""
    return (
        Play(build.engine([REACH]))
        >> Run() << build.spawns([REACH])
        >> [Spawned(0, "move"), Spawned(0, "puma")]
        << Switch(0, (), (Launch("move", "", 100.0), Launch("puma", "", 100.0))) << Began(0, 0)
        >> [TurnedOn(0, "move"), TurnedOn(0, "puma")]
    )  # fmt: skip


def gone(play, cause):
    """The rest of the story once the kills are ordered."""
    return play >> Killed(0, "move") >> Killed(0, "puma") << End(False, cause)


def test_an_abort_kills_every_task_and_ends_once_they_are_gone():  # R-E07
    assert gone(started() >> Abort(Reason.plain("stop")) << KILLS, "stop")


def test_an_abort_while_tasks_are_being_spawned_kills_those_too():
    play = Play(build.engine([REACH])) >> Run() << build.spawns([REACH]) >> Spawned(0, "move")
    assert gone(play >> Abort(Reason.plain("stop")) << KILLS >> Spawned(0, "puma"), "stop")


def test_a_second_abort_changes_nothing_not_even_the_cause():
    assert gone(started() >> Abort(Reason.plain("stop")) << KILLS >> Abort(Reason.plain("stop!")), "stop")


def test_an_abort_without_a_cause_is_no_success():
    assert gone(started() >> Abort(NOTHING) << KILLS, "")


def test_what_tasks_say_while_they_are_being_killed_is_harmless():
    play = started() >> Abort(Reason.plain("stop")) << KILLS
    assert gone(
        play >> Finished(0, "move") >> Failed(0, "puma", Reason.plain("x")) >> Illegal(0, "puma", Reason.plain("y")),
        "stop",
    )


@pytest.mark.parametrize(
    ("news", "cause"),
    [
        (Failed(0, "puma", Reason.plain("joint limit")), f"{WHERE}: puma is in error: joint limit"),
        (Illegal(0, "puma", Reason.plain("panic button")), f"{WHERE}: puma may not go on: panic button"),
        (
            Refused(0, "move", Reason.plain("another writes Q_REF")),
            f"{WHERE}: move cannot be turned on: another writes Q_REF",
        ),
    ],
)
def test_what_goes_wrong_with_a_task_aborts_the_run_with_its_cause(news, cause):  # Table 9
    assert gone(started() >> news << KILLS, cause)


def test_a_task_that_cannot_be_spawned_aborts_the_run_and_is_not_killed():
    play = Play(build.engine([REACH])) >> Run() << build.spawns([REACH]) >> Spawned(0, "puma")
    cause = "move.rmod: move cannot be spawned: no such file"
    assert (
        play >> Refused(0, "move", Reason.plain("no such file")) << Kill(0, "puma")
        >> Killed(0, "puma") << End(False, Reason.plain(cause))
    )  # fmt: skip


def test_a_task_that_cannot_be_spawned_is_not_waited_for_after_an_abort():
    play = Play(build.engine([REACH])) >> Run() << build.spawns([REACH]) >> Abort(Reason.plain("stop")) << KILLS
    assert (
        play
        >> Killed(0, "puma")
        >> Refused(0, "move", Reason.plain("no such file"))
        << End(False, Reason.plain("stop"))
    )


def test_a_refused_activation_does_not_stand_for_the_kill():
    play = started() >> Abort(Reason.plain("stop")) << KILLS >> Refused(0, "move", Reason.plain("it is being killed"))
    assert play >> Killed(0, "puma") >> Killed(0, "move") << End(False, Reason.plain("stop"))


def test_a_task_that_comes_to_life_after_an_abort_is_gone_when_it_is_killed_and_not_before():
    play = Play(build.engine([REACH])) >> Run() << build.spawns([REACH]) >> Abort(Reason.plain("stop")) << KILLS
    play = play >> Killed(0, "move") >> Spawned(0, "puma") >> Refused(0, "puma", Reason.plain("it is being killed"))
    assert play >> Killed(0, "puma") << End(False, Reason.plain("stop"))


def test_a_task_that_dies_during_the_run_aborts_it():  # R-E10
    play = started() >> Killed(0, "puma") << Kill(0, "move")
    assert play >> Killed(0, "move") << End(False, Reason.plain(f"{WHERE}: puma is gone"))


def test_an_error_while_things_settle_is_no_success():
    play = started() >> Finished(0, "move") << Done(0, 0) << Moved(0, "done", 0) << Settle()
    assert gone(play >> Failed(0, "puma", Reason.plain("x")) << KILLS >> Settled(), f"{WHERE}: puma is in error: x")


def test_an_abort_after_everything_settled_comes_too_late():  # R-E14
    play = started() >> Finished(0, "move") << Done(0, 0) << Moved(0, "done", 0) << Settle() >> Settled() << KILLS
    assert play >> Abort(Reason.plain("stop")) >> Killed(0, "puma") >> Killed(0, "move") << End(True)


def test_an_abort_ends_all_flows():  # reading 28
    job = build.job("move", trigger="move")
    start = (Launch("move", "", 100.0),)
    assert (
        Play(build.engine([job], [job]))
        >> Run() << build.spawns([job], [job])
        >> [Spawned(0, "move"), Spawned(1, "move")]
        << [Together("", (0, 1)), Switch(0, (), start), Began(0, 0), Switch(1, (), start), Began(1, 0)]
        >> Failed(1, "move", Reason.plain("stuck")) << [Kill(0, "move"), Kill(1, "move")]
        >> Killed(1, "move")
        >> Killed(0, "move") << End(False, Reason.plain("test.appl flow 1 action 0: move is in error: stuck"))
    )  # fmt: skip
