import pytest

from kit.runtime.live_edits import READER, SOURCE, USER, live_edits_with_tasks
from kit.worlds.rail_world import MASS, rail_tasks
from onika.wire import event, live


@pytest.fixture
def hand():
    return live_edits_with_tasks()


def test_a_supplier_that_comes_after_the_old_one_has_gone_shapes_who_lived_on(hand):  # law 12, R-A13
    hand.task("other", SOURCE, module="other", local={"SIZE": "3"})
    hand.change(spawn=["source", "user", "reader"], on=["source", "user", "reader"])
    hand.change(kill=["source"])
    assert hand.change(spawn=["other"], on=["other"]) == ""
    hand.let_pass(1.0)
    assert len(hand.values("ROW")["ROW"]) == hand.values("N")["N"] == 3
    assert hand.values("SUM")["SUM"] == 3 * hand.values("ROW")["ROW"][0] > 0.0


def test_a_task_shaped_by_a_constant_that_it_does_not_read_waits_for_it_too(hand):  # law 10
    hand.task("free", READER.replace('    N = InConst("int", "-", "how many")\n', ""))
    assert hand.change(spawn=["free"]) == ""
    assert str(hand.standing()["free"].reason) == "waits for N"
    assert hand.change(spawn=["source"], on=["free"]) == ""
    hand.change(kill=["source"])
    assert hand.reinit("free") == ""
    assert hand.states == {"free": "ON"}


@pytest.mark.parametrize(("size", "reason"), [("100000000", "no room"), ("-1", "at least 1"), ("0", "at least 1")])
def test_a_dimension_that_cannot_be_changes_nothing(hand, size, reason):  # law 12
    hand.task("user", USER.replace("> 4", "> 10**12"))
    hand.change(spawn=["source", "user", "reader"], on=["source", "user", "reader"])
    assert reason in hand.reinit("source", SIZE=size)
    hand.let_pass(0.1)
    assert hand.states == dict.fromkeys(("source", "user", "reader"), "ON")
    assert hand.values("SUM")["SUM"] == 2 * hand.values("ROW")["ROW"][0] > 0.0


MIDDLE = """
from onika.module import InConst, Module, OutConst

class Middle(Module):
    N = InConst("int", "-", "how many")
    M = OutConst("int", "-", "twice as many")

    def init(self):
        self.M = 2 * self.N
"""
WIDE = """
from onika.module import InConst, Module, OutVar

class Wide(Module):
    M = InConst("int", "-", "twice as many")
    WIDE = OutVar("double[M]", "m", "wide")

    def cycle(self):
        self.WIDE = [1.0] * self.M
"""
LAST = """
from onika.module import InConst, InVar, Module, ModuleError, OutVar

class Last(Module):
    M = InConst("int", "-", "twice as many")
    WIDE = InVar("double[M]", "m", "wide")
    ALL = OutVar("double", "m", "all of it")

    def init(self):
        if self.M > 6:
            raise ModuleError(f"{self.M} is too wide")

    def cycle(self):
        self.ALL = float(sum(self.WIDE))
"""


@pytest.fixture
def levels():
    hand = live_edits_with_tasks(("rt0", "rt1", "rt2"), source="rt2", counter="rt1")
    hand.task("middle", MIDDLE, rtpu="rt0")
    hand.task("last", LAST, rtpu="rt1")
    hand.task("wide", WIDE, rtpu="rt2")
    everyone = ["last", "middle", "source", "counter", "wide"]
    assert hand.change(spawn=everyone, on=everyone) == ""
    return hand


def test_constants_pass_on_over_three_levels_and_units(levels):  # R-A13, law 10, law 12
    levels.let_pass(1.0)
    levels.figures()
    levels.asker.server.events.clear()
    assert levels.reinit("source", SIZE="3") == ""
    levels.let_pass(1.0)
    assert levels.values("ALL")["ALL"] == 6.0
    assert levels.cycles("counter") == 50
    assert not any(message.task == "counter" for message in levels.asker.of(event.TaskState))


def test_a_refusal_at_the_third_level_is_taken_back_at_all_three(levels):  # R-X10, law 12
    assert "8 is too wide" in levels.reinit("source", SIZE="4")
    levels.let_pass(1.0)
    assert levels.states == dict.fromkeys(("source", "middle", "last", "counter", "wide"), "ON")
    assert levels.values("N", "M", "ALL") == {"N": 2, "M": 4, "ALL": 4.0}


def test_memory_is_used_again_over_a_thousand_dimensions(hand):  # law 12
    hand.change(spawn=["source", "user", "reader"], on=["source", "user"])
    table = hand.asker.program.subsystems.tables["s0"]
    for size in ("3", "1", "2"):
        assert hand.reinit("source", SIZE=size) == ""
    end = table.end
    for number in range(1000):
        assert hand.reinit("source", SIZE=str(1 + number % 3)) == ""
    assert table.end == end
    assert hand.asker.ask(live.Check("s0")) == live.Findings(())


BOTH = """
from onika.module import InBoth, Module, OutBoth, OutVar

class Giver(Module):
    GAIN = OutBoth("double", "-", "a gain")

    def init(self):
        self.GAIN = 7.0

    def cycle(self):
        self.GAIN = self.GAIN + 1.0
"""
TAKER = """
from onika.module import InBoth, Module, OutVar

class Taker(Module):
    GAIN = InBoth("double", "-", "a gain")
    FIRST = OutVar("double", "-", "its first value")

    def init(self):
        self._first = self.GAIN

    def cycle(self):
        self.FIRST = self._first
"""


def test_an_inboth_learns_the_first_value_of_an_exchanged_outboth(hand):  # R-A13, R-A02
    hand.task("giver", BOTH)
    hand.task("second", BOTH.replace("7.0", "100.0"), module="second")
    hand.task("taker", TAKER)
    hand.change(spawn=["giver", "taker"], on=["giver", "taker"])
    hand.let_pass(0.1)
    assert hand.values("FIRST")["FIRST"] == 7.0
    assert hand.change(spawn=["second"], on=["second"], kill=["giver"]) == ""
    hand.let_pass(0.1)
    assert hand.states == {"taker": "ON", "second": "ON"}
    assert hand.values("FIRST")["FIRST"] == 100.0


def test_hardware_stays_off_after_a_change_of_shapes_until_somebody_turns_it_on(hand):  # law 12
    hand.shop = rail_tasks()
    source = MASS.replace('return {"SIDES": 2}', 'return {"SIDES": local.WIDTH}').replace("= 2", "= self.WIDTH")
    source = source.replace("self.X = self.device.read()", "self.X = [*self.device.read(), 0.0][: self.WIDTH]")
    source = source.replace(
        "    @classmethod", '    WIDTH = Local("int", "-", "how many", default=2)\n\n    @classmethod', 1
    )
    hand.task("mass", source.replace("import ", "import Local, "), frequency=500.0, local={"DEVICE": "yard:m0"})
    assert hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")]) == ""
    assert hand.reinit("mass", DEVICE="yard:m0", WIDTH="3") == ""
    assert hand.states == {"mass": "OFF", "servo": "ON"}
    assert [message.task for message in hand.asker.of(event.Warned)] == ["mass"]
    assert not hand.standing()["mass"].is_wanted_on
    assert hand.change(on=["mass"]) == ""
    hand.let_pass(6.0)
    assert hand.values("X")["X"] == pytest.approx([5.0, 0.0, 0.0], abs=0.5)
