"""Stories of passive tasks, which may fall silent and harm nothing, and of others that do (§C.2, reading 17)."""

from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Failed, Finished, Refused, Run, Spawned, SwitchedOff, TurnedOn
from onika.engine.orders import Began, Done, Launch, Moved, RunNote, Settle, Switch
from onika.words.reason import Reason

SHOW = build.job("move", "view", trigger="move")
WHERE = "test.appl flow 0 action"
BOTH = (Launch("move", "", 100.0), Launch("view", "", 100.0))
MOVE = (Launch("move", "", 100.0),)


def started(*jobs):
    """A run in its first action, SHOW; `view` is passive."""
    return (
        Play(build.engine(jobs or [SHOW, SHOW], passive=[(0, "view")]))
        >> Run() << build.spawns([SHOW])
        >> [Spawned(0, "move"), Spawned(0, "view")] << Switch(0, (), BOTH) << Began(0, 0)
        >> [TurnedOn(0, "move"), TurnedOn(0, "view")]
    )  # fmt: skip


def test_a_passive_task_that_switches_itself_off_is_tried_again_with_the_next_action():  # R-A08
    assert (
        started()
        >> SwitchedOff(0, "view")
            << RunNote(0, Reason.plain(f"{WHERE} 0: view has switched itself off: the job goes on"))
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), BOTH) << Began(0, 1)
    )  # fmt: skip


def test_a_passive_task_in_error_is_left_off_for_the_rest_of_the_run():  # reading 17
    assert (
        started()
        >> Failed(0, "view", Reason.plain("no screen"))
        << RunNote(0, Reason.plain(f"{WHERE} 0: view is in error and stays off, the job goes on: no screen"))
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), MOVE) << Began(0, 1)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 1) << Moved(0, "done", 1) << Settle()
    )  # fmt: skip


def test_a_passive_task_that_will_not_come_on_is_left_off():
    alone = build.job("move", trigger="move")
    assert (
        started(SHOW, alone, SHOW)
        >> Refused(0, "view", Reason.plain("broken"))
            << RunNote(0, Reason.plain(f"{WHERE} 0: view stays off, the job goes on: broken"))
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), MOVE) << Began(0, 1)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 1) << Switch(0, (), MOVE) << Began(0, 2)
    )  # fmt: skip


def test_a_passive_task_that_fails_at_its_spawn_holds_up_nobody():
    assert (
        Play(build.engine([SHOW], passive=[(0, "view")]))
        >> Run() << build.spawns([SHOW])
        >> Spawned(0, "move")
        >> Failed(0, "view", Reason.plain("no screen"))
        << RunNote(0, Reason.plain("view.rmod: view is in error and stays off, the job goes on: no screen"))
        << Switch(0, (), MOVE) << Began(0, 0)
    )  # fmt: skip


def test_another_task_that_switches_itself_off_is_noted_and_the_run_goes_on():  # Table 9
    engine = build.engine([SHOW])
    assert (
        Play(engine)
        >> Run() << build.spawns([SHOW])
        >> [Spawned(0, "move"), Spawned(0, "view")] << Switch(0, (), BOTH) << Began(0, 0)
        >> [TurnedOn(0, "move"), TurnedOn(0, "view")]
        >> SwitchedOff(0, "view")
        << RunNote(0, Reason.plain(f"{WHERE} 0: view has switched itself off: ignored, though it is not passive"))
        >> Finished(0, "move") << Done(0, 0) << Moved(0, "done", 0) << Settle()
    )  # fmt: skip
