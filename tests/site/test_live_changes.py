"""Subsystems held by hand in wall time, in real processes: kept tasks keep their cycles, whatever happens beside them.

Time is judged by the figures of the processing units and by how often tasks have cycled, never by the test's clock. The
rule for missed cycles: phases with and without exchanges alternate, and those with exchanges may miss at most 3 of 100
cycles more than those without. On a machine of its own, with real-time priority, both miss none.
"""

import pytest

from kit.plans.plan_builder import PlanBuilder
from kit.runtime.live_edits import COUNTER, SOURCE, USER
from kit.worlds.box_cells import boxes_files
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.wire import event, live, request
from onika.wire.runtime_standing import Standing

pytestmark = pytest.mark.site

SICK = """
import os

from onika.module import Module, OutVar

class Sick(Module):
    SEEN = OutVar("double", "-", "how many cycles")

    def init(self):
        self._hoard = []

    def cycle(self):
        self.SEEN = self.SEEN + 1.0
        if self.SEEN >= 20.0:
            {act}
"""
HAND = """
from onika.module import InVar, Module, OutVar

class Hand(Module):
    hardware = True
    GRIP = InVar("double", "-", "+1 opens, -1 closes")
    GRIP_MEZ = OutVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")

    def cycle(self):
        self.GRIP_MEZ = self.device.read()
        self.device.write((self.GRIP,))
"""
GRIP = """
import os

from onika.module import Module, OutVar

class Grip(Module):
    GRIP = OutVar("double", "-", "+1 opens, -1 closes")

    def init(self):
        self._count = 0

    def cycle(self):
        self._count += 1
        self.GRIP = 1.0
        if self._count == 50:
            {act}
"""
_TURNS = 600
"""How often is asked at most until something has happened; each turn waits for events up to a tenth of a second."""


class Bench:
    """A runtime in wall time with two units, and the tasks that are tried on it."""

    def __init__(self, runtime):
        self.runtime = runtime
        self.shop = PlanBuilder()
        self.told = []

    def change(self, spawn=(), on=(), subsystem="s0", **what):
        """Change a subsystem; why it came to nothing, or nothing."""
        return self.outcome(
            live.Change(
                subsystem,
                spawn=tuple(self.shop.planned(name) for name in spawn),
                code=tuple(self.shop.code(name) for name in spawn),
                on=tuple(live.Turn(name) for name in on),
                **what,
            )
        )

    def outcome(self, wish):
        answer = self.runtime.ask(wish)
        assert isinstance(answer, live.Accepted), answer
        (edited,) = self.until(event.Edited, lambda edited: edited.number == answer.number)
        return str(edited.cause)

    def until(self, kind, is_it):
        """All events of a kind that are meant, as soon as there is one."""
        for _ in range(_TURNS):
            messages = [message for message in self.told if isinstance(message, kind) and is_it(message)]
            if messages:
                return messages
            self.told += self.runtime.events(0.1)
        raise AssertionError(f"no {kind.__name__} among {self.told[-20:]}")

    def cycled(self, times, name="COUNT", subsystem="s0"):
        """Wait until a variable has counted so far on."""
        until = self.value(name, subsystem) + times
        for _ in range(_TURNS):
            if self.value(name, subsystem) >= until:
                return
            self.told += self.runtime.events(0.1)
        raise AssertionError(f"{name} stands at {self.value(name, subsystem)}, expected {until}: {self.told[-5:]}")

    def value(self, name, subsystem="s0"):
        answer = self.runtime.ask(live.Read(subsystem, (name,)))
        assert isinstance(answer, live.Values), answer
        return answer.values[name]

    def figures(self):
        answer = self.runtime.ask(live.Status())
        assert isinstance(answer, live.Figures), answer
        return {task.task: task for task in answer.tasks}

    def standing(self):
        answer = self.runtime.ask(live.Survey())
        assert isinstance(answer, Standing), answer
        return answer

    def states(self, subsystem="s0"):
        return {
            task.task.name: task.state
            for standing in self.standing().subsystems
            if standing.name == subsystem
            for task in standing.tasks
        }


