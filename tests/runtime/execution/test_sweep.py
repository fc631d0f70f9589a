"""A sweep bound to tasks that live: what it leaves in the table, what it counts, where it ends."""

import gc
import weakref

import pytest

from kit.labs.module_source import COUNTER, cycle
from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.runtime.execution.sweep import Sweep
from onika.runtime.execution.whereabouts import Whereabouts


def swept(source=COUNTER, names=("one",), **given):
    """A rig whose tasks are ON and have had their first cycle, and their sweep."""
    rig = ExecutiveRig()
    for name in names:
        rig.spawn(name, source, aliases={"N": f"N_{name.upper()}"}, **given)
    rig.switch(on=names).run(0)
    running = Whereabouts()
    return rig, Sweep([rig.task(name) for name in names], running), running


def test_a_sweep_publishes_what_the_cycles_left():
    rig, sweep, _ = swept(names=("one", "two"))
    assert [sweep.run(10_000_000 * k) for k in range(1, 9)] == [None] * 8
    assert (rig["N_ONE"], rig["N_TWO"]) == (9, 9)
    assert rig.table.ring("N_ONE").faults() == []
    rig.run(rig.now + 10_000_000)  # and whoever goes on one by one is no stranger
    assert rig.table.ring("N_ONE").faults() == []


def test_a_stranger_who_publishes_in_between_is_noticed():  # R-A12
    rig, sweep, _ = swept()
    sweep.run(10_000_000)
    rig.table.ring("N_ONE").write(bytes(rig.table.ring("N_ONE").size))
    sweep.run(20_000_000)
    assert rig.table.ring("N_ONE").faults()


def test_times_are_counted_when_they_are_asked_for():  # R-A11
    rig, sweep, _ = swept(names=("one", "two"))
    before = rig.task("two").counters.cycles
    for k in range(1, 4):
        sweep.run(10_000_000 * k)
    sweep.count()
    counters = rig.task("two").counters
    assert counters.cycles == before + 3
    assert 0 < counters.least_ns <= counters.mean_ns <= counters.most_ns <= counters.total_ns
    sweep.count()
    assert counters.cycles == before + 3


@pytest.mark.parametrize(
    ("body", "place"), [("self.warn('look')", 0), ("if self.now > 0.015: raise ValueError('x')", 0)]
)
def test_a_sweep_ends_at_the_task_at_which_something_happens(body, place):
    rig, sweep, running = swept(cycle(body), names=("one", "two"))
    rig.task("two").warnings.clear()
    rig.task("one").warnings.clear()
    stop = sweep.run(20_000_000)
    assert stop is not None and stop[0] == place
    assert running.task == f"{HOME}/one"
    sweep.count(stop[0] + 1)


def test_a_zero_of_a_c_function_is_nothing():
    _, sweep, _ = swept(cycle("return 0"))
    assert sweep.run(10_000_000) is None


def test_a_sweep_that_is_forgotten_lets_its_tasks_go():
    rig, sweep, _ = swept()
    task = weakref.ref(rig.task("one"))
    gc.disable()
    try:
        sweep.run(10_000_000)
        rig.executive.tasks.clear()
        rig.executive._unit.slots.clear()
        rig.executive._unit._rings.clear()
        rig.executive._unit.scheduler.__init__()
        del sweep
        assert task() is None
    finally:
        gc.enable()


def test_a_module_is_to_be_looked_at_once_in_so_many_cycles():
    rig, sweep, _ = swept()
    task = rig.task("one")
    task.check_mask = 7
    assert sweep.most_laps == -task.counters.cycles & 7
    task.counters.cycles = 8
    assert sweep.most_laps == 0
