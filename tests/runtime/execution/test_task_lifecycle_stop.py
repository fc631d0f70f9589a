"""A stop, and the end of a task, by themselves: in which order devices hold and modules have their word (law 27)."""

from types import SimpleNamespace

import pytest

from onika.model.lifecycle import LifecycleInput, State, refusal
from onika.runtime import command, news
from onika.runtime.error import ModuleError
from onika.runtime.execution.task_lifecycle import TaskLifecycle
from onika.words.reason import Reason

CAUSE = Reason.plain("the device server is gone")


class Task:
    """Notes in a common log what is done to it."""

    def __init__(self, log, name, state=State.ON, device="a device"):
        self.log, self.name, self.state, self.device = log, name, state, device
        self.address = ("s", name)
        self.activation = 7
        self.is_initialised = True
        self.module = SimpleNamespace(kill=lambda: self.note("kill"))

    @property
    def is_on(self):
        return self.state is State.ON

    def note(self, what):
        self.log.append((self.name, what))

    def hold(self):
        self.note("hold")

    def off(self):
        self.note("off")

    def part(self):
        self.note("part")

    def step(self, step):
        self.note(step.value)
        self.state = State.KILLED if step is LifecycleInput.KILL else State.OFF


class EntryPoints:
    """Calls entry points; some fail."""

    def __init__(self, log):
        self.log = log
        self.failing = set()

    def attempt(self, task, entry, now, call):
        assert now == 5
        call()
        if (task.name, entry) in self.failing:
            task.state = State.ERROR
            return False
        self.log.append((task.name, f"{entry} done"))
        return True

    def fail(self, task, entry, error, now):
        self.log.append((task.name, f"fails: {entry}, {type(error).__name__} {error}, {now}"))


class Unit:
    """A processing unit that notes what it is told."""

    def __init__(self, log):
        self.log = log
        self.tasks = {}
        self.is_stopped = False
        self.told = []
        self.tell = self.told.append
        self.refused = []
        self.prepared = SimpleNamespace(
            drop=lambda name: log.append((name, "unprepared")), drop_all=lambda: log.append(("all", "unprepared"))
        )

    def refuse(self, address, entry, reason):
        self.refused.append((address, entry, reason))

    def forget(self, subsystem, names):
        pass

    def leave(self, task, now):
        self.log.append((task.name, f"left at {now}"))

    def watch(self, task, now):
        self.log.append((task.name, f"watched at {now}"))

    def dismiss(self, address):
        self.log.append((address[1], "dismissed"))
        del self.tasks[address]


class Bench:
    def __init__(self):
        self.log = []
        self.unit, self.entry_points = Unit(self.log), EntryPoints(self.log)
        self.lifecycle = TaskLifecycle(self.unit, self.entry_points)

    def task(self, name, *given):
        task = Task(self.log, name, *given)
        self.unit.tasks[task.address] = task
        return task


@pytest.fixture
def bench():
    return Bench()


def goes_off(name):
    return [(name, what) for what in ("left at 5", "watched at 5", "off", "off done", "off")]


def test_in_a_stop_every_device_holds_before_any_module_has_its_word(bench):  # law 27
    for name, state in (("a", State.ON), ("b", State.ERROR), ("c", State.ON)):
        bench.task(name, state)
    bench.lifecycle.stop(5)
    assert bench.unit.is_stopped is True
    assert bench.log[:4] == [("all", "unprepared"), ("a", "hold"), ("b", "hold"), ("c", "hold")]
    assert bench.log[4:] == [*goes_off("a"), *goes_off("c")]
    assert bench.unit.told == [news.Changed("s", name, "OFF", 5, "", 7) for name in ("a", "c")]


def test_a_module_whose_off_fails_keeps_no_other_on(bench):  # law 27
    bench.task("a"), bench.task("b")
    bench.entry_points.failing.add(("a", "off"))
    bench.lifecycle.stop(5)
    assert [task.state for task in bench.unit.tasks.values()] == [State.ERROR, State.OFF]
    assert bench.unit.told == [news.Changed("s", "b", "OFF", 5, "", 7)]