@pytest.fixture
def bench():
    with LaunchedRuntime(["rt0", "rt1"], is_virtual=False) as runtime:
        bench = Bench(runtime)
        runtime.ask(live.Attend(("*",)))
        bench.shop.task("source", SOURCE, frequency=500.0, rtpu="rt0")
        bench.shop.task("other", SOURCE, frequency=500.0, rtpu="rt0", module="other", local={"SIZE": "3"})
        bench.shop.task("user", USER, frequency=500.0, rtpu="rt0")
        bench.shop.task("counter", COUNTER, frequency=500.0, rtpu="rt0")
        bench.shop.task("far", COUNTER.replace("COUNT", "FAR"), frequency=200.0, rtpu="rt1")
        yield bench


def test_tasks_live_and_die_by_hand(bench):  # R-A05, R-A06
    everyone = ("user", "source", "far")
    assert bench.change(everyone, everyone) == ""
    bench.cycled(100, "FAR")
    assert bench.states() == dict.fromkeys(everyone, "ON")
    assert len(bench.value("ROW")) == 2
    assert bench.change(off=("user",), kill=("source",)) == ""
    assert bench.states() == {"user": "OFF", "far": "ON"}
    for _ in range(3):
        assert bench.outcome(live.Close("s0")) == ""
        assert bench.standing().subsystems == ()
        assert bench.change(everyone, everyone) == ""
        assert bench.value("N") == 2


def test_kept_tasks_keep_their_cycles_while_others_are_exchanged(bench):  # R-A13, R-A14, law 21
    bench.change(("source", "user", "counter"), ("source", "user", "counter"))
    bench.cycled(200)
    missed, cycles = {True: 0, False: 0}, {True: 0, False: 0}
    here, there = "source", "other"
    for phase in range(6):
        is_busy = bool(phase % 2)
        bench.figures()
        if is_busy:
            for _ in range(3):
                assert bench.change((there,), (there,), kill=(here,)) == ""
                here, there = there, here
                code = bench.shop.code("user")
                bench.shop.task("user", f"# {phase}\n{code.source}", frequency=500.0, rtpu="rt0")
                assert bench.outcome(live.Swap("s0", "user", bench.shop.code("user"))) == ""
        bench.cycled(400)
        counter = bench.figures()["counter"]
        missed[is_busy] += counter.miss
        cycles[is_busy] += counter.cycle
    assert missed[True] / cycles[True] <= missed[False] / cycles[False] + 0.03
    turned = [
        message.state for message in bench.told if isinstance(message, event.TaskState) and message.task == "counter"
    ]
    assert turned == ["OFF", "ON"]
    assert bench.runtime.ask(live.Check("s0")) == live.Findings(())


def test_a_failed_change_leaves_what_was_there_cycling(bench):  # R-X10
    bench.shop.task("other", SOURCE, frequency=500.0, rtpu="rt1", module="other", local={"SIZE": "9"})
    bench.change(("source", "user", "counter"), ("source", "user", "counter"))
    assert "9 is too many" in bench.change(("other",), ("other",), kill=("source",))
    assert bench.states() == dict.fromkeys(("source", "user", "counter"), "ON")
    bench.cycled(100)
    assert len(bench.value("ROW")) == 2
    assert bench.value("N") == 2


def test_shapes_change_in_a_running_runtime(bench):  # law 12, R-A03
    bench.change(("source", "user", "counter"), ("source", "user", "counter"))
    for size in ("3", "1", "4", "2"):
        assert bench.outcome(live.Reinit("s0", "source", (("SIZE", (size,)),))) == ""
        bench.cycled(20)
        assert len(bench.value("ROW")) == int(size)
    assert bench.runtime.ask(live.Check("s0")) == live.Findings(())


LOST = {"exits": "os._exit(3)", "loops": "exec('while True: pass')"}
WITHOUT_END = "self._hoard.append(bytearray(1 << 26))"
TALKS = "print('x' * (1 << 20), flush=True)"


