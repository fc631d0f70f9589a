"""Stories of flows that wait for each other at synchronisation tags (§5.5.4, R-E04, decision 26)."""

from onika.engine.news import Abort, Finished, Killed, Run, Settled, Spawned, TurnedOn
from onika.engine.orders import Began, Done, End, Kill, Note, Settle, Start, Switch
from onika.testing import build
from onika.testing.play import Play

FREE = build.job("move", trigger="move")
MEET = build.job("move", trigger="move", synch_tag="meet")


def started(*flows):
    """A run in the first action of each flow, whose tasks are all ON."""
    numbers = range(len(flows))
    play = Play(build.engine(*flows)) >> Run() << build.spawns(*flows) >> [Spawned(flow, "move") for flow in numbers]
    for flow in numbers:
        play = play << begins(flow, 0)
    return play >> [TurnedOn(flow, "move") for flow in numbers]


def begins(flow, index):
    return [Switch(flow, (), (Start("move", "", 100.0),)), Began(flow, index)]


def waits(flow, other, ending=""):
    return Note(flow, f"waits at meet for flow {other}{ending}")


def test_a_tag_holds_a_flow_until_its_twin_arrives_and_both_begin_together():
    play = started([FREE, MEET], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << begins(0, 1) << begins(1, 1)
    )  # fmt: skip


def test_three_flows_wait_for_the_last_of_them():  # decision 26
    play = started([FREE, MEET], [FREE, MEET], [FREE, MEET]) >> TurnedOn(0, "move")
    assert (
        play
        >> Finished(2, "move") << Done(2, 0) << waits(2, 0) << waits(2, 1)
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << begins(0, 1) << begins(1, 1) << begins(2, 1)
    )  # fmt: skip


def test_a_flow_without_the_tag_is_not_waited_for():
    play = started([FREE, MEET], [FREE], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 2)
        >> Finished(2, "move") << Done(2, 0) << begins(0, 1) << begins(2, 1)
    )  # fmt: skip


def test_a_tag_on_the_first_action_holds_it():
    assert (
        Play(build.engine([MEET], [FREE, MEET]))
        >> Run() << build.spawns([MEET], [FREE, MEET])
        >> [Spawned(0, "move"), Spawned(1, "move")] << waits(0, 1) << begins(1, 0)
        >> TurnedOn(1, "move")
        >> Finished(1, "move") << Done(1, 0) << begins(0, 0) << begins(1, 1)
    )  # fmt: skip


def test_repeated_tags_pair_in_their_order():  # decision 26
    play = started([FREE, MEET, MEET], [FREE, MEET, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << begins(0, 1) << begins(1, 1)
        >> [TurnedOn(0, "move"), TurnedOn(1, "move")]
        >> Finished(1, "move") << Done(1, 1) << waits(1, 0)
        >> Finished(0, "move") << Done(0, 1) << begins(0, 2) << begins(1, 2)
    )  # fmt: skip


def test_a_flow_that_waits_for_an_ended_one_is_reported():  # decision 26
    play = started([FREE, MEET, MEET], [FREE, MEET])
    met = (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << begins(0, 1) << begins(1, 1)
        >> [TurnedOn(0, "move"), TurnedOn(1, "move")]
    )  # fmt: skip
    assert (
        met
        >> Finished(0, "move") << Done(0, 1) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 1) << waits(0, 1, ", which has ended")
    )  # fmt: skip


def test_a_flow_that_comes_to_wait_for_an_ended_one_is_reported():  # decision 26
    play = started([FREE, MEET, MEET], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Finished(1, "move") << Done(1, 0) << begins(0, 1) << begins(1, 1)
        >> [TurnedOn(0, "move"), TurnedOn(1, "move")]
        >> Finished(1, "move") << Done(1, 1)
        >> Finished(0, "move") << Done(0, 1) << waits(0, 1, ", which has ended")
    )  # fmt: skip


def test_a_tag_that_no_other_flow_has_holds_nobody():  # decision 27
    assert (
        started([FREE, MEET])
        >> Finished(0, "move") << Done(0, 0) << begins(0, 1)
        >> TurnedOn(0, "move")
        >> Finished(0, "move") << Done(0, 1) << Settle()
        >> Settled() << Kill(0, "move")
        >> Killed(0, "move") << End(True)
    )  # fmt: skip


def test_a_waiting_flow_can_be_aborted():  # R-E07
    play = started([FREE, MEET], [FREE, MEET])
    assert (
        play
        >> Finished(0, "move") << Done(0, 0) << waits(0, 1)
        >> Abort("stop") << Kill(0, "move") << Kill(1, "move")
        >> Killed(0, "move")
        >> Killed(1, "move") << End(False, "stop")
    )  # fmt: skip
