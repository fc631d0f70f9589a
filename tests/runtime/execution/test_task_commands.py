"""Changes of tasks that live: values by name, places in the order, constants, ports, out of ERROR."""

import pytest

from kit.labs.module_source import module
from kit.runtime.executive_rig import HOME, ExecutiveRig, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.words.shape import Shape

MS = 1_000_000


# Get and set


def test_a_module_answers_get_and_set():  # R-A05
    body = "    gain = 1.0\n    def get(self, name):\n        return getattr(self, name)\n"
    body += "    def set(self, name, value):\n        setattr(self, name, float(value))"
    rig = rig_of(module(body)).do(command.Set(HOME, "one", "gain", "2.5")).do(command.Get(HOME, "one", "gain"))
    assert rig.news_of(news.Got) == [news.Got(HOME, "one", "gain", "2.5"), news.Got(HOME, "one", "gain", 2.5)]


@pytest.mark.parametrize("body", ["    pass", "    def get(self, name):\n        sys.exit()"])
def test_a_get_that_raises_is_refused_and_the_task_lives_on(body):  # R-A05
    rig = rig_of(module(body)).do(command.Get(HOME, "one", "gain"))
    assert rig.news_of(news.Got) == []
    assert rig.last(news.Refused).command == "get or set"
    assert rig.task("one").state is State.OFF


def test_what_cannot_travel_is_refused():
    rig = rig_of(module("    def get(self, name):\n        return 2 ** 70")).do(command.Get(HOME, "one", "x"))
    assert "OverflowError" in rig.last(news.Refused).reason


# Ranks


def test_ranks_are_taken_over_between_cycles_without_losing_a_release():  # law 1
    source = module(
        "    N = OutVar('int')\n    SEEN = InVar('int')\n    def cycle(self):\n        self.N = self.SEEN + 1"
    )
    rig = ExecutiveRig().spawn("a", source, rank=0, aliases={"N": "A", "SEEN": "B"})
    rig.spawn("b", source, rank=1, aliases={"N": "B", "SEEN": "A"}).switch(on=["a", "b"]).run(0)
    assert (rig["A"], rig["B"]) == (1, 2)
    rig.do(command.Rank(HOME, (("a", 2), ("nobody", 0)))).run(10 * MS)
    assert (rig["A"], rig["B"]) == (3, 2)
    assert [rig.task(name).counters.cycles for name in "ab"] == [2, 2]
    assert [rig.task(name).slot.missed for name in "ab"] == [0, 0]
    assert rig.news_of(news.Refused) == [news.Refused(HOME, "nobody", "rank", "no such task")]


# Constants that change


SUPPLIER = module(
    "    NDOF = OutConst('int')\n    VALUE = Local('int', default=2)\n"
    "    def init(self):\n        self.NDOF = self.VALUE"
)
CONSUMER = module(
    "    NDOF = InConst('int')\n    Q = OutVar('double[NDOF]')\n    M = OutConst('int')\n    inits = 0\n"
    "    def init(self):\n        self.inits += 1\n        self.M = 10 * self.NDOF\n        self.q = self.Q\n"
    "    def cycle(self):\n        self.Q = range(self.NDOF)"
)


def ndof_rig():
    return ExecutiveRig().spawn("robot", SUPPLIER).spawn("one", CONSUMER, constants={"NDOF": 2})


def test_a_changed_constant_reaches_its_consumer_with_a_reinit():  # R-A01, law 10
    rig = ndof_rig()
    rig.do(command.Rebind(HOME, "robot", (), (("VALUE", ("3",)),))).do(command.Reinit(HOME, "robot"))
    assert (rig["NDOF"], rig["M"]) == (3, 20)
    rig.do(command.Reinit(HOME, "one"))
    assert rig["M"] == 30
    assert rig.news_of(news.Reinitialised) == [news.Reinitialised(HOME, name) for name in ("robot", "one")]


def test_a_change_of_ndof_binds_the_ports_anew_and_the_instance_lives_on():  # R-A03, law 12
    rig = ndof_rig().switch(on=["one"]).run(0)
    module_, entry = rig.task("one").module, rig.table.entry("Q(3)", Shape.parse("double[3]"))
    rig.switch(off=["one"]).do(command.Rebind(HOME, "robot", (), (("VALUE", ("3",)),)))
    rig.do(command.Rebind(HOME, "one", (command.BoundPort("Q", "Q", "double[3]", entry.offset),)))
    assert rig.news_of(news.Rebound) == [news.Rebound(HOME, name) for name in ("robot", "one")]
    rig.do(command.Reinit(HOME, "robot")).do(command.Reinit(HOME, "one")).switch(on=["one"]).run(10 * MS)
    assert rig["Q(3)"].tolist() == [0.0, 1.0, 2.0]
    assert rig.task("one").module is module_
    assert (module_.inits, module_.q.size) == (2, 3)
    rig.switch(forget=["Q"])
    assert rig.table.ring("Q(3)").mark == rig.table.ring("Q(3)").count


def test_what_was_bound_anew_does_not_come_on_before_it_is_reinitialised():  # law 12
    rig = ndof_rig().do(command.Rebind(HOME, "one", ())).switch(on=["one"])
    assert rig.last(news.Refused).reason == "it was bound anew and waits to be reinitialised"
    assert rig.do(command.Reinit(HOME, "one")).switch(on=["one"]).task("one").state is State.ON


def test_a_reinit_that_raises_is_an_error_and_clear_initialises():  # R-A05
    rig = rig_of(
        module("    bad = True\n    def reinit(self):\n        if self.bad:\n            raise ValueError('no')")
    )
    rig.do(command.Reinit(HOME, "one"))
    assert (rig.last(news.Failed).entry, rig.task("one").state) == ("reinit", State.ERROR)
    rig.do(command.Clear(HOME, "one"))
    assert (len(rig.news_of(news.Initialised)), rig.task("one").state) == (2, State.OFF)


def test_a_bad_parameter_is_refused_and_nothing_has_changed():  # R-B07
    rig = ndof_rig().do(command.Rebind(HOME, "robot", (), (("VALUE", ("many",)),)))
    assert "LOCAL VALUE" in rig.last(news.Refused).reason
    assert rig.task("robot").is_initialised


def test_a_task_in_error_is_bound_anew_and_cleared():  # law 12
    rig = ndof_rig().switch(on=["one"])
    rig.task("one").module.cycle = lambda: 1 / 0
    rig.run(0).do(command.Rebind(HOME, "one", ()))
    assert rig.task("one").state is State.ERROR
    rig.do(command.Clear(HOME, "one"))
    assert (rig.task("one").state, rig.task("one").module.inits) == (State.OFF, 2)
