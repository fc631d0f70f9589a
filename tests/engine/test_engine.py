import sys

import pytest

from kit.engine.play import Play
from kit.plans import build
from onika.engine.engine import Engine
from onika.engine.news import Abort, Finished, Killed, Run, Settled, Spawned, TurnedOn
from onika.engine.orders import Began, Done, End, Launch, Moved, RunNote, Settle, Spawn, Switch
from onika.words.reason import Reason

REACH = build.job("move", trigger="move", arguments="1 2")


def test_a_plan_without_flows_is_refused():
    with pytest.raises(ValueError, match="at least one flow"):
        build.engine()


def test_a_plan_whose_triggers_are_not_given_is_refused():
    with pytest.raises(KeyError):
        Engine(build.plan([REACH]), triggers={}, passive=set(), ranks={(0, "move"): 0})


def test_a_plan_whose_ranks_are_not_given_is_refused():
    with pytest.raises(KeyError):
        Engine(build.plan([REACH]), triggers={(0, 0): "move"}, passive=set(), ranks={})


def test_an_engine_runs_once():
    play = Play(build.engine([REACH])) >> Run() << Spawn(0, "move") >> Run()
    assert play


def test_settled_means_nothing_before_all_is_done():
    play = Play(build.engine([REACH])) >> Settled() >> Run() << Spawn(0, "move") >> Settled()
    assert play


def test_news_of_an_unknown_task_is_noted():
    play = (
        Play(build.engine([REACH]))
        >> Run() << Spawn(0, "move")
        >> Finished(0, "ghost") << RunNote(0, Reason.plain("ghost is no task of this flow: ignored"))
    )  # fmt: skip
    assert play


def test_a_flow_without_actions_is_done_at_once():
    assert Play(build.engine([])) >> Run() << Moved(0, "done", -1) << Settle() >> Settled() << End(True)


def test_the_end_waits_for_all_flows():  # R-E14
    play = (
        Play(build.engine([], [REACH]))
        >> Run() << Spawn(1, "move")
        >> Spawned(1, "move") << Moved(0, "done", -1)
        << Switch(1, (), (Launch("move", "1 2", 100.0),)) << Began(1, 0)
        >> TurnedOn(1, "move")
        >> Finished(1, "move") << Done(1, 0) << Moved(1, "done", 0) << Settle()
    )  # fmt: skip
    assert play


def test_an_abort_before_the_run_ends_it_and_a_later_run_does_nothing():
    assert (
        Play(build.engine([REACH]))
        >> Abort(Reason.plain("changed my mind"))
        << End(False, Reason.plain("changed my mind"))
        >> Run()
    )


def test_news_after_the_end_is_harmless():
    play = Play(build.engine([REACH])) >> Abort(Reason.plain("no")) << End(False, Reason.plain("no"))
    assert (
        play
        >> Killed(0, "move")
        >> Spawned(0, "move")
        >> Finished(0, "move")
        >> Settled()
        >> Abort(Reason.plain("again"))
    )


def steps_of_feed(actions):
    """Lines of Python run while the engine hears the finish of one action in the middle of a plan."""
    engine = build.engine([build.job("move", "puma", trigger="move")] * actions)
    engine.feed(Run())
    for task in ("move", "puma"):
        engine.feed(Spawned(0, task))
    for _ in range(actions // 2):
        engine.feed(TurnedOn(0, "move"))
        engine.feed(Finished(0, "move"))
    engine.feed(TurnedOn(0, "move"))
    lines = 0

    def trace(frame, event, argument):
        nonlocal lines
        lines += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        engine.feed(Finished(0, "move"))
    finally:
        sys.settrace(before)
    return lines


def test_a_finish_costs_the_same_in_a_long_plan_as_in_a_short_one():
    assert steps_of_feed(1000) == steps_of_feed(4)
