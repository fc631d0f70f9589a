"""Stories of runs that go well (§5.9.2, R-E02, R-E03, R-E14)."""

from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Asked, Finished, Killed, Run, Settled, Spawned, TurnedOn
from onika.engine.orders import Began, Done, End, Kill, Launch, Moved, RunNote, Settle, Spawn, Switch, Together
from onika.words.reason import Reason

REACH = build.job("move", "pd", "puma", trigger="move", arguments="1 2")
AGAIN = build.job("move", "pd", "puma", trigger="move", arguments="3 4")
GRASP = build.job("grip", "pd", "puma", trigger="grip")


def on(*names, arguments="", frequency=100.0):
    """The starts of tasks, of which the first is the trigger."""
    return tuple(Launch(name, arguments if place == 0 else "", frequency) for place, name in enumerate(names))


def spawned(*names):
    return [Spawned(0, name) for name in names]


def killed(*names):
    return [Killed(0, name) for name in names]


def test_an_application_runs_from_the_first_spawn_to_the_last_kill():  # R-E02, R-E03
    assert (
        Play(build.engine([REACH, GRASP]))
        >> Run() << [Spawn(0, "move"), Spawn(0, "pd"), Spawn(0, "puma"), Spawn(0, "grip")]
        >> spawned("grip", "puma", "pd")
        >> Spawned(0, "move") << Switch(0, (), on("move", "pd", "puma", arguments="1 2")) << Began(0, 0)
        >> [TurnedOn(0, "move"), TurnedOn(0, "pd"), TurnedOn(0, "puma")]
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), on("grip")) << Began(0, 1)
        >> TurnedOn(0, "grip")
        >> Finished(0, "grip") << Done(0, 1) << Moved(0, "done", 1) << Settle()
        >> Settled() << [Kill(0, "move"), Kill(0, "pd"), Kill(0, "puma"), Kill(0, "grip")]
        >> killed("move", "pd", "puma")
        >> Killed(0, "grip") << End(True)
    )  # fmt: skip


def test_a_trigger_that_has_just_finished_comes_on_again_for_the_next_action_with_its_target():  # R-E03, law 6
    assert (
        Play(build.engine([REACH, AGAIN]))
        >> Run() << build.spawns([REACH, AGAIN])
        >> spawned("move", "pd", "puma") << Switch(0, (), on("move", "pd", "puma", arguments="1 2")) << Began(0, 0)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), on("move", arguments="3 4")) << Began(0, 1)
    )  # fmt: skip


def test_tasks_that_are_not_wanted_any_more_go_off_at_the_switch_and_not_before():  # law 6
    look = build.job("look", "camera", trigger="look")
    assert (
        Play(build.engine([REACH, look]))
        >> Run() << build.spawns([REACH, look])
        >> spawned("move", "pd", "puma", "look", "camera")
        << Switch(0, (), on("move", "pd", "puma", arguments="1 2")) << Began(0, 0)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 0) << Switch(0, ("pd", "puma"), on("look", "camera")) << Began(0, 1)
    )  # fmt: skip


def test_tasks_come_on_in_the_order_of_their_ranks():  # law 1
    engine = build.engine([REACH], ranks={"puma": 0, "move": 1, "pd": 2})
    starts = (Launch("puma", "", 100.0), Launch("move", "1 2", 100.0), Launch("pd", "", 100.0))
    assert (
        Play(engine)
        >> Run() << build.spawns([REACH])
        >> spawned("move", "pd", "puma") << Switch(0, (), starts) << Began(0, 0)
    )  # fmt: skip


def test_a_task_of_two_rates_changes_its_rate_at_the_switch():  # reading 13
    slow = build.job("grip", "puma", trigger="grip", rates={"puma": 50.0})
    assert (
        Play(build.engine([GRASP, slow]))
        >> Run() << build.spawns([GRASP, slow])
        >> spawned("grip", "pd", "puma") << Switch(0, (), on("grip", "pd", "puma")) << Began(0, 0)
        >> TurnedOn(0, "grip")
        >> Finished(0, "grip") << Done(0, 0) << Switch(0, ("pd",), on("grip"), (("puma", 50.0),)) << Began(0, 1)
    )  # fmt: skip