def test_a_task_that_asks_is_told_no_off_but_goes_off(bench):  # R-A05
    task = bench.task("a", State.ASKING)
    bench.lifecycle.stop(5)
    assert bench.log[2:] == [("a", "left at 5"), ("a", "watched at 5"), ("a", "off")]
    assert task.state is State.OFF
    assert bench.unit.told == [news.Changed("s", "a", "OFF", 5, "", 7)]


@pytest.mark.parametrize("state", [State.OFF, State.WAITING, State.ERROR])
def test_what_is_off_already_is_left_alone(bench, state):
    bench.task("a", state)
    bench.lifecycle.stop(5)
    assert (bench.log, bench.unit.told) == ([("all", "unprepared"), ("a", "hold")], [])


@pytest.mark.parametrize(("state", "off"), [(State.ON, goes_off("a")), (State.OFF, []), (State.ERROR, [])])
def test_who_is_killed_goes_off_first_and_its_device_holds_whatever_its_module_did(bench, state, off):  # law 18
    bench.task("a", state), bench.task("b")
    bench.lifecycle.kill(("s", "a"), 5)
    end = [("a", what) for what in ("dismissed", "kill", "kill done", "part", "hold", "kill")]
    assert bench.log == [("s", "unprepared"), *off, *end]
    assert bench.unit.told == [news.Changed("s", "a", "KILLED", 5, activation=7)]
    assert list(bench.unit.tasks) == [("s", "b")]


def test_who_asks_is_killed_too(bench):  # R-A05
    bench.task("a", State.ASKING)
    bench.lifecycle.kill(("s", "a"), 5)
    assert bench.log[1:4] == [("a", "left at 5"), ("a", "watched at 5"), ("a", "off")]


def test_who_is_not_there_is_killed_already(bench):
    bench.lifecycle.kill(("s", "a"), 5)
    assert bench.log == [("s", "unprepared")]
    assert bench.unit.told == [news.Changed("s", "a", "KILLED", 5)]


def test_where_devices_are_gone_every_task_that_drives_one_fails(bench):  # law 16
    bench.task("a"), bench.task("b", State.ON, None), bench.task("c", State.OFF), bench.task("e")
    bench.lifecycle.fail_devices(CAUSE, 5)
    failed = f"fails: device, {ModuleError.__name__} {CAUSE}, 5"
    assert bench.log == [("all", "unprepared"), ("a", failed), ("e", failed)]


def refused_on(bench, name="a"):
    """Why a task does not come on; nothing is done to it."""
    bench.log.clear()
    bench.lifecycle.switch([command.Switch("s", off=(), forget=(), on=(command.Launch(name),))], 5)
    assert bench.log == [("s", "unprepared")]
    (((_, refused), entry, reason),) = bench.unit.refused
    assert (refused, entry) == (name, "on")
    return reason


def test_after_a_stop_nothing_comes_to_life_and_nothing_on(bench):  # law 27
    bench.task("a", State.OFF)
    bench.lifecycle.stop(5)
    assert refused_on(bench) == Reason.of("runtime.unit_stopped")
    bench.unit.refused.clear()
    assert bench.lifecycle.make(SimpleNamespace(subsystem="s", task="b")) is None
    assert bench.unit.refused == [(("s", "b"), "spawn", Reason.of("runtime.unit_stopped"))]


def test_what_is_not_there_or_not_ready_does_not_come_on(bench):  # R-A05
    assert refused_on(bench) == Reason.of("runtime.no_such_task")
    bench.unit.refused.clear()
    task = bench.task("a", State.ERROR)
    assert refused_on(bench) == refusal(State.ERROR, LifecycleInput.ON)
    bench.unit.refused.clear()
    task.state, task.is_initialised = State.OFF, False
    assert refused_on(bench) == Reason.of("runtime.waits_to_be_reinitialised")


def test_turning_off_what_is_not_there_harms_nothing(bench):
    bench.lifecycle.switch([command.Switch("s", off=("a",), forget=(), on=())], 5)
    assert (bench.unit.told, bench.unit.refused) == ([], [])
