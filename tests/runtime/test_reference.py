"""The law of the cycle, told by the reference; and the executive, which must tell the same story of any tasks."""

from dataclasses import dataclass, replace

import pytest
from hypothesis import given, settings, strategies as st

from onika.model.lifecycle import State
from onika.module import finish, off
from onika.runtime import command, news
from onika.runtime.law_task import LawSwap, LawTask
from onika.runtime.reference import Reference
from onika.testing.rig import HOME, Rig
from onika.testing.worlds import MassWorld

MS = 1_000_000


# A task that can be told both ways: as a law task, and as the source of a module


@dataclass(frozen=True)
class Probe:
    """What a probe does: counts its cycles, adds its inputs to its outputs, and misbehaves where it is told to."""

    name: str
    period: int = 10 * MS
    crit: int = 0
    rank: int = 0
    cost: int = 0
    device: str = ""
    inconst: tuple[str, ...] = ()
    outconst: tuple[str, ...] = ()
    invar: tuple[str, ...] = ()
    outvar: tuple[str, ...] = ()
    is_periodic: bool = True
    finish_after: int = 0  # cycles since on
    off_after: int = 0
    fail_at: int = 0  # cycles in all
    nan_at: int = 0
    mends: bool = False
    fails_in: str = ""  # the first time this entry is called
    takes: bool = False  # goes on where the code before it stood
    is_idle_on: bool = False  # `on` leaves the outputs as they were preloaded

    @property
    def frequency(self):
        return 1e9 / self.period


def law_task(probe):
    def first(moment, entry):
        tries = moment.memory.setdefault("tries", set())
        if probe.fails_in == entry and entry not in tries:
            tries.add(entry)
            raise ValueError(entry)

    def init(moment):
        moment.memory.update(n=0, k=0)
        first(moment, "init")
        for name in probe.outconst:
            moment.outputs[name] = 100.0 + sum(moment.inputs[one] for one in probe.inconst)

    def on(moment):
        moment.memory["k"] = 0
        first(moment, "on")
        for name in () if probe.is_idle_on else probe.outvar:
            moment.outputs[name] = moment.outputs[name] + 1.0 if name in moment.in_force else moment.now / MS

    def cycle(moment):
        memory = moment.memory
        memory["n"] += 1
        memory["k"] += 1
        if memory["n"] == probe.fail_at:
            raise ValueError("cycle")
        move(moment)
        if memory["k"] == probe.finish_after:
            return finish(flow=memory["n"], loop=True)
        return off() if memory["k"] == probe.off_after else None

    def move(moment):
        total = sum(moment.inputs[one] for one in probe.invar)
        here = moment.device.read()[0] if probe.device else 0.0
        for name in probe.outvar:
            moment.outputs[name] = (moment.outputs[name] + total + moment.memory["k"] + here) % 1009.0
            if moment.memory["n"] == probe.nan_at:
                moment.outputs[name] = float("nan")
        if probe.device:
            moment.device.write((total,))

    def leave(moment):
        first(moment, "off")

    def take(moment):
        moment.memory.update(n=moment.former["n"], k=moment.former["k"])
        first(moment, "take")

    code = {"init": init, "on": on, "cycle": cycle, "hold": move, "off": leave, "error": lambda _: probe.mends}
    code |= {"take": take} if probe.takes else {}
    return LawTask(
        probe.name, code, probe.period, probe.is_periodic, probe.crit, probe.rank, probe.cost, bool(probe.finish_after),
        bool(probe.device), probe.device, probe.inconst, probe.outconst, probe.invar, probe.outvar,
    )  # fmt: skip


