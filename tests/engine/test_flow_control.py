from typing import get_args

import pytest

from kit.engine.play_lines import JOB, ends
from kit.plans import build
from kit.plans.flow_program import bottom, nested, program
from onika.engine.flow import FlowState
from onika.engine.news import Abort, Cleared, Failed, Run, Spawned, TurnedOn
from onika.engine.orders import Moved
from onika.wire.plan import Do, Meet
from onika.wire.steer import Leave, Mark, Pass, Pause, Recover, Resume, Skip, Steering, Step
from onika.words.reason import Reason

MEET = build.job("move", trigger="move", synch_tag="meet")
ALLOWED = {
    "ready": "Mark",
    "spawning": "Pause Step Mark",
    "running": "Pause Step Skip Mark",
    "waiting": "Pause Step Pass Mark Skip0",
    "joining": "Pause Step Pass Mark",
    "paused": "Resume Step Skip Mark",
    "stopped": "Pause Step Skip Mark Recover",
    "clearing": "Pause Step Mark",
    "done": "Mark",
    "killing": "Mark",
}
NEWS = {
    "Pause": Pause("0"),
    "Resume": Resume("0"),
    "Step": Step("0"),
    "Skip": Skip("0"),
    "Skip0": Skip("0", 0),
    "Pass": Pass("0"),
    "Leave": Leave("0"),
    "Mark": Mark("0", 0),
    "Recover": Recover("0"),
}


def brought(state):
    """An engine whose flow 0 is in this state, in no loop."""
    parent = build.flow([JOB, JOB], program(Do(0), nested([(1, 0)]), Do(1)))
    flows = {
        "waiting": ([JOB, MEET], [JOB, MEET]),
        "joining": (parent, build.flow([JOB], (), 0)),
    }.get(state, ([JOB, JOB],))
    spawned = [Spawned(spawn.flow, spawn.task) for spawn in build.spawns(*flows)]
    begun = [Run(), *spawned, TurnedOn(0, "move")]
    stopped = [*begun, Failed(0, "move", Reason.plain("x"))]
    story = {
        "ready": [],
        "spawning": [Run()],
        "paused": [*begun, Pause("0"), *ends(0)],
        "waiting": [*begun, *ends(0)],
        "joining": [*begun, *ends(0)],
        "stopped": stopped,
        "clearing": [*stopped, Recover("0")],
        "done": [*begun, *ends(0), *ends(0)],
        "killing": [*begun, Abort(Reason.plain("stop"))],
    }.get(state, begun)
    engine = build.engine(*flows, stands_still=True)
    for news in story:
        engine.feed(news)
    assert engine.positions()[0].state == state
    return engine


@pytest.mark.parametrize("state", ALLOWED)
@pytest.mark.parametrize("name", NEWS)
def test_what_is_refused_changes_nothing_and_what_is_not_is_done(state, name):  # R-E07
    engine = brought(state)
    allowed = ALLOWED[state].split()
    may = name in allowed or (name == "Skip0" and "Skip" in allowed)
    before = engine.positions()
    assert (not engine.refusal(NEWS[name])) is may
    orders = engine.feed(NEWS[name])
    if not may:
        assert (orders, engine.positions()) == ([], before)
    else:
        assert orders or engine.positions() != before


def test_every_state_and_everything_a_user_may_want_is_tried_here():
    assert set(ALLOWED) | {"ended"} == {state.value for state in FlowState}
    assert {type(news) for news in NEWS.values()} == set(get_args(Steering))


def test_a_loop_that_is_left_is_told_and_the_place_too():
    engine = build.engine(build.flow([JOB], program(bottom("round", Meet("meet"), Do(0)))))
    for news in (Run(), Spawned(0, "move")):
        engine.feed(news)
    assert engine.positions()[0].loops == ("round",)
    assert engine.feed(Leave("0")) == [Moved(0, "running", 0, text=Reason.of("engine.leaves_loop", name="round"))]


def test_who_is_sent_elsewhere_while_his_task_is_cleared_hears_to_wait():
    engine = brought("clearing")
    assert "found it clearing" in str(engine.refusal(Skip("0", 1)))
    engine.feed(Cleared(0, "move"))
    assert not engine.refusal(Skip("0", 1))
