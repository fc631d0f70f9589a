"""The exchange of a living task's module."""

import hashlib

import pytest

from kit.labs.module_source import COUNTER, cycle, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.execution.statistics import status_of

MS = 1_000_000
OLD = module(
    "    N = OutVar('int')\n    log = []\n    def init(self):\n        self.log.append('init')\n"
    "    def on(self, inputs):\n        self.log.append('on')\n    def cycle(self):\n        self.N += 1\n"
    "    def off(self):\n        self.log.append('off')\n    def kill(self):\n        self.log.append('kill')"
)
NEW = OLD.replace("+= 1", "+= 100")
TAKES = NEW + "\n    def take(self, old):\n        self.log.append('take')\n        self.before = old.N"


def swap_of(rig, source, task="one", **given):
    """A Swap to this source, on ports of its own class; `given` are the words of `ExecutiveRig.spawn`."""
    return command.Swap(rig.spawn_of(task, source, **given))


def running(source=OLD, *, until=25 * MS, **given):
    rig = ExecutiveRig().spawn("one", source, **given).switch(on=[command.Launch("one", activation=4)])
    return rig.run(until)


def test_a_module_with_take_goes_on_where_the_old_one_stood_and_misses_no_cycle():  # R-X15, law 21
    rig = running()
    old, tid = rig.task("one").module, rig.task("one").tid
    count = len(rig.news)
    rig.do(swap_of(rig, TAKES))
    new = rig.task("one")
    assert (new.module.before, new.module.log, old.log) == (3, ["init", "take"], ["init", "on", "kill"])
    rig.run(45 * MS)
    assert rig["N"] == 3 + 200
    assert (new.counters.cycles, new.slot.missed, new.tid, new.activation) == (2, 0, tid, 4)
    assert [event for _, event in rig.news[count:]] == [
        news.Swapped(HOME, "one", hashlib.sha256(TAKES.encode()).hexdigest())
    ]


def test_a_module_without_take_comes_on_anew_in_the_old_ones_place():  # law 21
    rig = running()
    old = rig.task("one").module
    rig.do(swap_of(rig, NEW)).run(45 * MS)
    assert rig.task("one").module.log == ["init", "on"]
    assert old.log == ["init", "on", "off", "kill"]
    assert rig["N"] == 3 + 200
    assert [event.at_ns for event in rig.news_of(news.Cycled)] == [0, 30 * MS]


def test_the_others_keep_cycling_in_their_order():  # R-X15
    rig = running().spawn("other", COUNTER, aliases={"N": "M"}).switch(on=["other"])
    for source in (TAKES, NEW, OLD) * 3:
        rig.do(swap_of(rig, source)).run(rig.now + 10 * MS)
    assert rig.task("other").slot.missed == 0
    assert rig["M"] == rig.task("other").counters.cycles == 1 + 9


def test_a_task_that_is_off_stays_off_and_publishes_the_new_constants():  # law 21
    source = module("    C = OutConst('int')\n    E = OutBoth('int')\n    def init(self):\n        self.C = self.E = 1")
    rig = ExecutiveRig().spawn("one", source).do(swap_of(ExecutiveRig(), source))
    rig.do(swap_of(rig, source.replace("= 1", "= 7")))
    assert (rig.task("one").state, rig["C"], rig["E"]) == (State.OFF, 7, 7)


def test_first_values_do_not_fall_back_while_the_task_is_on():  # law 3
    source = module(
        "    C = OutConst('int')\n    E = OutBoth('int')\n    def init(self):\n        self.C = self.E = 1\n"
        "    def cycle(self):\n        self.E += 1\n    def take(self, old):\n        pass"
    )
    rig = running(source)
    written = rig.table.ring("E").count
    rig.do(swap_of(rig, source.replace("= 1\n", "= 5\n", 1)))
    assert (rig["C"], rig["E"]) == (5, 4)
    assert rig.table.ring("E").count == written
    assert rig.run(35 * MS)["E"] == 5


def test_a_task_in_error_is_repaired_and_cleared():  # R-A18, R-C28
    rig = running(cycle("raise ValueError('planted')"), until=0)
    rig.do(swap_of(rig, COUNTER))
    assert rig.task("one").state is State.ERROR
    rig.do(command.Clear(HOME, "one")).switch(on=["one"]).run(10 * MS)
    assert rig["N"] == 2


def test_the_rate_stays_as_it_was_changed():  # R-A04
    rig = running().switch(rates=[("one", 200.0)])
    rig.do(swap_of(rig, TAKES))
    assert (rig.task("one").period_ns, rig.task("one").module.dt) == (5 * MS, 0.005)
    assert status_of(rig.task("one"), rig.now + 100 * MS).profiled_s == pytest.approx(0.1)
    before = rig.task("one").counters.cycles
    rig.run(rig.now + 50 * MS)
    assert rig.task("one").counters.cycles - before == 10


def test_another_criticality_and_rank_count_from_the_next_cycle_on():  # law 1
    rig = running()
    rig.do(swap_of(rig, TAKES.replace("class One(Module):", "class One(Module):\n    crit = 5"), rank=3))
    assert rig.task("one").slot.key == (-5, 3, f"{HOME}/one")
    assert rig.run(35 * MS)["N"] == 103


def test_ports_may_come_and_go():  # law 21
    rig = running()
    more = module(
        "    N = OutVar('int')\n    X = InVar('int')\n    Y = OutVar('int')\n"
        "    def take(self, old):\n        pass\n    def cycle(self):\n        self.Y = self.X + 1"
    )
    rig.do(swap_of(rig, more)).run(35 * MS)
    assert rig["Y"] == 1
    rig.switch(forget=["Y"])
    assert rig.table.ring("Y").mark == rig.table.ring("Y").count == 1


