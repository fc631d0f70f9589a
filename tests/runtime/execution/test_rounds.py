"""When sweeps are made, what ends them, and that nothing shows but the time they save."""

import pytest

from kit.labs.module_source import COUNTER, cycle
from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.model.lifecycle import State
from onika.runtime import command, news

MS = 1_000_000
NAMES = ("one", "two", "three")


def rig_of_three(source=COUNTER, steady=2, frequency=1000.0):
    rig = ExecutiveRig(steady=steady)
    for rank, name in enumerate(NAMES):
        rig.spawn(name, source, aliases={"N": f"N_{name.upper()}"}, rank=rank, frequency=frequency)
    return rig.switch(on=NAMES)


def groups(rig):
    return rig.executive._rounds.groups


def test_tasks_that_stay_the_same_come_to_be_swept_and_miss_nothing():
    rig = rig_of_three().run(0)
    assert not groups(rig)
    rig.run(50 * MS)
    assert [len(group.slots) for _, _, group in groups(rig)] == [3]
    assert [rig[f"N_{name.upper()}"] for name in NAMES] == [51, 51, 51]
    assert rig.executive.next_release() == 51 * MS


def test_when_nothing_but_a_sweep_is_due_is_known_beforehand():
    rig = rig_of_three().run(0)
    assert rig.executive.sweeps_at() is None
    assert rig.run(50 * MS).executive.sweeps_at() == 51 * MS
    assert rig.do(command.Report()).executive.sweeps_at() is None


def test_each_rate_is_a_sweep_of_its_own_in_the_order_of_deadlines():  # law 1
    rig = rig_of_three()
    rig.do(command.Switch(HOME, (), (), (), (("two", 500.0),))).run(20 * MS)
    assert sorted(len(group.slots) for _, _, group in groups(rig)) == [1, 2]
    assert (rig["N_ONE"], rig["N_TWO"]) == (21, 11)


@pytest.mark.parametrize(
    "order",
    [
        command.Report(), command.Load(), command.Kill(HOME, "two"), command.Switch(HOME, ("two",), (), ()),
        command.Rank(HOME, (("two", -1),)), command.Stop(), command.Get(HOME, "two", "x"),
    ],
)  # fmt: skip
def test_every_command_ends_the_rounds(order):
    rig = rig_of_three().run(20 * MS)
    assert groups(rig)
    assert not groups(rig.do(order))


def test_the_figures_count_every_cycle_that_was_swept():  # R-A11
    rig = rig_of_three().run(2000 * MS)
    figures = {task.task: task for task in rig.do(command.Report()).last(news.Statuses).tasks}
    assert [figures[name].cycle for name in NAMES] == [2001] * 3
    assert all(0 < task.least_us <= task.mean_us <= task.most_us for task in figures.values())
    rig.run(2100 * MS)
    assert [task.cycle for task in rig.do(command.Report()).last(news.Statuses).tasks] == [100] * 3


def test_a_module_that_changes_itself_is_found_at_the_same_cycle_as_without_sweeps():
    source = cycle("if self.now > 0.1: self.STRAY = 1")
    found = {}
    for steady in (None, 1):
        rig = ExecutiveRig(steady=steady).spawn("one", source, frequency=1000.0).switch(on=["one"]).run(3000 * MS)
        found[steady] = [(at, entry.task, entry.entry) for at, entry in rig.news if isinstance(entry, news.Failed)]
    assert found[None] and found[None] == found[1]


def test_what_raises_in_a_sweep_is_an_error_of_its_task_and_the_others_go_on():  # R-A09
    source = cycle("if self.now > 0.0105 and self.dt < 0.0011: raise ValueError('stuck')")
    rig = ExecutiveRig(steady=1)
    for name, frequency in (("one", 1000.0), ("two", 500.0)):
        rig.spawn(name, source, frequency=frequency)
    rig.switch(on=["one", "two"]).run(30 * MS)
    (failed,) = rig.news_of(news.Failed)
    at = next(at for at, entry in rig.news if isinstance(entry, news.Failed))
    assert (failed.task, failed.entry, at) == ("one", "cycle", 11 * MS)
    assert failed.line > 0
    assert (rig.task("one").state, rig.task("two").counters.cycles) == (State.ERROR, 6)


def test_a_warning_is_told_at_its_time_and_the_rounds_go_on():
    rig = rig_of_three(cycle("if round(self.now * 1000) == 10: self.warn('ten')"), steady=1).run(30 * MS)
    assert [(at, entry.task) for at, entry in rig.news if isinstance(entry, news.Warned)] == [
        (10 * MS, name) for name in NAMES
    ]
    assert groups(rig)


def test_a_task_that_comes_on_beside_a_sweep_has_its_first_cycle_in_order():  # laws 1, 13
    rig = rig_of_three().run(20 * MS)
    rig.spawn("late", COUNTER, aliases={"N": "N_LATE"}, rank=1, frequency=1000.0)
    rig.switch(on=["late"]).run(40 * MS)
    assert [len(group.slots) for _, _, group in groups(rig)] == [4]
    assert (rig["N_LATE"], rig["N_ONE"]) == (21, 41)


def test_one_that_runs_late_goes_one_by_one_and_its_periods_are_counted():  # law 2
    rig = rig_of_three().run(20 * MS)
    assert rig.executive.run_due(25 * MS + 1, 1000) is None
    assert rig.task("one").slot.missed == 4


def test_sweeps_are_kept_for_the_job_that_comes_again():
    rig = rig_of_three(steady=10).run(30 * MS)
    rig.switch(off=["two"]).run(60 * MS)
    made = len(rig.executive._rounds._kept)
    rig.switch(on=["two"]).run(70 * MS)
    assert groups(rig) and len(rig.executive._rounds._kept) == made == 2
    rig.do(command.Kill(HOME, "three"))
    assert not rig.executive._rounds._kept
