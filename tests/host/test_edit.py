import pytest

from onika.testing.asker import Asker
from onika.testing.rail import rail
from onika.testing.workshop import Workshop
from onika.wire import event, live
from onika.wire.request import Reply

SOURCE = """
from onika.module import Local, Module, OutConst, OutVar

class Source(Module):
    N = OutConst("int", "-", "how many")
    LEVEL = OutVar("double", "m", "a level")
    SIZE = Local("int", "-", "how many", default=2)

    def init(self):
        self.N = self.SIZE

    def cycle(self):
        self.LEVEL = self.LEVEL + 1.0
"""
USER = """
from onika.module import InConst, InVar, Module, ModuleError, OutVar

class User(Module):
    N = InConst("int", "-", "how many")
    LEVEL = InVar("double", "m", "a level")
    ROW = OutVar("double[N]", "m", "the level, N times")

    def init(self):
        if self.N > 4:
            raise ModuleError(f"{self.N} is too many")

    def cycle(self):
        self.ROW = [self.LEVEL] * self.N
"""
READER = """
from onika.module import InConst, InVar, Module, OutVar

class Reader(Module):
    N = InConst("int", "-", "how many")
    ROW = InVar("double[N]", "m", "the level, N times")
    SUM = OutVar("double", "m", "all of it")

    def cycle(self):
        self.SUM = float(sum(self.ROW))
"""
COUNTER = """
from onika.module import Module, OutVar

class Counter(Module):
    COUNT = OutVar("double", "-", "cycles since it came on")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
"""
BROKEN = """
from onika.module import Module, ModuleError, OutVar

class Broken(Module):
    LEVEL = OutVar("double", "m", "a level")

    def init(self):
        raise ModuleError("no sensor")
"""
SULKY = """
from onika.module import Module, ModuleError, OutVar

class Sulky(Module):
    LEVEL = OutVar("double", "m", "a level")

    def on(self, inputs):
        raise ModuleError("not today")
"""


class Hand:
    """Changes a subsystem by hand."""

    def __init__(self, rtpus=("rt0",)):
        self.asker = Asker(rtpus)
        self.shop = Workshop()

    def task(self, name, source, **settings):
        return self.shop.task(name, source, **settings)

    def code(self, *names):
        return tuple(self.shop.code(name) for name in names)

    def change(self, spawn=(), on=(), session="me", **what):
        tasks = tuple(self.shop.planned(name) for name in spawn)
        turns = tuple(one if isinstance(one, live.Turn) else live.Turn(one) for one in on)
        return self.asker.change(session=session, spawn=tasks, code=self.code(*spawn), on=turns, **what)

    def let_pass(self, seconds):
        self.asker.ask(live.Advance(seconds))

    @property
    def states(self):
        return self.asker.states()

    def cycles(self, task):
        figures = self.asker.ask(live.Status())
        return next(one.cycle for one in figures.tasks if one.task == task)


@pytest.fixture
def hand():
    one = Hand()
    one.task("source", SOURCE)
    one.task("user", USER)
    one.task("reader", READER)
    one.task("counter", COUNTER, frequency=50.0)
    return one


def test_tasks_are_born_off_and_come_on_by_command(hand):  # R-A05
    assert hand.change(spawn=["user", "source"]) == ""
    assert hand.states == {"user": "OFF", "source": "OFF"}
    assert hand.change(on=["source", "user"]) == ""
    hand.let_pass(1.0)
    assert hand.asker.values("ROW")["ROW"] == [101.0, 101.0]
    assert hand.change(off=("user",), kill=("source",)) == ""
    assert hand.states == {"user": "OFF"}


def test_a_task_without_its_constant_waits_and_says_for_what(hand):  # law 10
    assert hand.change(spawn=["user"]) == ""
    standing = hand.asker.ask(live.Survey()).subsystems[0].tasks[0]
    assert (standing.state, standing.reason) == ("WAITING", "waits for N")
    assert "waits for N" in hand.change(on=["user"])
    assert hand.change(spawn=["source"]) == ""
    assert hand.states == {"user": "OFF", "source": "OFF"}


def test_a_failed_birth_changes_nothing(hand):  # law 22, R-X10
    hand.task("broken", BROKEN)
    hand.change(spawn=["counter"], on=["counter"])
    hand.let_pass(1.0)
    cause = hand.change(spawn=["broken"], on=["broken"], off=("counter",))
    assert "no sensor" in cause
    assert hand.states == {"counter": "ON"}
    hand.let_pass(1.0)
    assert hand.asker.values("COUNT")["COUNT"] == 101.0


def test_who_fails_to_come_on_gives_way_to_who_was_there(hand):  # R-X10
    hand.task("sulky", SULKY)
    hand.change(spawn=["source"], on=["source"])
    cause = hand.change(spawn=["sulky"], on=["sulky"], kill=("source",))
    assert "not today" in cause
    assert hand.states == {"source": "ON"}
    before = hand.asker.values("LEVEL")["LEVEL"]
    hand.let_pass(0.1)
    assert hand.asker.values("LEVEL")["LEVEL"] > before