BAD = [
    ("class :", "expected Python"),
    (module("    def init(self):\n        raise ValueError('no')"), "init: ValueError: no (one.py:"),
    (module("    G = Local('int', '-', 'gain')"), "expected a LOCAL line G"),
    (module("    def init(self):\n        self.Q_REFF = 1"), "Q_REFF is no port"),
    (module("    def take(self, old):\n        old.nothing()"), "take: AttributeError"),
    (module("    def take(self, old):\n        self.Q_REFF = 1"), "Q_REFF is no port"),
    (module("    def on(self, inputs):\n        raise AskAgain('where to?')"), "on: it asks for other input"),
    (module("    def on(self, inputs):\n        sys.exit()"), "on: SystemExit"),
    (module("    goal = Input('double')"), "on: it asks for other input: expected 1 values"),
]


@pytest.mark.parametrize(("source", "reason"), BAD)
def test_whatever_fails_leaves_the_old_one_exactly_as_it_was(source, reason):  # law 21
    rig = running()
    task, count, written = rig.task("one"), len(rig.news), rig.table.ring("N").count
    rig.do(swap_of(rig, source.replace("class One(Module):", "class One(Module):\n    C = OutConst('int')")))
    events = [event for _, event in rig.news[count:]]
    assert [type(event) for event in events] == [news.Refused]
    assert (events[0].command, reason in str(events[0].reason)) == ("swap", True), events[0].reason
    assert rig.task("one") is task
    assert (task.module.log, task.state) == (["init", "on"], State.ON)
    assert rig.table.ring("N").count == written
    assert "C" not in rig.table.entries or rig.table.ring("C").count == 0
    assert rig.run(45 * MS)["N"] == 5
    assert task.slot.missed == 0


def test_what_a_refused_module_took_is_given_back():  # law 21
    source = module("    def init(self):\n        raise ValueError\n    def kill(self):\n        sys.given_back = True")
    rig = running()
    rig.do(swap_of(rig, source))
    import sys

    assert sys.__dict__.pop("given_back")


def test_what_the_old_module_raises_on_its_way_out_is_a_warning():  # law 21
    rig = running(
        module("    def off(self):\n        raise ValueError('o')\n    def kill(self):\n        raise KeyError('k')")
    )
    rig.do(swap_of(rig, COUNTER))
    assert [event.text.split(" (")[0] for event in rig.news_of(news.Warned)] == [
        "off: ValueError: o",
        "kill: KeyError: 'k'",
    ]
    assert rig.task("one").state is State.ON


@pytest.mark.parametrize(
    ("given", "reason"), [({"task": "nobody"}, "no such task"), ({"kind": "aperiodic"}, "expected a task that is per")]
)
def test_what_is_not_there_or_of_another_kind_is_refused(given, reason):  # law 21
    rig = running()
    rig.do(swap_of(rig, NEW, **given))
    assert reason in rig.last(news.Refused).reason


def test_a_task_that_asks_is_not_exchanged():  # law 11
    asks = module("    goal = Input('double')")
    rig = ExecutiveRig().spawn("one", asks).switch(on=["one"])
    rig.do(swap_of(rig, asks))
    assert "while ASKING" in rig.last(news.Refused).reason


def test_the_last_argument_line_is_said_again():  # law 21
    asks = module("    goal = Input('double')\n    def on(self, inputs):\n        self.goal = inputs.goal")
    rig = ExecutiveRig().spawn("one", asks).switch(on=["one"]).do(command.Answer(HOME, "one", "2.5"))
    rig.do(swap_of(rig, asks))
    assert rig.task("one").module.goal == 2.5


ARM = module("    def cycle(self):\n        self.device.write((1.0,))", hardware=True)


def test_what_commands_a_device_is_exchanged_only_while_it_is_off():  # law 21
    rig = ExecutiveRig(MassWorld()).spawn("one", ARM, device="m0").switch(on=["one"]).run(100 * MS)
    rig.do(swap_of(rig, ARM, device="m0"))
    assert rig.last(news.Refused).reason == "it commands a device and is ON: turn it off first"
    rig.switch(off=["one"]).do(swap_of(rig, ARM.replace("1.0", "-1.0"), device="m0"))
    place = rig.bus.world.state("m0")[2]
    rig.switch(on=["one"]).run(400 * MS)
    assert rig.bus.world.state("m0")[2] < place


PIPE = """
    def init(self):
        import os
        self._in, self._out = os.pipe()
    def fileno(self):
        return self._in
    def kill(self):
        import os
        os.close(self._in)
        os.close(self._out)
"""
SYNC = module("    N = OutVar('int')" + PIPE + "    def sync(self):\n        self.N += 1")


@pytest.mark.parametrize("takes", ["", "\n    def take(self, old):\n        pass"])
def test_a_synchronous_task_waits_for_the_new_descriptor(takes):  # R-A04, law 21
    rig = ExecutiveRig().spawn("one", SYNC, kind="synchronous").switch(on=["one"])
    rig.do(swap_of(rig, SYNC.replace("+= 1", "+= 5") + takes, kind="synchronous"))
    new = rig.task("one").module
    assert rig.executive.events() == {new.fileno(): (HOME, "one")}
    rig.executive.event((HOME, "one"), 0)
    assert rig["N"] == 5
    rig.do(command.Kill(HOME, "one"))


def test_a_synchronous_module_without_a_descriptor_does_not_take_the_place():  # law 21
    rig = ExecutiveRig().spawn("one", SYNC, kind="synchronous").switch(on=["one"])
    before = rig.executive.events()
    rig.do(swap_of(rig, module(), kind="synchronous"))
    assert "fileno" in rig.last(news.Refused).reason
    assert rig.executive.events() == before
    rig.do(command.Kill(HOME, "one"))
