"""Variables that nobody writes are written by hand, and only those."""

import numpy as np
import pytest

from kit.runtime.live_edits import COUNTER, LiveEdits
from kit.worlds.rail_world import rail_tasks
from onika.wire import live, request
from onika.words.reason import Reason

FOLLOWER = """
from onika.module import InConst, InVar, Module, OutConst, OutVar

class Follower(Module):
    N = OutConst("int", "-", "how many")
    LEVEL = InVar("double", "m", "a level")
    HITS = InVar("int", "-", "a count")
    ROW = InVar("double[3]", "m", "three levels")
    NAME = InVar("string", "-", "a name")
    SUM = OutVar("double", "m", "all of it")

    def init(self):
        self.N = 3

    def cycle(self):
        self.SUM = self.LEVEL + self.HITS + float(sum(self.ROW))
"""
USER = """
from onika.module import InConst, InVar, Module, OutVar

class User(Module):
    M = InConst("int", "-", "how many")
    OUT = OutVar("double", "m", "nothing")

    def cycle(self):
        pass
"""

RULER = """
from onika.module import InVar, Module, OutVar

class Ruler(Module):
    MARKS = InVar("double[N]", "m", "as many levels as somebody says")
    LENGTH = OutVar("double", "m", "nothing")

    def cycle(self):
        pass
"""

SHORT = """
from onika.module import InVar, Module, OutVar

class Short(Module):
    FINE = InVar("float", "m", "a level in four bytes")
    TWICE = OutVar("double", "m", "nothing")

    def cycle(self):
        pass
"""


@pytest.fixture
def hand():
    edits = LiveEdits()
    edits.task("follower", FOLLOWER)
    edits.task("counter", COUNTER)
    assert edits.change(spawn=["follower", "counter"], on=["follower", "counter"]) == ""
    return edits


def write(edits, name, *values, session="me"):
    return edits.asker.ask(live.Write("s0", name, tuple(map(float, values))), session)


def read(edits, *names):
    return edits.asker.ask(live.Read("s0", names)).values


def test_what_nobody_writes_is_written_and_read_by_tasks_in_their_next_cycle(hand):  # R-C27
    assert write(hand, "LEVEL", 0.5) == request.Done()
    assert write(hand, "HITS", 2) == request.Done()
    assert write(hand, "ROW", 1.0, 2.0, 3.5) == request.Done()
    assert read(hand, "LEVEL", "HITS", "ROW") == {"LEVEL": 0.5, "HITS": 2, "ROW": [1.0, 2.0, 3.5]}
    hand.let_pass(0.2)
    assert read(hand, "SUM") == {"SUM": 9.0}


def test_the_memory_of_what_is_written_by_hand_stays_sound(hand):  # R-A12
    for value in range(20):
        write(hand, "LEVEL", value)
        write(hand, "ROW", value, value, value)
        hand.let_pass(0.05)
        assert hand.asker.ask(live.Check("s0")) == live.Findings(())


@pytest.mark.parametrize(
    ("name", "values", "key"),
    [
        ("SUM", (1.0,), "host.hand_written"),
        ("N", (1.0,), "host.hand_written"),
        ("NAME", (1.0,), "host.hand_text"),
        ("NOBODY", (1.0,), "host.not_read"),
        ("LEVEL", (), "host.hand_value"),
        ("LEVEL", (1.0, 2.0), "host.hand_value"),
        ("ROW", (1.0,), "host.hand_value"),
        ("LEVEL", (float("nan"),), "host.hand_value"),
        ("ROW", (1.0, 2.0, float("inf")), "host.hand_value"),
        ("HITS", (1.5,), "host.hand_value"),
        ("HITS", (1e12,), "host.hand_value"),
    ],
)
def test_what_cannot_be_written_so_is_refused_and_nothing_is_changed(hand, name, values, key):  # R-B07
    before = read(hand, "LEVEL", "HITS", "ROW")
    answer = write(hand, name, *values)
    assert isinstance(answer, request.Refused)
    assert answer.reason.key == key
    assert read(hand, "LEVEL", "HITS", "ROW") == before


@pytest.mark.parametrize(
    ("name", "values", "shape", "why"),
    [
        ("LEVEL", (), "double", Reason.of("host.hand_count", expected=1, given=0)),
        ("LEVEL", (1.0, 2.0), "double", Reason.of("host.hand_count", expected=1, given=2)),
        ("ROW", (1.0,), "double[3]", Reason.of("host.hand_count", expected=3, given=1)),
        ("LEVEL", (float("nan"),), "double", Reason.of("host.hand_infinite")),
        ("ROW", (1.0, 2.0, float("-inf")), "double[3]", Reason.of("host.hand_infinite")),
        ("HITS", (float("inf"),), "int", Reason.of("host.hand_infinite")),
        ("HITS", (1.5,), "int", Reason.of("host.hand_kind", kind="int", value=1.5)),
        ("HITS", (1e12,), "int", Reason.of("host.hand_kind", kind="int", value=1e12)),
    ],
)
def test_what_is_wrong_with_values_is_told_beside_what_the_variable_is(hand, name, values, shape, why):  # R-B07
    assert write(hand, name, *values) == request.Refused(Reason.of("host.hand_value", name=name, shape=shape, why=why))


