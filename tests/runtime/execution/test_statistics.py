"""Figures of a running task by the words of the thesis (dissertation §A.5, STATINFO)."""

import pytest

from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.execution.statistics import load_of, status_of, values_of

MS = 1_000_000
SOURCE = """
from onika.module import InVar, Module, OutVar

class One(Module):
    crit = 3
    IMAGE = InVar("byte[20,20]")
    Q = OutVar("double[2]")
    NAME = OutVar("string")
    FLAG = OutVar("char")
    N = OutVar("int", name="N^")

    def cycle(self):
        self.N += 1
        if self.N == 5:
            self.Q = (1.5, float("inf"))
            self.NAME, self.FLAG = "cube", "x"
            raise ValueError("planted")
"""


@pytest.fixture
def rig():
    return (
        ExecutiveRig()
        .spawn("one", SOURCE)
        .spawn("two", SOURCE, aliases={"N^": "M", "Q": "R", "NAME": "P", "FLAG": "G"})
    )


def test_a_status_has_every_column_of_the_thesis(rig):  # R-A11
    rig.switch(on=["one"]).run(25 * MS)
    task = rig.task("one")
    task.counters.cycles = 0
    for took in (1_000_000, 3_000_000):
        task.counters.add(took)
    task.counters.total_ns = 4_000_000
    task.counters.least_ns = 1_000_000
    task.counters.most_ns = 3_000_000
    status = status_of(task, 40 * MS)
    assert (status.tid, status.letter, status.crit, status.state, status.miss) == (1, "P", 3, "ON", 0)
    assert (status.reference_hz, status.reference_ms) == (100.0, 10.0)
    assert status.profiled_s == pytest.approx(0.04)
    assert (status.cycle, status.measured_hz, status.measured_ms) == (2, pytest.approx(50.0), pytest.approx(20.0))
    assert (status.least_us, status.mean_us, status.most_us, status.total_us) == (1000.0, 2000.0, 3000.0, 4000.0)
    uses = [status.use(duration) for duration in (status.least_us, status.mean_us, status.most_us)]
    assert uses == [pytest.approx(use) for use in (0.1, 0.2, 0.3)]
    assert 0.0 < status.tick_ms <= 1.0


def test_counters_begin_anew_with_a_status_and_the_profile_goes_on_from_there(rig):  # R-A17
    rig.switch(on=["one"]).run(15 * MS)
    rig.task("one").slot.missed = 3
    first, second = status_of(rig.task("one"), 20 * MS), status_of(rig.task("one"), 50 * MS)
    assert (first.cycle, first.miss, first.profiled_s) == (2, 3, pytest.approx(0.02))
    assert (second.cycle, second.miss, second.most_us, second.profiled_s) == (0, 0, 0.0, pytest.approx(0.03))


def test_the_measured_rate_is_that_of_the_time_in_which_it_was_on(rig):  # R-A11
    rig.switch(on=["one"]).run(15 * MS)
    rig.now = 15 * MS
    rig.switch(off=["one"])
    rig.now = 1000 * MS
    status = status_of(rig.task("one"), rig.now)
    assert status.profiled_s == pytest.approx(0.015)
    assert status.measured_hz == pytest.approx(2 / 0.015)


def test_a_profile_shorter_than_a_period_makes_no_high_rate(rig):  # R-A11
    rig.switch(on=["one"]).run(0)
    assert status_of(rig.task("one"), 1).measured_hz == pytest.approx(100.0)


@pytest.mark.parametrize(("kind", "letter"), [("periodic", "P"), ("synchronous", "Y"), ("aperiodic", "A")])
def test_the_kind_of_a_task_is_one_letter(kind, letter):  # R-A11
    figures = ExecutiveRig().spawn("one", SOURCE, kind=kind, frequency=100.0).do(command.Report())
    assert figures.news_of(news.Statuses)[0].tasks[0].letter == letter


def test_numbers_of_tasks_are_never_given_twice(rig):  # R-A11
    rig.do(command.Kill(HOME, "two")).spawn("two", SOURCE, aliases={"N^": "M"})
    assert [task.tid for task in rig.executive.tasks.values()] == [1, 3]


def test_a_load_resets_nothing_and_outlives_a_status(rig):  # R-X13
    rig.switch(on=["one"]).run(25 * MS)
    before = load_of(rig.task("one"))
    assert load_of(rig.task("one")) == before
    assert (before.is_on, before.hz, before.cycles) == (True, 100.0, 3)
    assert 0.0 < before.mean_us <= before.most_us
    rig.run(35 * MS).do(command.Report())
    latest = load_of(rig.task("one"))
    assert latest.cycles == 4
    rig.do(command.Report())
    assert load_of(rig.task("one")) == latest
    assert rig.do(command.Load()).news_of(news.Loads) == [news.Loads("unit", (latest, load_of(rig.task("two"))))]
    assert load_of(rig.task("two")).use == 0.0


def test_a_failure_tells_the_values_of_that_cycle(rig):  # R-A18
    rig.table.ring("IMAGE").write(bytes(range(200)) * 2)
    rig.switch(on=["one"]).run(100 * MS)
    values = rig.news_of(news.Failed)[0].values
    assert rig.task("one").state is State.ERROR
    assert (values["N^"], values["Q"], values["NAME"], values["FLAG"]) == (5, [1.5, float("inf")], "cube", "x")
    assert values["IMAGE"] == [*range(64), "… (400)"]
    assert rig["N^"] == 4  # what failed was not published
    failed = next(entry for _, entry in rig.news if isinstance(entry, news.Failed))
    assert news.decode(news.encode(failed)).values == values


def test_short_vectors_keep_their_shape(rig):  # R-A18
    source = "from onika.module import Module, OutVar\nclass One(Module):\n    T = OutVar('double[2,2]')"
    rig.spawn("three", source)
    assert values_of(rig.task("three").binding) == {"T": [[0.0, 0.0], [0.0, 0.0]]}


def test_a_load_is_not_judged_by_the_few_cycles_since_a_status(rig):  # R-X13
    source = "from onika.module import Module\nclass One(Module):\n    def cycle(self):\n        pass"
    rig.spawn("three", source).switch(on=["three"]).run(55 * MS)
    whole = load_of(rig.task("three"))
    rig.do(command.Report()).run(75 * MS)
    assert 0 < rig.task("three").counters.cycles < whole.cycles
    assert load_of(rig.task("three")).cycles == whole.cycles + rig.task("three").counters.cycles
    rig.run(495 * MS)
    assert load_of(rig.task("three")).cycles == rig.task("three").counters.cycles > whole.cycles
