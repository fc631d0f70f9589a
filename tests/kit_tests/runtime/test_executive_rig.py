"""The rig for several tasks."""

import gc
from pathlib import Path

import pytest

from kit.labs.module_source import COUNTER
from kit.runtime.executive_rig import HOME, ExecutiveRig, rig_of
from kit.worlds.mass_world import MassWorld
from onika.runtime import command, news

MS = 1_000_000
COUNT = """
from onika.module import Module, OutVar, finish

class Count(Module):
    trigger = True
    N = OutVar("int", "-", "cycles")

    def cycle(self):
        self.N += 1
        return finish() if self.N == 5 else None
"""
PUSH = """
from onika.module import Module, OutVar

class Push(Module):
    hardware = True
    X = OutVar("double", "m", "place")

    def cycle(self):
        self.X = self.device.read()[0]
        self.device.write((1.0,))
"""


def test_tasks_run_until_a_time_and_their_variables_are_read():
    rig = ExecutiveRig().spawn("count", COUNT).switch(on=["count"]).run(25 * MS)
    assert rig["N"] == 3
    assert rig.task("count").spawn.path == "count.py"


def test_requests_come_at_their_times():
    off = command.Switch(HOME, ("count",), (), ())
    rig = ExecutiveRig().spawn("count", COUNT).switch(on=["count"]).run(100 * MS, [(15 * MS, off)])
    assert rig["N"] == 2
    assert (15 * MS, news.Changed(HOME, "count", "OFF", 15 * MS)) in rig.news


def test_what_news_lead_to_is_done_at_the_same_time():
    def react(message):
        return [command.Kill(HOME, "count")] if isinstance(message, news.Finished) else []

    rig = ExecutiveRig(react=react).spawn("count", COUNT).switch(on=["count"]).run(100 * MS)
    assert [at for at, _ in rig.news][-2:] == [40 * MS, 40 * MS]
    with pytest.raises(KeyError):
        rig.task("count")


def test_declared_costs_let_time_pass():
    rig = ExecutiveRig(costs={"count": 15 * MS}).spawn("count", COUNT).switch(on=["count"]).run(50 * MS)
    assert rig["N"] == 4
    assert rig.task("count").slot.missed == 1  # the period from 20 to 30


def test_a_world_moves_along():
    rig = ExecutiveRig(MassWorld()).spawn("push", PUSH, device="m0").switch(on=["push"]).run(1000 * MS)
    assert rig["X"] == pytest.approx(0.5, rel=5e-3)


def test_names_and_shapes_are_those_the_test_says():
    source = COUNT.replace('OutVar("int"', 'OutVar("int[K]"').replace("self.N == 5", "False")
    rig = ExecutiveRig().spawn("one", source, aliases={"N": "M"}, constants={"K": 2}).switch(on=["one"]).run(10 * MS)
    assert rig["M"].tolist() == [2, 2]


def test_a_source_that_cannot_be_loaded_is_refused_as_on_a_unit():
    assert "expected Python" in ExecutiveRig().spawn("bad", "class :").news_of(news.Refused)[0].reason


def test_a_rig_gives_its_memory_back_with_its_last_use():
    gc.collect()
    gc.disable()
    try:
        before = len(list(Path("/proc/self/fd").iterdir()))
        for _ in range(3):
            ExecutiveRig().spawn("one", COUNTER).switch(on=["one"]).run(0)
        assert len(list(Path("/proc/self/fd").iterdir())) == before
    finally:
        gc.enable()


def test_the_last_news_of_a_kind_of_a_rig_with_one_task():
    rig = rig_of(COUNTER).switch(on=["one"]).switch(off=["one"])
    assert [change.state for change in rig.news_of(news.Changed)] == ["ON", "OFF"]
    assert rig.last(news.Changed).state == "OFF"
