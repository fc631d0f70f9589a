"""What lives on one processing unit."""

import os

import pytest

from kit.labs.module_source import COUNTER, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.unit import ProcessingUnit

MS = 1_000_000


@pytest.fixture
def unit():
    return ProcessingUnit("rt0", {})


def task(rig, name, source=COUNTER, **given):
    from onika.runtime.modules.code import load

    return RunningTask(rig.spawn_of(name, source, **given), load(source, f"{name}.py", name), rig.views)


@pytest.fixture
def rig():
    return ExecutiveRig()


def test_a_task_gets_a_number_and_is_known_by_its_name(unit, rig):  # R-A11
    first, two = task(rig, "one"), task(rig, "two")
    unit.admit(first)
    unit.admit(two)
    assert (first.tid, two.tid) == (1, 2)
    assert unit.tasks == {(HOME, "one"): first, (HOME, "two"): two}
    assert unit.dismiss((HOME, "one")) is first
    assert unit.dismiss((HOME, "one")) is None
    assert list(unit.slots.values()) == [two]


def test_an_exchanged_task_keeps_number_place_and_slot(unit, rig):  # law 21
    old, new = task(rig, "one"), task(rig, "one")
    unit.admit(old)
    unit.enter(old, 0)
    slot = unit.scheduler.next_due(0)
    unit.scheduler.done(slot)
    unit.exchange(old, new)
    assert (new.tid, new.slot, unit.slots[slot], unit.tasks) == (1, slot, new, {(HOME, "one"): new})
    assert unit.scheduler.next_release() == 10 * MS


def test_a_task_is_profiled_while_it_is_on(unit, rig):  # R-A17
    running = task(rig, "one")
    unit.admit(running)
    unit.enter(running, 5)
    unit.leave(running, 25)
    unit.leave(running, 30)
    assert (running.counters.profiled_ns(100), unit.scheduler.next_release()) == (20, None)


def test_a_synchronous_task_is_found_by_its_descriptor(unit, rig):  # R-A04
    end, other = os.pipe()
    running = task(rig, "one", module(f"    def fileno(self):\n        return {end}"), kind="synchronous")
    unit.admit(running)
    unit.enter(running, 0)
    unit.await_event(running)
    assert (unit.events, unit.scheduler.next_release()) == ({end: (HOME, "one")}, None)
    unit.leave(running, 1)
    assert unit.events == {}
    os.close(end)
    os.close(other)
    with pytest.raises(OSError, match="descriptor"):
        unit.await_event(running)


def test_only_variables_of_the_subsystem_are_forgotten(unit, rig):  # law 3
    unit.admit(task(rig, "one"))
    rig.table.ring("N").write(bytes(4))
    unit.forget("other", ("N",))
    assert rig.table.ring("N").mark == 0
    unit.forget(HOME, ("N", "NOBODY"))
    assert rig.table.ring("N").mark == 1


def test_a_variable_that_no_task_here_has_any_more_is_not_marked(unit, rig):  # law 3, law 12
    first, two = task(rig, "one"), task(rig, "two", COUNTER.replace("N = ", "M = ").replace("self.N", "self.M"))
    unit.admit(first)
    unit.admit(two)
    (name, ring), *_ = first.binding.rings.items()
    ring.write(bytes(ring.size))
    unit.dismiss((HOME, "one"))
    unit.forget(HOME, (name,))
    assert ring.mark == 0


def test_what_is_said_is_taken_once(unit):
    unit.refuse(("s", "t"), "on", "because")
    assert [event.reason for event in unit.take_news()] == ["because"]
    assert unit.take_news() == []