def fall_sick(bench, act):
    bench.shop.task("sick", SICK.format(act=act), frequency=100.0, rtpu="rt0")
    assert bench.change(("far",), ("far",)) == ""
    assert bench.change(("sick",), ("sick",), subsystem="s1") == ""
    bench.figures()


def far_goes_on(bench):
    bench.cycled(100, "FAR")
    far = bench.figures()["far"]
    assert (far.state, far.rtpu) == ("ON", "rt1")
    assert far.miss <= 0.05 * far.cycle + 2


@pytest.mark.parametrize("how", LOST)
def test_a_unit_that_a_module_takes_along_is_named_and_the_others_go_on(bench, how):  # R-E10, law 30
    fall_sick(bench, LOST[how])
    (lost,) = bench.until(event.Lost, lambda message: message.name == "rt0")
    assert "rt0" in str(lost.cause)
    far_goes_on(bench)
    standing = bench.standing()
    assert {unit.name: unit.is_lost for unit in standing.rtpus} == {"rt0": True, "rt1": False}
    assert bench.states("s1") == {}
    bench.shop.task("counter", COUNTER, frequency=100.0, rtpu="rt1")
    assert bench.change(("counter",), ("counter",)) == ""
    answer = bench.runtime.ask(live.Change("s1", spawn=(bench.shop.planned("sick"),), code=(bench.shop.code("sick"),)))
    assert isinstance(answer, request.Prepared)
    assert "rt0" in str(answer.faults[0].reason)
    assert bench.runtime.ask(live.AddUnit("rt0")) == request.Done()
    assert {unit.name: unit.is_lost for unit in bench.standing().rtpus} == {"rt0": False, "rt1": False}
    bench.shop.task("counter", f"# anew\n{COUNTER}", frequency=100.0, rtpu="rt0")
    assert bench.change(("counter",), ("counter",), subsystem="s2") == ""
    bench.cycled(20, subsystem="s2")
    anew = [task.rtpu for home in bench.standing().subsystems if home.name == "s2" for task in home.tasks]
    assert anew == ["rt0"]
    far_goes_on(bench)


def test_a_module_that_takes_memory_without_end_is_in_error_and_nobody_else(bench):  # R-A18, law 30
    fall_sick(bench, WITHOUT_END)
    (failed,) = bench.until(event.Failed, lambda message: message.task == "sick")
    assert "MemoryError" in str(failed.text)
    far_goes_on(bench)
    assert bench.states("s1") == {"sick": "ERROR"}
    assert bench.change(kill=("sick",), subsystem="s1") == ""
    assert bench.change(("counter",), ("counter",)) == ""


def test_a_module_that_prints_megabytes_holds_nobody_up(bench):  # law 30
    fall_sick(bench, TALKS)
    bench.cycled(40, "SEEN", "s1")
    far_goes_on(bench)
    assert bench.states("s1") == {"sick": "ON"}


@pytest.mark.parametrize("act", ["raise ValueError('ill')", "os._exit(3)"])
def test_a_device_is_not_driven_on_with_what_a_task_of_another_unit_wrote_that_has_failed(bench, act):  # laws 4, 30
    bench.shop.task("hand", HAND, frequency=250.0, rtpu="rt0", local={"DEVICE": "boxes:gripper_left"})
    bench.shop.task("grip", GRIP.format(act=act), frequency=100.0, rtpu="rt1")
    worlds = (boxes_files(),)
    assert bench.change(("hand", "grip"), ("hand", "grip"), subsystem="s1", worlds=worlds) == ""
    (failed,) = bench.until(event.Failed, lambda failed: failed.task == "hand")
    state = "ERROR" if "raise" in act else "KILLED"
    assert f"task grip, which wrote GRIP, is {state}: the device is not driven on with that" in str(failed.text)
    drives = bench.until(event.Drive, lambda drive: drive.device == "boxes:gripper_left" and drive.state == "HELD")
    assert str(drives[-1].cause) == "commanded to hold"
    if state == "ERROR":
        (first,) = bench.until(event.Failed, lambda failed: failed.task == "grip")
        assert failed.at_s - first.at_s < 0.5  # on a machine at rest some milliseconds
    assert bench.states("s1")["hand"] == "ERROR"
