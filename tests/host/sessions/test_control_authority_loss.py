"""Holders who are silent or gone, by themselves: what they held comes to rest (law 27)."""

import pytest

from kit.runtime.authority_bench import AuthorityBench, LiveFake
from onika.wire import event, live, request
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def bench():
    return AuthorityBench()


def test_who_was_silent_may_give_back_look_and_take_anew(bench):  # R-X12
    bench.authority.lapse("one", 250_000_000, 7)
    assert bench.refusal("one", live.Release("s0")) == NOTHING
    assert bench.refusal("one", live.Survey()) == NOTHING
    assert bench.take("one") == request.Done()
    assert bench.refusal("one", live.Change("s0", off=("t",))) == NOTHING


def test_who_depends_on_a_lease(bench):  # R-X12
    bench.subsystems.live |= {"s0": LiveFake("one"), "s1": LiveFake()}
    bench.runs("two", "flow0")
    bench.runs("ann#1", "flow1", on_loss="run")
    bench.runs("", "flow2")
    assert bench.authority.needed == {"one", "two"}


def test_what_a_silent_holder_holds_comes_to_rest_and_is_nobodys(bench):  # R-X12
    subsystem = bench.subsystems.live["s0"] = LiveFake("one", "t")
    other = bench.subsystems.live["s1"] = LiveFake("two", "t")
    run, going_on = bench.runs("one", "flow0", "flow1"), bench.runs("one", "flow2", on_loss="run")
    bench.authority.lapse("one", 250_000_000, 7)
    cause = Reason.of("host.holder_silent", session="one", seconds=0.25)
    assert run.abandoned == [(cause, 7)]
    assert (run.session, going_on.session, going_on.abandoned) == ("", "one", [])
    assert (subsystem.holder, subsystem.begun) == ("", [(0, True)])
    assert (other.holder, other.begun) == ("two", [])
    assert bench.messages == [(event.Held(name, "", cause), name, "one") for name in ("flow0", "flow1", "s0")]


def test_what_a_lost_session_held_comes_to_rest_and_all_its_runs_are_nobodys(bench):  # R-X12
    subsystem = bench.subsystems.live["s0"] = LiveFake("one", "t")
    run, going_on = bench.runs("one", "flow0"), bench.runs("one", "flow2", on_loss="run")
    bench.authority.lost("one", 9)
    cause = Reason.of("host.run_deserted", session="one")
    assert run.abandoned == going_on.abandoned == [(cause, 9)]
    assert (run.session, going_on.session, subsystem.begun) == ("", "", [(0, True)])
    assert bench.messages == [
        (event.Held("flow0", "", cause), "flow0", "one"),
        (event.Held("flow2", "", cause), "flow2", "one"),
        (event.Held("s0", "", Reason.of("host.holder_gone", session="one")), "s0", "one"),
    ]


def test_a_run_of_nobody_is_taken_with_all_its_subsystems(bench):  # R-X12
    run = bench.runs("", "flow0", "flow1")
    assert bench.take("two", "flow1") == request.Done()
    assert run.session == "two"
    cause = Reason.of("host.run_of_nobody")
    assert bench.messages == [(event.Held(name, "two", cause), name, "two") for name in ("flow0", "flow1")]
    held = request.Refused(Reason.of("host.held_by", subsystem="flow0", holder="two"))
    assert bench.take("one", "flow0") == held
    assert bench.take("two", "flow0") == request.Refused(Reason.of("host.held_by", subsystem="flow0", holder="two"))
