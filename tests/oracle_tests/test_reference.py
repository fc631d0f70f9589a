"""The law of the cycle, told by the reference; and the executive, which must tell the same story of any tasks."""

from dataclasses import replace
from types import MappingProxyType

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.labs.sample_task import MS, SampleTask
from kit.runtime.executive_rig import HOME
from kit.runtime.law_comparison import Exchanged, by_executive, by_law
from onika.model.lifecycle import State
from onika.runtime import command


def assert_same_story(probes, requests, until, react=MappingProxyType({})):
    trace, reference = by_law(probes, requests, until, react)
    assert by_executive(probes, requests, until, react) == trace
    if not any(probe.cost for probe in probes):
        assert by_executive(probes, requests, until, react, steady=1) == trace
    assert trace.trace or not probes
    return reference


# Any tasks

NAMES = ("a", "b", "c", "d", "e")
VARIABLES = ("V0", "V1", "V2", "V3")
CONSTANTS = ("C0", "C1")
PERIODS = (2 * MS, 5 * MS, 10 * MS, 20 * MS, 25 * MS, 7_142_857)


@st.composite
def some_probes(draw, with_costs=False):
    probes = []
    for place, name in enumerate(draw(st.permutations(NAMES))[: draw(st.integers(1, 5))]):
        reads = draw(st.sets(st.sampled_from(VARIABLES), max_size=3))
        writes = draw(st.sets(st.sampled_from(VARIABLES), max_size=2)) - reads
        takes = draw(st.sets(st.sampled_from((*CONSTANTS, *reads)), max_size=2))
        gives = draw(st.sets(st.sampled_from((*CONSTANTS, *writes)), max_size=2)) - takes
        seldom = st.integers(-20, 20).map(lambda count: count if count > 1 else 0)  # 1 could go round at one instant
        probes.append(
            SampleTask(
                name=name,
                period=draw(st.sampled_from(PERIODS)),
                crit=draw(st.integers(0, 2)),
                rank=draw(st.integers(0, 2)),
                cost=draw(st.sampled_from((0, 300_000, 1_700_000, 6 * MS, 23 * MS))) if with_costs else 0,
                device=("m0", "m1")[place] if place < 2 and draw(st.booleans()) else "",
                inconst=tuple(sorted(takes)),
                outconst=tuple(sorted(gives)),
                invar=tuple(sorted(reads)),
                outvar=tuple(sorted(writes)),
                is_periodic=draw(st.sampled_from((True, True, True, False))),
                finish_after=draw(seldom),
                off_after=draw(seldom),
                fail_at=draw(seldom),
                nan_at=draw(seldom),
                mends=draw(st.booleans()),
                fails_in=draw(st.sampled_from(("", "", "", "init", "on", "off"))),
                is_idle_on=draw(st.booleans()),
            )
        )
    return probes


@st.composite
def some_exchange(draw, probe):
    """The same ports and rate; another place at one instant, other misbehaviour."""
    small = st.integers(-20, 20).map(lambda count: count if count > 1 else 0)
    changes = {name: draw(small) for name in ("finish_after", "off_after", "fail_at", "nan_at")}
    changes |= {name: draw(st.booleans()) for name in ("mends", "takes", "is_idle_on")}
    changes |= {name: draw(st.integers(0, 2)) for name in ("crit", "rank")}
    return Exchanged(
        replace(probe, fails_in=draw(st.sampled_from(("", "", "", "init", "on", "off", "take"))), **changes)
    )


@st.composite
def some_request(draw, probes):
    names = sorted(probe.name for probe in probes)
    kind = draw(st.sampled_from(("switch",) * 6 + ("clear", "clear", "kill", "rank", "reinit", "swap", "swap")))
    if kind == "swap":
        return draw(some_exchange(draw(st.sampled_from(probes))))
    if kind == "reinit":
        return command.Reinit(HOME, draw(st.sampled_from(names)))
    if kind == "rank":
        ranks = st.tuples(st.sampled_from(names), st.integers(-1, 3))
        return command.Rank(HOME, tuple(draw(st.lists(ranks, max_size=3))))
    if kind == "clear":
        return command.Clear(HOME, draw(st.sampled_from(names)))
    if kind == "kill":
        return command.Kill(HOME, draw(st.sampled_from(names)))
    rates = st.sampled_from((40.0, 50.0, 100.0, 300.0, 500.0))
    some = st.lists(st.sampled_from(names), max_size=3, unique=True)
    launch = st.builds(
        lambda task, hz: command.Launch(task, "", hz), st.sampled_from(names), st.none() | st.none() | rates
    )
    return command.Switch(
        HOME,
        tuple(draw(some)),
        tuple(draw(st.lists(st.sampled_from(VARIABLES), max_size=2))),
        tuple(draw(st.lists(launch, max_size=3))),
        tuple(draw(st.lists(st.tuples(st.sampled_from(names), rates), max_size=1))),
    )


