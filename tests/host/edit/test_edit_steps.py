import pytest

from kit.runtime.live_edits import COUNTER, USER, live_edits_with_tasks
from kit.worlds.rail_world import SERVO, rail_tasks
from onika.wire import event, live
from onika.wire.request import Reply


@pytest.fixture
def hand():
    return live_edits_with_tasks()


def test_a_task_turned_off_and_on_by_one_change_begins_anew(hand):  # R-A05
    hand.change(spawn=["counter"], on=["counter"])
    hand.let_pass(0.1)
    hand.asker.server.events.clear()
    assert hand.change(off=["counter"], on=["counter"]) == ""
    assert [message.state for message in hand.asker.of(event.TaskState)] == ["OFF", "ON"]


def test_a_task_that_is_on_already_is_not_turned_on(hand):  # R-A05
    hand.change(spawn=["counter", "source"], on=["counter"])
    assert hand.change(on=["source", "counter"]) == "counter: on: it is ON already"
    assert hand.states == {"counter": "ON", "source": "OFF"}


def test_two_writers_do_not_come_on_together(hand):  # law 9
    hand.task("second", COUNTER, module="second")
    cause = hand.change(spawn=["counter", "second"], on=["counter", "second"])
    assert cause == "second: on: COUNT is written by task counter, which comes on too"
    assert hand.states == {}


@pytest.mark.parametrize("line", ["", "5.0"])
def test_a_second_writer_is_refused_beside_one_that_is_on_or_asks(hand, line):  # law 9
    hand.shop = rail_tasks()
    hand.task("second", SERVO, module="second")
    hand.change(spawn=["mass", "servo", "second"], on=["mass", live.Turn("servo", line)])
    cause = hand.change(on=[live.Turn("second", "1.0")])
    assert cause.startswith("second: on: FORCE is written by task servo, which is ")
    assert hand.change(off=["servo"], on=[live.Turn("second", "1.0")]) == ""
    assert hand.states == {"mass": "ON", "servo": "OFF", "second": "ON"}


def test_an_asking_task_is_killed(hand):  # R-A10, R-A05
    hand.shop = rail_tasks()
    hand.change(spawn=["mass", "servo"], on=["mass", "servo"])
    assert hand.change(kill=["servo"]) == ""
    assert hand.states == {"mass": "ON"}
    assert "no task servo" in hand.outcome(hand.asker.ask(Reply("s0", "servo", "1.0")))


QUICK = """
from onika.module import Module, OutVar, finish

class Quick(Module):
    trigger = True
    DONE = OutVar("double", "-", "how often")

    def cycle(self):
        self.DONE = self.DONE + 1.0
        return finish()
"""


def test_who_has_done_its_job_is_not_wanted_on_any_more(hand):  # R-A07, R-A08
    hand.task("quick", QUICK)
    assert hand.change(spawn=["quick", "counter"], on=["quick", "counter"]) == ""
    assert hand.standing()["quick"].is_wanted_on
    hand.let_pass(0.1)
    assert hand.states == {"quick": "OFF", "counter": "ON"}
    assert not hand.standing()["quick"].is_wanted_on


def test_a_change_is_told_once_though_a_task_fails_meanwhile(hand):  # R-X10
    hand.task("bad", COUNTER.replace("self.COUNT + 1.0", "1.0 / 0.0"))
    hand.change(spawn=["bad"], on=["bad"])
    first = hand.asker.send(hand.order(("source",), ("source",)))
    hand.let_pass(0.1)
    assert hand.states == {"bad": "ERROR", "source": "ON"}
    assert hand.edited(hand.asker.server.replies[first].number) == [""]
    assert hand.change(kill=["bad"]) == ""


def test_a_task_in_error_is_cleared_before_it_is_initialised_anew(hand):  # law 11
    hand.task("bad", COUNTER.replace("self.COUNT + 1.0", "1.0 / 0.0"))
    hand.change(spawn=["bad"], on=["bad"])
    hand.let_pass(0.1)
    assert hand.reinit("bad") == "bad: it is in ERROR, clear it first"
    assert hand.clear("bad") == ""
    assert hand.reinit("bad") == ""


def test_who_was_in_error_when_constants_changed_learns_them_when_it_is_cleared(hand):  # R-A13
    hand.task("keen", KEEN)
    hand.change(spawn=["source", "keen"], on=["source", "keen"])
    hand.let_pass(0.1)
    assert hand.states["keen"] == "ERROR"
    assert hand.reinit("source", SIZE="3") == ""
    assert hand.clear("keen") == ""
    assert hand.change(on=["keen"]) == ""
    assert hand.values("SEEN")["SEEN"] == 3.0


KEEN = """
from onika.module import InConst, Module, OutVar

class Keen(Module):
    N = InConst("int", "-", "how many")
    SEEN = OutVar("double", "-", "what it was initialised with")

    def init(self):
        self._seen = float(self.N)

    def on(self, inputs):
        self.SEEN = self._seen

    def cycle(self):
        raise ZeroDivisionError("gone wrong")
"""


def test_a_task_that_waits_is_born_with_its_newest_code(hand):  # R-A14, law 10
    hand.change(spawn=["user"])
    hand.task("user", USER.replace("self.LEVEL]", "2.0 * self.LEVEL]"))
    assert hand.swap("user") == ""
    assert hand.change(spawn=["source"], on=["source", "user"]) == ""
    hand.let_pass(0.1)
    values = hand.values("LEVEL", "ROW")
    assert values["ROW"] == [2.0 * values["LEVEL"]] * 2


def test_a_subsystem_that_is_closed_is_no_more(hand):  # R-A06
    hand.change(spawn=["source"], on=["source"])
    assert hand.outcome(hand.asker.ask(live.Close("s0"))) == ""
    assert hand.asker.ask(live.Survey()).subsystems == ()
    assert hand.asker.server.events[-1] == event.Held("s0", "")
    assert hand.change(spawn=["source"], on=["source"], session="you") == ""