def source(probe):
    kinds = {}
    for name in probe.inconst:
        kinds[name] = "InBoth" if name in probe.invar else "InConst"
    for name in probe.outconst:
        kinds[name] = "OutBoth" if name in probe.outvar else "OutConst"
    for name in probe.invar:
        kinds.setdefault(name, "InVar")
    for name in probe.outvar:
        kinds.setdefault(name, "OutVar")
    ports = "\n    ".join(f'{name} = {kind}("double")' for name, kind in kinds.items())
    return f"""
from onika.module import InBoth, InConst, InVar, Module, OutBoth, OutConst, OutVar, finish, off
from onika.runtime.law_task import Traced

MS = 1_000_000


def traced(entry):
    def call(self, *given):
        try:
            return entry(self, *given)
        finally:
            inputs = {{name: getattr(self, name) for name in {probe.inconst + probe.invar}}}
            outputs = {{name: getattr(self, name) for name in {probe.outconst + probe.outvar}}}
            self.trace.append(Traced(round(self.now * 1e9), {probe.name!r}, entry.__name__, inputs, outputs))
    return call


class Probe(Module):
    trigger = {bool(probe.finish_after)}
    hardware = {bool(probe.device)}
    crit = {probe.crit}
    {ports}

    def __init__(self):
        self.trace = []
        self.tries = set()

    def first(self, entry):
        if {probe.fails_in!r} == entry and entry not in self.tries:
            self.tries.add(entry)
            raise ValueError(entry)

    @traced
    def init(self):
        self.n = self.k = 0
        self.first("init")
        for name in {probe.outconst}:
            setattr(self, name, 100.0 + sum(getattr(self, one) for one in {probe.inconst}))

    @traced
    def on(self, inputs):
        self.k = 0
        self.first("on")
        for name in {() if probe.is_idle_on else probe.outvar}:
            setattr(self, name, getattr(self, name) + 1.0 if self.continues(name) else round(self.now * 1e9) / MS)

    @traced
    def cycle(self):
        self.n += 1
        self.k += 1
        if self.n == {probe.fail_at}:
            raise ValueError("cycle")
        self.move()
        if self.k == {probe.finish_after}:
            return finish(flow=self.n, loop=True)
        return off() if self.k == {probe.off_after} else None

    def move(self):
        total = sum(getattr(self, one) for one in {probe.invar})
        here = self.device.read()[0] if {bool(probe.device)} else 0.0
        for name in {probe.outvar}:
            value = (getattr(self, name) + total + self.k + here) % 1009.0
            setattr(self, name, float("nan") if self.n == {probe.nan_at} else value)
        if {bool(probe.device)}:
            self.device.write((total,))

    @traced
    def hold(self):
        self.move()
{TAKE if probe.takes else ""}

    @traced
    def off(self):
        self.first("off")

    @traced
    def error(self, fault):
        return {probe.mends}

    @traced
    def clear(self):
        pass

    @traced
    def kill(self):
        pass
"""


TAKE = """
    @traced
    def take(self, old):
        self.n, self.k = old.n, old.k
        self.first("take")
"""


@dataclass(frozen=True)
class Exchanged:
    """A request: this probe in place of the one of its name."""

    probe: Probe


class TracedRig(Rig):
    """Instances that come later write into the one trace too, where they belong."""

    trace = None

    def do(self, order):
        before = len(self.trace or ())
        super().do(order)
        if self.trace is not None:
            for task in self.executive.tasks.values():
                if task.module.trace is not self.trace:
                    self.trace[before:before] = task.module.trace
                    task.module.trace = self.trace
        return self

    def of(self, request):
        """A request as a command."""
        return command.Swap(self.order_of(request.probe)) if isinstance(request, Exchanged) else request

    def order_of(self, one):
        kind = "periodic" if one.is_periodic else "aperiodic"
        given = {"frequency": one.frequency, "kind": kind, "rank": one.rank, "device": one.device}
        return self.spawn_of(one.name, source(one), **given)


def to_law(request):
    return LawSwap(law_task(request.probe)) if isinstance(request, Exchanged) else request


def by_law(probes, requests, until, react):
    world = MassWorld()
    reference = Reference(
        [law_task(one) for one in probes], world, lambda task, _: list(map(to_law, react.get(task, [])))
    )
    reference.run(until, [(at, to_law(one)) for at, one in requests])
    return reference, world


def by_executive(probes, requests, until, react):
    world, trace = MassWorld(), []

    def reply(one):
        is_signal = isinstance(one, news.Finished) or (isinstance(one, news.Changed) and one.signal)
        return list(map(rig.of, react.get(one.task, []))) if is_signal else []

    rig = TracedRig(world, costs={one.name: one.cost for one in probes}, react=reply)
    for one in probes:
        rig.do(rig.order_of(one))
        module = rig.task(one.name).module
        trace += module.trace
        module.trace = trace
    rig.trace = trace
    rig.run(until, [(at, rig.of(one)) for at, one in requests])
    return rig, world, trace