@st.composite
def some_story(draw, with_costs=False):
    probes = draw(some_probes(with_costs))
    names = sorted(probe.name for probe in probes)
    everyone = command.Switch(HOME, (), (), tuple(command.Launch(name) for name in names))
    times = st.integers(0, 300).map(lambda ms: ms * MS) | st.integers(0, 300 * MS)
    requests = draw(st.lists(st.tuples(times, some_request(probes)), max_size=8))
    triggers = [probe.name for probe in probes if probe.finish_after or probe.off_after]
    react = {name: [draw(some_request(probes))] for name in triggers}
    return probes, [(0, everyone), *sorted(requests, key=lambda request: request[0])], react


@settings(deadline=None, max_examples=examples(150))
@given(some_story())
def test_the_executive_does_exactly_what_the_reference_says(story):  # laws 1 to 6, 13
    probes, requests, react = story
    assert_same_story(probes, requests, 300 * MS, react)


@settings(deadline=None, max_examples=examples(100))
@given(some_story(with_costs=True))
def test_overruns_are_counted_and_skipped_by_the_executive_as_the_reference_says(story):  # law 2
    probes, requests, react = story
    assert_same_story(probes, requests, 200 * MS, react)


# The law itself, worked by hand


def cycles(reference, task, entry="cycle"):
    return [call.at // MS for call in reference.trace if (call.task, call.entry) == (task, entry)]


def order_at(reference, at):
    return [call.task for call in reference.trace if call.at == at * MS and call.entry == "cycle"]


def switch(*on, off=(), forget=(), rates=()):
    return command.Switch(HOME, tuple(off), tuple(forget), tuple(command.Launch(name) for name in on), tuple(rates))


def test_tasks_due_at_one_instant_run_by_deadline_criticality_rank_and_name():  # law 1
    probes = [
        SampleTask("z", period=20 * MS),
        SampleTask("late", period=20 * MS, rank=-9),
        SampleTask("b", rank=1),
        SampleTask("a", rank=1),
        SampleTask("first", rank=0),
        SampleTask("critical", rank=5, crit=1),
    ]
    names = [probe.name for probe in probes]
    reference = assert_same_story(probes, [(0, switch(*names)), (0, switch(*reversed(names)))], 25 * MS)
    assert order_at(reference, 20) == ["critical", "first", "a", "b", "late", "z"]


def test_a_chain_of_tasks_carries_a_value_through_in_one_instant():  # law 1
    probes = [SampleTask("c", rank=2, invar=("V1",)), SampleTask("b", rank=1, invar=("V0",), outvar=("V1",))]
    probes.append(SampleTask("a", rank=0, outvar=("V0",)))
    reference = assert_same_story(probes, [(0, switch("a", "b", "c"))], 10 * MS)
    last = [call for call in reference.trace if call.at == 10 * MS]
    assert [call.task for call in last] == ["a", "b", "c"]
    assert last[1].inputs["V0"] == last[0].outputs["V0"]
    assert last[2].inputs["V1"] == last[1].outputs["V1"]


def test_a_faster_task_sees_the_previous_value_of_a_slower_one():  # law 1
    probes = [
        SampleTask("slow", period=20 * MS, outvar=("V0",)),
        SampleTask("fast", period=5 * MS, rank=1, invar=("V0",)),
    ]
    reference = assert_same_story(probes, [(0, switch("slow", "fast"))], 40 * MS)
    seen = [call.inputs["V0"] for call in reference.trace if call.task == "fast" and call.entry == "cycle"]
    written = [call.outputs["V0"] for call in reference.trace if call.task == "slow" and call.entry == "cycle"]
    assert seen[4] == written[0] != written[1]
    assert seen[5] == written[1]


def test_the_first_cycle_comes_at_once_and_the_next_on_the_common_grid():  # law 13
    reference = assert_same_story([SampleTask("a")], [(7 * MS, switch("a"))], 40 * MS)
    assert cycles(reference, "a") == [7, 10, 20, 30, 40]


def test_missed_periods_are_counted_and_skipped_and_never_caught_up():  # law 2
    reference = assert_same_story([SampleTask("a", cost=35 * MS)], [(0, switch("a"))], 120 * MS)
    assert cycles(reference, "a") == [0, 35, 70, 105]
    assert reference.missed == {"a": 2 + 3 + 2}


def test_a_task_that_is_kept_waiting_runs_once_for_the_period_that_is_open():  # law 2
    probes = [SampleTask("hog", period=50 * MS, cost=33 * MS, crit=0), SampleTask("b", period=10 * MS)]
    reference = assert_same_story(probes, [(0, switch("hog", "b"))], 90 * MS)
    assert cycles(reference, "b") == [0, 33, 40, 50, 83, 90]
    assert cycles(reference, "hog") == [0, 50]
    assert reference.missed["b"] == 2 + 2


def test_a_rate_changes_while_the_task_is_on_and_the_grid_stays():  # R-A04, law 13
    reference = assert_same_story(
        [SampleTask("a")], [(0, switch("a")), (12 * MS, switch(rates=[("a", 40.0)]))], 80 * MS
    )
    assert cycles(reference, "a") == [0, 10, 25, 50, 75]


def test_a_cycle_that_is_due_when_the_rate_changes_is_not_lost():  # R-A04
    probes = [SampleTask("t", finish_after=2, crit=1), SampleTask("a")]
    react = {"t": [switch(rates=[("a", 50.0)])]}
    reference = assert_same_story(probes, [(0, switch("t", "a"))], 45 * MS, react)
    assert cycles(reference, "a") == [0, 10, 20, 40]


def test_off_publishes_nothing():  # law 3
    probe = SampleTask("a", outvar=("V0",))
    reference = assert_same_story([probe], [(0, switch("a")), (15 * MS, switch(off=["a"]))], 30 * MS)
    assert reference.trace[-1].entry == "off"
    assert reference.table["V0"] == reference.trace[-2].outputs["V0"]


def test_own_outputs_are_preloaded_when_a_task_comes_on_and_continue_what_is_in_force():  # law 3
    probes = [SampleTask("a", outvar=("V0",)), SampleTask("b", outvar=("V0",))]
    requests = [(0, switch("a")), (15 * MS, switch("b", off=["a"])), (25 * MS, switch("a", off=["b"], forget=["V0"]))]
    reference = assert_same_story(probes, requests, 30 * MS)
    began = {call.at // MS: call.outputs["V0"] for call in reference.trace if call.entry == "on"}
    left = {call.at // MS: call.outputs["V0"] for call in reference.trace if call.entry == "off"}
    assert began == {0: 0.0, 15: left[15] + 1.0, 25: 25.0}


def test_constants_are_moved_once_and_first_values_too():  # law 3, R-A02
    probes = [
        SampleTask("a", outconst=("C0", "V0"), outvar=("V0",)),
        SampleTask("b", inconst=("C0", "V0"), invar=("V0",)),
    ]
    reference = assert_same_story(probes, [(0, switch("a", "b"))], 5 * MS)
    entry = {(call.task, call.entry): call.inputs for call in reference.trace}
    assert entry["b", "init"] == {"C0": 100.0, "V0": 100.0}
    assert entry["b", "cycle"] == {"C0": 100.0, "V0": 100.0 + 1.0 + 1.0}  # preloaded, by `on`, by `cycle`


def test_hardware_holds_until_all_its_inputs_were_written_since_it_came_on():  # law 4
    probes = [
        SampleTask("arm", device="m0", invar=("V0", "V1")),
        SampleTask("a", outvar=("V0",), rank=1),
        SampleTask("b", outvar=("V1",), rank=1),
    ]
    requests = [(0, switch("arm", "a")), (25 * MS, switch("b"))]
    reference = assert_same_story(probes, requests, 50 * MS)
    assert cycles(reference, "arm", "hold") == [0, 10, 20]
    assert cycles(reference, "arm") == [30, 40, 50]


def test_what_was_written_before_a_hardware_task_came_on_is_not_fresh():  # law 4
    probes = [SampleTask("arm", device="m0", invar=("V0",)), SampleTask("a", outvar=("V0",), rank=1)]
    requests = [(0, switch("a")), (15 * MS, switch("arm", off=["a"]))]
    reference = assert_same_story(probes, requests, 40 * MS)
    assert cycles(reference, "arm") == []
    assert cycles(reference, "arm", "hold") == [15, 20, 30, 40]


def test_what_an_on_leaves_as_it_was_preloaded_is_not_fresh():  # law 4, decision 13
    """The reference of 15 ms ago must not be followed because a task that came on has carried it along."""
    probes = [
        SampleTask("arm", device="m0", invar=("V0",)),
        SampleTask("old", outvar=("V0",), rank=1),
        SampleTask("slow", outvar=("V0",), rank=1, period=50 * MS, is_idle_on=True),
    ]
    requests = [(0, switch("old")), (15 * MS, switch("slow", "arm", off=["old"]))]
    reference = assert_same_story(probes, requests, 40 * MS)
    assert cycles(reference, "arm", "hold") == [15]  # `slow` cycles at once too, but after the arm
    assert cycles(reference, "arm") == [20, 30, 40]


def test_a_variable_that_an_on_did_not_write_is_not_in_force():  # law 3, decision 13
    probes = [SampleTask("a", outvar=("V0",), is_idle_on=True), SampleTask("b", outvar=("V0",))]
    reference = assert_same_story(probes, [(5 * MS, switch("a", "b"))], 5 * MS)
    began = next(call for call in reference.trace if (call.task, call.entry) == ("b", "on"))
    assert began.outputs["V0"] == 5.0  # not preloaded zero plus one


def test_nan_at_a_hardware_tasks_copy_in_is_an_error_and_no_error_entry_mends_it():  # law 5
    probes = [
        SampleTask("arm", device="m0", invar=("V0",), mends=True),
        SampleTask("a", outvar=("V0",), nan_at=3, rank=1),
    ]
    reference = assert_same_story(probes, [(0, switch("arm", "a"))], 60 * MS)
    assert reference.states["arm"] is State.ERROR
    assert cycles(reference, "arm") == [10, 20]
    assert cycles(reference, "arm", "error") == []


def test_only_the_trigger_goes_off_when_it_finishes():  # law 6
    probes = [SampleTask("t", finish_after=3), SampleTask("a")]
    reference = assert_same_story(probes, [(0, switch("t", "a"))], 50 * MS)
    assert cycles(reference, "t") == [0, 10, 20]
    assert cycles(reference, "a") == [0, 10, 20, 30, 40, 50]


def test_what_a_signal_leads_to_happens_at_the_same_instant():  # laws 1, 2
    probes = [SampleTask("t", finish_after=2, rank=0), SampleTask("next", rank=0), SampleTask("x", rank=1)]
    react = {"t": [switch("next")]}
    reference = assert_same_story(probes, [(0, switch("t", "x"))], 10 * MS, react)
    assert order_at(reference, 10) == ["t", "next", "x"]
    assert (10 * MS, "next", "ON") in reference.told


@pytest.mark.parametrize("entry", ["init", "on", "off"])
def test_what_raises_outside_a_cycle_is_an_error_that_a_clear_ends(entry):  # R-A05
    probes = [SampleTask("a", fails_in=entry, mends=True)]
    requests = [(0, switch("a")), (15 * MS, switch(off=["a"])), (20 * MS, command.Clear(HOME, "a"))]
    requests += [(20 * MS, switch("a")), (30 * MS, command.Clear(HOME, "a"))]
    reference = assert_same_story(probes, requests, 40 * MS)
    assert (20 * MS, "a", "OFF") in reference.told
    assert (30 * MS, "a", "refused clear") in reference.told
    assert reference.states == {"a": State.ON}
