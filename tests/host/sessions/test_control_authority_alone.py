"""Who may do what, by itself: what the control authority answers, with nothing that runs (law 27)."""

import pytest

from kit.runtime.authority_bench import AuthorityBench, LiveFake
from onika.wire import event, holding, live, request, steer
from onika.wire.plan import Code
from onika.words.reason import NOTHING, Reason

CODE = Code("d", "m", "m.py", "x = 1")
CHANGES = [
    live.Change("s0", off=("t",)), live.Clear("s0", "t"), live.Reinit("s0", "t"), live.Swap("s0", "t", CODE),
    live.Set("s0", "t", "X", "1"), live.Write("s0", "X", (1.0,)),
    live.Close("s0"), live.Release("s0"), request.Reply("s0", "t", "1"),
]  # fmt: skip
LATE = [change for change in CHANGES if not isinstance(change, live.Release)]


def named(message):
    return type(message).__name__


@pytest.fixture
def bench():
    return AuthorityBench()


@pytest.mark.parametrize("message", CHANGES, ids=named)
def test_what_changes_a_subsystem_is_for_its_holder_alone(bench, message):  # R-X12
    assert bench.refusal("two", message) == NOTHING
    bench.take("one")
    assert bench.refusal("one", message) == NOTHING
    assert bench.refusal("two", message) == Reason.of("host.held_stop", subsystem="s0", holder="one")


@pytest.mark.parametrize("message", [*LATE, steer.Pause(), holding.Hand("s0", "two")], ids=named)
def test_what_may_have_been_meant_before_the_silence_moves_nothing_after_it(bench, message):  # R-X12
    bench.take("one")
    bench.authority.lapse("one", 250_000_000, 7)
    assert bench.refusal("one", message).key == "host.holder_lapsed"
    assert bench.refusal("two", message).key != "host.holder_lapsed"
    bench.authority.began("one")
    assert bench.refusal("one", message).key != "host.holder_lapsed"


def test_in_a_stop_tasks_go_off_and_none_comes_to_life(bench):  # law 27
    spawn = live.Change("s0", spawn=("a task",))
    for message in (live.Change("s0", on=("t",)), spawn):
        assert bench.refusal("one", message, is_stopped=True) == Reason.of("host.is_stopped")
        assert bench.refusal("one", message) == NOTHING
    assert bench.refusal("one", live.Change("s0", off=("t",)), is_stopped=True) == NOTHING
    assert bench.refusal("one", live.Clear("s0", "t"), is_stopped=True) == NOTHING


def test_what_is_steered_is_judged_by_the_run(bench):
    assert bench.refusal("one", steer.Pause()) == Reason.plain(f"one: {steer.Pause()!r}")


def test_an_application_is_changed_by_nobody_and_answered_by_its_session(bench):  # R-X12
    bench.runs("one", "flow0")
    refused = Reason.of("host.runs_in", application="work", subsystem="flow0")
    assert bench.refusal("one", live.Change("flow0", off=("t",))) == refused
    assert bench.refusal("one", request.Reply("flow0", "t", "1")) == NOTHING
    held = Reason.of("host.held_stop", subsystem="flow0", holder="one")
    assert bench.refusal("two", request.Reply("flow0", "t", "1")) == held


def test_an_application_begins_where_nobody_else_is(bench):  # R-A06
    bench.subsystems.live |= {
        "s0": LiveFake("one"),
        "s1": LiveFake("two"),
        "s2": LiveFake("one", "t"),
        "s3": LiveFake(),
    }
    bench.runs("one", "flow0")
    occupied = bench.authority.occupied
    assert occupied("one", ["s0", "s3", "s9"]) == NOTHING
    assert set(bench.subsystems.live) == {"s1", "s2"}
    assert occupied("one", ["s1"]) == Reason.of("host.held_elsewhere", subsystem="s1", holder="two")
    assert occupied("one", ["s2"]) == Reason.of("host.has_tasks", subsystem="s2", tasks=("t",))
    runs_in = Reason.of("host.runs_in_already", application="work", subsystem="flow0")
    assert occupied("one", ["flow0"]) == occupied("two", ["flow0"]) == runs_in


@pytest.mark.parametrize(("on_loss", "abandoned"), [("stop", True), ("run", False)])
def test_a_stop_is_left_by_whoever_holds_something_or_when_nobody_does(bench, on_loss, abandoned):  # law 27
    bench.subsystems.live["s0"] = LiveFake()
    assert bench.refusal("two", live.Reset()) == NOTHING
    bench.runs("one", "flow0", on_loss=on_loss)
    assert bench.refusal("one", live.Reset()) == NOTHING
    assert bench.refusal("two", live.Reset()) == Reason.of("host.stop_of_holder", names=("one",))
    bench.subsystems.live["s0"].holder = "two"
    assert bench.refusal("two", live.Reset()) == NOTHING


def test_who_takes_holds_and_who_takes_what_he_holds_holds_it_still(bench):  # R-X12
    assert bench.take("one") == bench.take("one") == request.Done()
    assert bench.messages == [(event.Held("s0", "one", NOTHING), "s0", "one")]
    held = request.Refused(Reason.of("host.held_by", subsystem="s0", holder="one"))
    assert bench.take("two") == held


def test_what_was_given_back_is_told_to_who_held_it_and_is_no_more_if_empty(bench):  # R-X12
    bench.take("one")
    bench.subsystems.live["s1"] = LiveFake("one", "t")
    bench.messages.clear()
    assert bench.release("one") == bench.release("one", "s1") == bench.release("one", "s9") == request.Done()
    assert bench.messages == [(event.Held(name, "", NOTHING), name, "one") for name in ("s0", "s1")]
    assert set(bench.subsystems.live) == {"s1"}


def test_a_change_makes_a_holder_only_if_it_was_accepted(bench):  # R-X12
    bench.subsystems.live["s0"] = LiveFake()
    refused = request.Refused(NOTHING)
    assert bench.authority.takes("one", "s0", refused) is refused
    assert bench.subsystems.live["s0"].holder == ""
    accepted = live.Accepted(1)
    assert bench.authority.takes("one", "s0", accepted) is accepted
    assert bench.subsystems.live["s0"].holder == "one"


def test_who_only_watches_gives_everything_back_first(bench):  # R-X12
    bench.take("one", "s1")
    bench.runs("one", "flow0", "flow1")
    bench.runs("two", "flow2")
    names = ("flow0", "flow1", "s1")
    assert bench.authority.only_watch("one") == request.Refused(Reason.of("host.holds_still", names=names))
    assert bench.authority.only_watch("ann#1") == request.Done()
    assert bench.authority.watching == {"ann#1"}
    assert bench.refusal("ann#1", live.Take("s0")) == Reason.of("host.watches_only")
    assert bench.refusal("ann#1", request.Stop(Reason.plain("x"))) == bench.refusal("ann#1", live.Survey()) == NOTHING