def words(rig):
    """What a rig heard, in the words of the reference."""
    said = []
    for at, one in rig.news:
        match one:
            case news.Changed():
                said.append((at, one.task, f"signal {one.signal}" if one.signal else one.state))
            case news.Initialised() if (at, one.task, "ERROR") in said:
                said.append((at, one.task, "OFF"))
            case news.Initialised() if any(before[1:] == (one.task, "ERROR") for before in said):
                said.append((at, one.task, "OFF"))
            case news.Reinitialised():
                said.append((at, one.task, "reinit"))
            case news.Swapped():
                said.append((at, one.task, "swapped"))
            case news.Finished():
                said.append((at, one.task, "signal FINISH"))
            case news.Failed():
                said.append((at, one.task, "ERROR"))
            case news.Refused():
                said.append((at, one.task, f"refused {one.command}"))
    return said


def assert_same_story(probes, requests, until, react=None):
    reference, one_world = by_law(probes, requests, until, react or {})
    rig, other_world, trace = by_executive(probes, requests, until, react or {})
    assert list(map(repr, trace)) == list(map(repr, reference.trace))  # repr: NaN is equal to itself there
    assert words(rig) == reference.told
    alive = {name for name, state in reference.states.items() if state is not State.KILLED}
    assert {name: rig.task(name).state for name in alive} == {name: reference.states[name] for name in alive}
    assert {name: rig.task(name).slot.missed for name in alive} == {name: reference.missed[name] for name in alive}
    assert {name for _, name in rig.executive.tasks} == alive
    assert other_world.fingerprint() == one_world.fingerprint()
    assert reference.trace or not probes
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
            Probe(
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
    names = sorted(one.name for one in probes)
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
    names = sorted(one.name for one in probes)
    everyone = command.Switch(HOME, (), (), tuple(command.Launch(name) for name in names))
    times = st.integers(0, 300).map(lambda ms: ms * MS) | st.integers(0, 300 * MS)
    requests = draw(st.lists(st.tuples(times, some_request(probes)), max_size=8))
    triggers = [one.name for one in probes if one.finish_after or one.off_after]
    react = {name: [draw(some_request(probes))] for name in triggers}
    return probes, [(0, everyone), *sorted(requests, key=lambda one: one[0])], react


@settings(deadline=None, max_examples=150)
@given(some_story())
def test_the_executive_does_exactly_what_the_reference_says(story):  # laws 1 to 6, 13
    probes, requests, react = story
    assert_same_story(probes, requests, 300 * MS, react)


@settings(deadline=None, max_examples=100)
@given(some_story(with_costs=True))
def test_overruns_are_counted_and_skipped_by_the_executive_as_the_reference_says(story):  # law 2
    probes, requests, react = story
    assert_same_story(probes, requests, 200 * MS, react)


# The law itself, worked by hand


def cycles(reference, task, entry="cycle"):
    return [one.at // MS for one in reference.trace if (one.task, one.entry) == (task, entry)]


def order_at(reference, at):
    return [one.task for one in reference.trace if one.at == at * MS and one.entry == "cycle"]


def switch(*on, off=(), forget=(), rates=()):
    return command.Switch(HOME, tuple(off), tuple(forget), tuple(command.Launch(name) for name in on), tuple(rates))


def test_tasks_due_at_one_instant_run_by_deadline_criticality_rank_and_name():  # law 1
    probes = [
        Probe("z", period=20 * MS),
        Probe("late", period=20 * MS, rank=-9),
        Probe("b", rank=1),
        Probe("a", rank=1),
        Probe("first", rank=0),
        Probe("critical", rank=5, crit=1),
    ]
    names = [one.name for one in probes]
    reference = assert_same_story(probes, [(0, switch(*names)), (0, switch(*reversed(names)))], 25 * MS)
    assert order_at(reference, 20) == ["critical", "first", "a", "b", "late", "z"]


def test_a_chain_of_tasks_carries_a_value_through_in_one_instant():  # law 1
    probes = [Probe("c", rank=2, invar=("V1",)), Probe("b", rank=1, invar=("V0",), outvar=("V1",))]
    probes.append(Probe("a", rank=0, outvar=("V0",)))
    reference = assert_same_story(probes, [(0, switch("a", "b", "c"))], 10 * MS)
    last = [one for one in reference.trace if one.at == 10 * MS]
    assert [one.task for one in last] == ["a", "b", "c"]
    assert last[1].inputs["V0"] == last[0].outputs["V0"]
    assert last[2].inputs["V1"] == last[1].outputs["V1"]


def test_a_faster_task_sees_the_previous_value_of_a_slower_one():  # law 1
    probes = [Probe("slow", period=20 * MS, outvar=("V0",)), Probe("fast", period=5 * MS, rank=1, invar=("V0",))]
    reference = assert_same_story(probes, [(0, switch("slow", "fast"))], 40 * MS)
    seen = [one.inputs["V0"] for one in reference.trace if one.task == "fast" and one.entry == "cycle"]
    written = [one.outputs["V0"] for one in reference.trace if one.task == "slow" and one.entry == "cycle"]
    assert seen[4] == written[0] != written[1]
    assert seen[5] == written[1]


def test_the_first_cycle_comes_at_once_and_the_next_on_the_common_grid():  # law 13
    reference = assert_same_story([Probe("a")], [(7 * MS, switch("a"))], 40 * MS)
    assert cycles(reference, "a") == [7, 10, 20, 30, 40]


def test_missed_periods_are_counted_and_skipped_and_never_caught_up():  # law 2
    reference = assert_same_story([Probe("a", cost=35 * MS)], [(0, switch("a"))], 120 * MS)
    assert cycles(reference, "a") == [0, 35, 70, 105]
    assert reference.missed == {"a": 2 + 3 + 2}


def test_a_task_that_is_kept_waiting_runs_once_for_the_period_that_is_open():  # law 2
    probes = [Probe("hog", period=50 * MS, cost=33 * MS, crit=0), Probe("b", period=10 * MS)]
    reference = assert_same_story(probes, [(0, switch("hog", "b"))], 90 * MS)
    assert cycles(reference, "b") == [0, 33, 40, 50, 83, 90]
    assert cycles(reference, "hog") == [0, 50]
    assert reference.missed["b"] == 2 + 2


def test_a_rate_changes_while_the_task_is_on_and_the_grid_stays():  # R-A04, law 13
    reference = assert_same_story([Probe("a")], [(0, switch("a")), (12 * MS, switch(rates=[("a", 40.0)]))], 80 * MS)
    assert cycles(reference, "a") == [0, 10, 25, 50, 75]


def test_a_cycle_that_is_due_when_the_rate_changes_is_not_lost():  # R-A04
    probes = [Probe("t", finish_after=2, crit=1), Probe("a")]
    react = {"t": [switch(rates=[("a", 50.0)])]}
    reference = assert_same_story(probes, [(0, switch("t", "a"))], 45 * MS, react)
    assert cycles(reference, "a") == [0, 10, 20, 40]


def test_off_publishes_nothing():  # law 3
    probe = Probe("a", outvar=("V0",))
    reference = assert_same_story([probe], [(0, switch("a")), (15 * MS, switch(off=["a"]))], 30 * MS)
    assert reference.trace[-1].entry == "off"
    assert reference.table["V0"] == reference.trace[-2].outputs["V0"]


def test_own_outputs_are_preloaded_when_a_task_comes_on_and_continue_what_is_in_force():  # law 3
    probes = [Probe("a", outvar=("V0",)), Probe("b", outvar=("V0",))]
    requests = [(0, switch("a")), (15 * MS, switch("b", off=["a"])), (25 * MS, switch("a", off=["b"], forget=["V0"]))]
    reference = assert_same_story(probes, requests, 30 * MS)
    began = {one.at // MS: one.outputs["V0"] for one in reference.trace if one.entry == "on"}
    left = {one.at // MS: one.outputs["V0"] for one in reference.trace if one.entry == "off"}
    assert began == {0: 0.0, 15: left[15] + 1.0, 25: 25.0}


def test_constants_are_moved_once_and_first_values_too():  # law 3, R-A02
    probes = [
        Probe("a", outconst=("C0", "V0"), outvar=("V0",)),
        Probe("b", inconst=("C0", "V0"), invar=("V0",)),
    ]
    reference = assert_same_story(probes, [(0, switch("a", "b"))], 5 * MS)
    entry = {(one.task, one.entry): one.inputs for one in reference.trace}
    assert entry["b", "init"] == {"C0": 100.0, "V0": 100.0}
    assert entry["b", "cycle"] == {"C0": 100.0, "V0": 100.0 + 1.0 + 1.0}  # preloaded, by `on`, by `cycle`


def test_hardware_holds_until_all_its_inputs_were_written_since_it_came_on():  # law 4
    probes = [
        Probe("arm", device="m0", invar=("V0", "V1")),
        Probe("a", outvar=("V0",), rank=1),
        Probe("b", outvar=("V1",), rank=1),
    ]
    requests = [(0, switch("arm", "a")), (25 * MS, switch("b"))]
    reference = assert_same_story(probes, requests, 50 * MS)
    assert cycles(reference, "arm", "hold") == [0, 10, 20]
    assert cycles(reference, "arm") == [30, 40, 50]


def test_what_was_written_before_a_hardware_task_came_on_is_not_fresh():  # law 4
    probes = [Probe("arm", device="m0", invar=("V0",)), Probe("a", outvar=("V0",), rank=1)]
    requests = [(0, switch("a")), (15 * MS, switch("arm", off=["a"]))]
    reference = assert_same_story(probes, requests, 40 * MS)
    assert cycles(reference, "arm") == []
    assert cycles(reference, "arm", "hold") == [15, 20, 30, 40]


def test_what_an_on_leaves_as_it_was_preloaded_is_not_fresh():  # law 4, decision 13
    """The reference of 15 ms ago must not be followed because a task that came on has carried it along."""
    probes = [
        Probe("arm", device="m0", invar=("V0",)),
        Probe("old", outvar=("V0",), rank=1),
        Probe("slow", outvar=("V0",), rank=1, period=50 * MS, is_idle_on=True),
    ]
    requests = [(0, switch("old")), (15 * MS, switch("slow", "arm", off=["old"]))]
    reference = assert_same_story(probes, requests, 40 * MS)
    assert cycles(reference, "arm", "hold") == [15]  # `slow` cycles at once too, but after the arm
    assert cycles(reference, "arm") == [20, 30, 40]


def test_a_variable_that_an_on_did_not_write_is_not_in_force():  # law 3, decision 13
    probes = [Probe("a", outvar=("V0",), is_idle_on=True), Probe("b", outvar=("V0",))]
    reference = assert_same_story(probes, [(5 * MS, switch("a", "b"))], 5 * MS)
    began = next(one for one in reference.trace if (one.task, one.entry) == ("b", "on"))
    assert began.outputs["V0"] == 5.0  # not preloaded zero plus one


def test_nan_at_a_hardware_tasks_copy_in_is_an_error_and_no_error_entry_mends_it():  # law 5
    probes = [
        Probe("arm", device="m0", invar=("V0",), mends=True),
        Probe("a", outvar=("V0",), nan_at=3, rank=1),
    ]
    reference = assert_same_story(probes, [(0, switch("arm", "a"))], 60 * MS)
    assert reference.states["arm"] is State.ERROR
    assert cycles(reference, "arm") == [10, 20]
    assert cycles(reference, "arm", "error") == []


def test_only_the_trigger_goes_off_when_it_finishes():  # law 6
    probes = [Probe("t", finish_after=3), Probe("a")]
    reference = assert_same_story(probes, [(0, switch("t", "a"))], 50 * MS)
    assert cycles(reference, "t") == [0, 10, 20]
    assert cycles(reference, "a") == [0, 10, 20, 30, 40, 50]


def test_what_a_signal_leads_to_happens_at_the_same_instant():  # laws 1, 2
    probes = [Probe("t", finish_after=2, rank=0), Probe("next", rank=0), Probe("x", rank=1)]
    react = {"t": [switch("next")]}
    reference = assert_same_story(probes, [(0, switch("t", "x"))], 10 * MS, react)
    assert order_at(reference, 10) == ["t", "next", "x"]
    assert (10 * MS, "next", "ON") in reference.told


@pytest.mark.parametrize("entry", ["init", "on", "off"])
def test_what_raises_outside_a_cycle_is_an_error_that_a_clear_ends(entry):  # R-A05
    probes = [Probe("a", fails_in=entry, mends=True)]
    requests = [(0, switch("a")), (15 * MS, switch(off=["a"])), (20 * MS, command.Clear(HOME, "a"))]
    requests += [(20 * MS, switch("a")), (30 * MS, command.Clear(HOME, "a"))]
    reference = assert_same_story(probes, requests, 40 * MS)
    assert (20 * MS, "a", "OFF") in reference.told
    assert (30 * MS, "a", "refused clear") in reference.told
    assert reference.states == {"a": State.ON}