def test_consumers_of_an_exchanged_constant_learn_it_and_come_on_again(hand):  # R-A13
    hand.task("other", SOURCE, module="other", local={"SIZE": "2"})
    hand.change(spawn=["source", "user", "counter"], on=["source", "user", "counter"])
    hand.let_pass(1.0)
    hand.asker.gate.told.clear()
    assert hand.change(spawn=["other"], kill=("source",), on=["other"]) == ""
    assert hand.states == {"user": "ON", "other": "ON", "counter": "ON"}
    turned = {(one.task, one.state) for one in hand.asker.of(event.TaskState)}
    assert ("user", "OFF") in turned
    assert not any(task == "counter" for task, _ in turned)


def test_a_change_of_dimension_is_one_transaction(hand):  # law 12, R-A03
    hand.change(spawn=["source", "user", "reader", "counter"], on=["source", "user", "reader", "counter"])
    hand.let_pass(1.0)
    assert len(hand.asker.values("ROW")["ROW"]) == 2
    hand.asker.gate.told.clear()
    assert hand.asker.outcome(hand.asker.ask(live.Reinit("s0", "source", (("SIZE", ("3",)),)))) == ""
    hand.let_pass(1.0)
    values = hand.asker.values("ROW", "SUM", "LEVEL")
    assert len(values["ROW"]) == 3
    assert values["SUM"] == 3 * values["ROW"][0]
    assert hand.states == dict.fromkeys(("source", "user", "reader", "counter"), "ON")
    assert not any(one.task == "counter" for one in hand.asker.of(event.TaskState))


def test_a_dimension_that_a_consumer_refuses_leaves_it_in_error_and_says_so(hand):  # law 12
    hand.change(spawn=["source", "user"], on=["source", "user"])
    cause = hand.asker.outcome(hand.asker.ask(live.Reinit("s0", "source", (("SIZE", ("9",)),))))
    assert "9 is too many" in cause
    assert hand.states["user"] == "ERROR"


def test_an_exchange_for_another_dimension_binds_all_who_share_it_anew(hand):  # law 12, R-A13
    hand.task("other", SOURCE, module="other", local={"SIZE": "3"})
    hand.change(spawn=["source", "user", "reader"], on=["source", "user", "reader"])
    assert hand.change(spawn=["other"], kill=("source",), on=["other"]) == ""
    hand.let_pass(1.0)
    assert len(hand.asker.values("ROW")["ROW"]) == 3
    assert hand.asker.values("SUM")["SUM"] == 3 * hand.asker.values("ROW")["ROW"][0] > 0.0


def test_the_kept_miss_no_cycle(hand):  # R-A13
    hand.task("other", SOURCE, module="other", local={"SIZE": "3"})
    hand.change(spawn=["source", "user", "counter"], on=["source", "user", "counter"])
    hand.let_pass(1.0)
    assert hand.cycles("counter") == 51
    hand.change(spawn=["other"], kill=("source",), on=["other"])
    hand.let_pass(1.0)
    assert hand.cycles("counter") == 50


def test_new_code_takes_the_place_of_the_old_between_two_cycles(hand):  # R-A14, R-X15
    hand.change(spawn=["counter"], on=["counter"])
    hand.let_pass(1.0)
    hand.task("counter", COUNTER.replace("+ 1.0", "+ 10.0"), frequency=50.0)
    answer = hand.asker.ask(live.Swap("s0", "counter", hand.shop.code("counter")))
    assert hand.asker.outcome(answer) == ""
    hand.let_pass(1.0)
    assert hand.asker.values("COUNT")["COUNT"] == 51.0 + 500.0


def test_code_that_fails_leaves_the_old_one_running(hand):  # law 21
    hand.change(spawn=["counter"], on=["counter"])
    hand.task("counter", COUNTER + "\n    def init(self):\n        raise RuntimeError('no')\n", frequency=50.0)
    assert "no" in hand.asker.outcome(hand.asker.ask(live.Swap("s0", "counter", hand.shop.code("counter"))))
    hand.let_pass(1.0)
    assert hand.asker.values("COUNT")["COUNT"] == 51.0


def test_a_rate_changes_while_the_task_runs(hand):  # R-A04
    hand.change(spawn=["counter"], on=["counter"])
    hand.cycles("counter")
    assert hand.change(rates=(("counter", 10.0),)) == ""
    hand.let_pass(1.0)
    assert hand.cycles("counter") in (10, 11)


def test_hardware_is_driven_by_hand_and_asks_for_what_it_lacks(hand):  # R-A10, law 16
    hand.shop = rail()
    assert hand.change(spawn=["mass", "servo"], on=["mass", "servo"]) == ""
    assert hand.states == {"mass": "ON", "servo": "ASKING"}
    asked = hand.asker.of(event.Asked)[-1]
    assert [item.name for item in asked.items] == ["goal"]
    hand.asker.ask(Reply("s0", "servo", "1.0"))
    hand.let_pass(5.0)
    assert hand.states == {"mass": "ON", "servo": "OFF"}
    assert hand.asker.values("X")["X"][0] == pytest.approx(1.0, abs=0.05)
    assert [one.kind for one in hand.asker.of(event.Signalled)] == ["FINISH"]


def test_units_share_the_work_and_constants_cross_them():  # R-A06
    hand = Hand(("rt0", "rt1"))
    hand.task("source", SOURCE, rtpu="rt1")
    hand.task("user", USER, rtpu="rt0")
    assert hand.change(spawn=["user", "source"], on=["source", "user"]) == ""
    hand.let_pass(1.0)
    assert hand.asker.values("ROW")["ROW"] == [101.0, 101.0]