def test_no_flow_begins_before_the_tasks_of_all_flows_live():  # §5.9.2
    job = build.job("move", trigger="move")
    assert (
        Play(build.engine([job], [job]))
        >> Run() << [Spawn(0, "move"), Spawn(1, "move")]
        >> Spawned(0, "move")
        >> Spawned(1, "move")
        << [Together("", (0, 1)), Switch(0, (), on("move")), Began(0, 0), Switch(1, (), on("move")), Began(1, 0)]
    )  # fmt: skip


def test_a_flow_waits_while_its_trigger_asks():  # R-E03, R-A10
    play = started(REACH, GRASP)
    assert (
        play
        >> Asked(0, "move", Reason.plain("endpoint 9 is above 3.1"))
        << RunNote(0, Reason.plain("test.appl flow 0 action 0: move asks: endpoint 9 is above 3.1"))
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), on("grip")) << Began(0, 1)
    )  # fmt: skip


def test_any_task_may_ask_in_mid_run():  # R-E15
    assert (
        started(REACH) >> Asked(0, "puma", Reason.plain("power up the robot"))
        << RunNote(0, Reason.plain("test.appl flow 0 action 0: puma asks: power up the robot"))
    )  # fmt: skip


def test_a_job_without_a_trigger_goes_on_and_says_so():
    hold = build.job("puma")
    assert (
        Play(build.engine([hold, REACH]))
        >> Run() << build.spawns([hold, REACH])
        >> spawned("puma", "move", "pd") << Switch(0, (), on("puma")) << Began(0, 0)
        << RunNote(0, Reason.plain("test.appl flow 0 action 0: action 0 has no trigger: it goes on until you skip it"))
        >> TurnedOn(0, "puma")
    )  # fmt: skip


def test_a_finish_of_a_task_that_is_no_trigger_of_the_action_is_ignored():  # reading 16
    assert (
        started(REACH) >> TurnedOn(0, "puma") >> Finished(0, "puma")
        << RunNote(0, Reason.plain("test.appl flow 0 action 0: puma has finished, which ends no action now: ignored"))
    )  # fmt: skip


def test_the_second_finish_of_a_trigger_does_not_end_the_next_action():  # reading 16
    assert (
        started(REACH, AGAIN)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 0) << Switch(0, (), on("move", arguments="3 4")) << Began(0, 1)
        >> Finished(0, "move")
        << RunNote(0, Reason.plain("test.appl flow 0 action 1: move has finished, which ends no action now: ignored"))
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 1) << Moved(0, "done", 1) << Settle()
    )  # fmt: skip


def test_of_several_triggers_the_first_to_finish_ends_the_action():  # reading 16
    job = build.job("move", "timer", trigger="move", arguments="1 2")
    assert (
        Play(build.engine([job, GRASP], other_triggers=[(0, "timer")]))
        >> Run() << build.spawns([job, GRASP])
        >> spawned(*build.names([job, GRASP])) << Switch(0, (), on("move", "timer", arguments="1 2")) << Began(0, 0)
        >> [TurnedOn(0, "move"), TurnedOn(0, "timer")]
        >> Finished(0, "timer")
        << [Done(0, 0), Switch(0, ("move",), on("grip", "pd", "puma")), Began(0, 1)]
        >> Finished(0, "move")
        << RunNote(0, Reason.plain("test.appl flow 0 action 1: move has finished, which ends no action now: ignored"))
    )  # fmt: skip


def started(*jobs):
    """The story of one flow up to its first switch."""
    first = jobs[0]
    return (
        Play(build.engine(list(jobs)))
        >> Run() << build.spawns(jobs)
        >> spawned(*build.names(jobs)) << Switch(0, (), on(*first.tasks, arguments=first.arguments)) << Began(0, 0)
    )  # fmt: skip