def test_a_variable_whose_writer_is_gone_is_written_and_its_memory_is_sound(hand):  # R-A12, R-C27
    hand.task("feeder", COUNTER.replace("COUNT", "LEVEL").replace('"-"', '"m"'))
    assert hand.change(spawn=["feeder"], on=["feeder"]) == ""
    hand.let_pass(0.2)
    assert hand.change(kill=("feeder",)) == ""
    assert write(hand, "LEVEL", 0.5) == request.Done()
    assert read(hand, "LEVEL") == {"LEVEL": 0.5}
    assert hand.asker.ask(live.Check("s0")) == live.Findings(())


def test_a_variable_is_no_longer_free_when_a_task_comes_that_writes_it(hand):  # R-C27
    hand.shop.task("feeder", COUNTER.replace("COUNT", "LEVEL").replace('"-"', '"m"'))
    assert write(hand, "LEVEL", 1.0) == request.Done()
    assert hand.change(spawn=["feeder"]) == ""
    assert write(hand, "LEVEL", 2.0).reason.key == "host.hand_written"  # also while it is OFF
    assert hand.change(on=["feeder"]) == ""
    hand.let_pass(0.2)
    assert hand.asker.ask(live.Check("s0")) == live.Findings(())


def test_what_moves_a_device_without_a_task_between_is_not_written_by_hand():  # law 33
    edits = LiveEdits()
    edits.shop = rail_tasks()
    assert edits.change(spawn=["mass"], on=["mass"]) == ""
    assert write(edits, "FORCE", 50.0).reason.key == "host.hand_device"


def test_what_moves_no_device_is_written_beside_one():  # law 33
    edits = LiveEdits()
    edits.shop = rail_tasks()
    edits.task("follower", FOLLOWER)
    assert edits.change(spawn=["mass", "follower"], on=["mass", "follower"]) == ""
    assert write(edits, "LEVEL", 1.0) == request.Done()
    assert write(edits, "FORCE", 50.0) == request.Refused(Reason.of("host.hand_device", name="FORCE", tasks=("mass",)))


def test_only_the_holder_writes_and_only_what_is_held_by_hand(hand):  # law 27
    assert write(hand, "LEVEL", 1.0, session="other").reason.key == "host.held_stop"
    assert hand.asker.ask(live.Write("s9", "LEVEL", (1.0,))).reason.key == "host.not_by_hand"


def test_a_constant_that_waits_for_its_supplier_is_not_written_by_hand():  # law 12
    edits = LiveEdits()
    edits.task("user", USER)
    edits.change(spawn=["user"])
    answer = write(edits, "M", 3)
    assert answer.reason.key in ("host.hand_constant", "host.not_read")


def test_nothing_is_written_in_the_midst_of_a_change(hand):  # R-C27, R-X10
    hand.asker.send(hand.order(off=("counter",)))
    ticket = hand.asker.send(live.Write("s0", "LEVEL", (0.5,)))
    assert hand.asker.server.replies[ticket].reason.key == "host.hand_changing"
    hand.work()
    assert write(hand, "LEVEL", 0.5) == request.Done()


def test_a_constant_whose_supplier_is_gone_is_not_written_by_hand(hand):  # R-C27, law 10
    hand.task("reader", USER.replace("M = InConst", "N = InConst"))
    assert hand.change(spawn=["reader"]) == ""
    assert hand.change(kill=("follower",)) == ""
    refused = write(hand, "N", 4)
    assert (type(refused), refused.reason.key) == (request.Refused, "host.hand_constant")


def test_what_the_shapes_of_tasks_depend_on_is_not_written_by_hand(hand):  # R-C27, law 12
    hand.task("ruler", RULER)
    assert hand.change(spawn=["ruler"]) == ""
    assert hand.change(kill=("follower",)) == ""
    assert write(hand, "N", 4) == request.Refused(Reason.of("host.hand_constant", name="N"))


def test_what_a_short_real_number_cannot_hold_is_refused_and_does_not_become_infinite(hand):  # R-B07
    largest = float(np.finfo(np.float32).max)
    hand.task("short", SHORT)
    assert hand.change(spawn=["short"], on=["short"]) == ""
    for bound in (largest, -largest):
        assert write(hand, "FINE", bound) == request.Done()
        kind = Reason.of("host.hand_kind", kind="float", value=10 * bound)
        why = Reason.of("host.hand_value", name="FINE", shape="float", why=kind)
        assert write(hand, "FINE", 10 * bound) == request.Refused(why)
        assert read(hand, "FINE") == {"FINE": bound}
    assert write(hand, "LEVEL", 10 * largest) == request.Done()
