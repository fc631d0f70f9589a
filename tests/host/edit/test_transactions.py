import pytest

from kit.runtime.live_edits import BROKEN, COUNTER, SOURCE, SULKY, USER, LiveEdits, live_edits_with_tasks
from kit.worlds.rail_world import MASS, rail_tasks
from onika.wire import event, live
from onika.wire.request import Reply


@pytest.fixture
def hand():
    return live_edits_with_tasks()


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
    assert (standing.state, str(standing.reason)) == ("WAITING", "waits for N")
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


def test_who_lived_and_does_not_come_on_is_in_error_until_it_is_cleared(hand):  # law 21, law 22
    hand.task("sulky", SULKY.replace("LEVEL", "ELSE"))
    hand.change(spawn=["sulky"])
    assert "not today" in hand.change(spawn=["source"], on=["source", "sulky"])
    assert hand.states == {"sulky": "ERROR"}
    assert str(hand.standing()["sulky"].reason) == "on: ModuleError: not today"
    assert hand.clear("sulky") == ""
    assert hand.states == {"sulky": "OFF"}


def test_consumers_of_an_exchanged_constant_learn_it_and_come_on_again(hand):  # R-A13
    hand.task("other", SOURCE, module="other", local={"SIZE": "2"})
    hand.change(spawn=["source", "user", "counter"], on=["source", "user", "counter"])
    hand.let_pass(1.0)
    hand.asker.server.events.clear()
    assert hand.change(spawn=["other"], kill=("source",), on=["other"]) == ""
    assert hand.states == {"user": "ON", "other": "ON", "counter": "ON"}
    turned = {(message.task, message.state) for message in hand.asker.of(event.TaskState)}
    assert ("user", "OFF") in turned
    assert not any(task == "counter" for task, _ in turned)


def test_a_change_of_dimension_is_one_transaction(hand):  # law 12, R-A03
    hand.change(spawn=["source", "user", "reader", "counter"], on=["source", "user", "reader", "counter"])
    hand.let_pass(1.0)
    assert len(hand.asker.values("ROW")["ROW"]) == 2
    hand.asker.server.events.clear()
    assert hand.asker.outcome(hand.asker.ask(live.Reinit("s0", "source", (("SIZE", ("3",)),)))) == ""
    hand.let_pass(1.0)
    values = hand.asker.values("ROW", "SUM", "LEVEL")
    assert len(values["ROW"]) == 3
    assert values["SUM"] == 3 * values["ROW"][0]
    assert hand.states == dict.fromkeys(("source", "user", "reader", "counter"), "ON")
    assert not any(message.task == "counter" for message in hand.asker.of(event.TaskState))


def test_a_dimension_that_a_consumer_refuses_is_taken_back_whole(hand):  # law 12, R-X10
    hand.change(spawn=["source", "user", "reader"], on=["source", "user", "reader"])
    cause = hand.reinit("source", SIZE="9")
    assert "9 is too many" in cause
    assert hand.states == dict.fromkeys(("source", "user", "reader"), "ON")
    assert dict(hand.standing()["source"].task.local) == {}
    hand.let_pass(1.0)
    assert len(hand.values("ROW")["ROW"]) == 2
    assert hand.values("SUM")["SUM"] == 2 * hand.values("ROW")["ROW"][0] > 0.0


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
    hand.shop = rail_tasks()
    assert hand.change(spawn=["mass", "servo"], on=["mass", "servo"]) == ""
    assert hand.states == {"mass": "ON", "servo": "ASKING"}
    question = hand.asker.of(event.Asked)[-1]
    assert [item.name for item in question.items] == ["goal"]
    hand.asker.ask(Reply("s0", "servo", "1.0"))
    hand.let_pass(5.0)
    assert hand.states == {"mass": "ON", "servo": "OFF"}
    assert hand.asker.values("X")["X"][0] == pytest.approx(1.0, abs=0.05)
    assert [message.kind for message in hand.asker.of(event.Signalled)] == ["FINISH"]


def test_units_share_the_work_and_constants_cross_them():  # R-A06
    hand = LiveEdits(("rt0", "rt1"))
    hand.task("source", SOURCE, rtpu="rt1")
    hand.task("user", USER, rtpu="rt0")
    assert hand.change(spawn=["user", "source"], on=["source", "user"]) == ""
    hand.let_pass(1.0)
    assert hand.asker.values("ROW")["ROW"] == [101.0, 101.0]


@pytest.mark.parametrize("fault", ["init", "on"])
def test_old_hardware_comes_back_with_its_device(hand, fault):  # R-X10, reading 14
    hand.shop = rail_tasks()
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")])
    hand.let_pass(0.2)
    wrong = {
        "init": MASS.replace("self.SIDES = 2", "raise ModuleError('no sensor')"),
        "on": MASS.replace("self.X = self.device.read()", "raise ModuleError('no sensor')", 1),
    }[fault]
    hand.task("mass", wrong, frequency=500.0, local={"DEVICE": "yard:m0"})
    assert "no sensor" in hand.change(spawn=["mass"], on=["mass"], kill=["mass"])
    assert hand.states == {"mass": "ON", "servo": "ON"}
    hand.let_pass(6.0)
    assert hand.states == {"mass": "ON", "servo": "OFF"}
    assert hand.values("X")["X"][0] == pytest.approx(5.0, abs=0.5)


def test_hardware_is_exchanged_for_other_hardware_on_its_device(hand):  # R-A13, reading 14
    hand.shop = rail_tasks()
    hand.task("other", MASS, frequency=500.0, local={"DEVICE": "yard:m0"}, module="other")
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")])
    assert hand.change(spawn=["other"], on=["other"], kill=["mass"]) == ""
    hand.let_pass(6.0)
    assert hand.values("X")["X"][0] == pytest.approx(5.0, abs=0.5)
    assert hand.change(kill=["other"]) == ""
    assert hand.change(spawn=["mass"], on=["mass"]) == ""


def test_a_task_is_exchanged_for_one_of_its_name(hand):  # R-A13
    hand.shop = rail_tasks()
    hand.change(spawn=["mass"], on=["mass"])
    hand.task("mass", MASS, frequency=250.0, local={"DEVICE": "yard:m1"})
    assert hand.change(spawn=["mass"], on=["mass"], kill=["mass"]) == ""
    assert dict(hand.standing()["mass"].task.local) == {"DEVICE": ("yard:m1",)}
    assert hand.change(spawn=["servo"]) == ""


def test_a_consumer_that_refuses_an_exchanged_constant_goes_on_with_the_old_one(hand):  # R-X10
    hand.task("other", SOURCE, module="other", local={"SIZE": "9"})
    hand.change(spawn=["source", "user", "reader"], on=["source", "user", "reader"])
    assert "9 is too many" in hand.change(spawn=["other"], on=["other"], kill=["source"])
    assert hand.states == dict.fromkeys(("source", "user", "reader"), "ON")
    hand.let_pass(1.0)
    assert hand.values("N", "ROW")["N"] == 2
    assert hand.values("SUM")["SUM"] == 2 * hand.values("ROW")["ROW"][0] > 100.0


def test_constants_of_a_newcomer_that_goes_again_are_as_if_it_had_never_been(hand):  # R-X10
    hand.task("other", SOURCE, module="other", local={"SIZE": "3"})
    hand.task("broken", BROKEN.replace("LEVEL", "ELSE"))
    hand.change(spawn=["source", "user", "counter"], on=["source", "user", "counter"])
    hand.let_pass(1.0)
    hand.figures()
    before = hand.values("N", "ROW")
    hand.asker.server.events.clear()
    assert "no sensor" in hand.change(spawn=["other", "broken"], on=["other"], kill=["source"])
    assert hand.values("N", "ROW") == before
    assert {message.task for message in hand.asker.of(event.TaskState)} <= {"other", "broken"}
    assert hand.asker.ask(live.Check("s0")) == live.Findings(())
    hand.let_pass(1.0)
    assert {name: figure.cycle for name, figure in hand.figures().items()} == {
        "source": 100,
        "user": 100,
        "counter": 50,
    }
    assert hand.change(off=["user"]) == hand.change(on=["user"]) == ""


def test_rates_go_back_with_the_rest(hand):  # R-X10, R-A04
    hand.task("sulky", SULKY)
    hand.change(spawn=["counter"], on=["counter"], rates=(("counter", 25.0),))
    assert "not today" in hand.change(spawn=["sulky"], on=["sulky"], rates=(("counter", 10.0),))
    assert hand.standing()["counter"].frequency == 25.0
    hand.cycles("counter")
    hand.let_pass(2.0)
    assert hand.cycles("counter") in (50, 51)


def test_who_waited_waits_again_when_the_supplier_goes_with_a_failed_change(hand):  # R-X10, law 10
    hand.task("broken", BROKEN.replace("LEVEL", "ELSE"))
    hand.change(spawn=["user"])
    assert "no sensor" in hand.change(spawn=["source", "broken"])
    assert hand.states == {"user": "WAITING"}
    assert str(hand.standing()["user"].reason) == "waits for N"
    assert hand.change(spawn=["source"], on=["source", "user"]) == ""


@pytest.mark.parametrize("name", ["user", "another"])
def test_who_waited_and_was_killed_first_waits_again_when_the_change_fails(hand, name):  # law 22
    hand.task("broken", BROKEN.replace("LEVEL", "ELSE"))
    hand.change(spawn=["user"])
    hand.task(name, USER, module="user")
    assert "no sensor" in hand.change(spawn=["source", "broken", name], kill=["user"], on=["source", name])
    hand.let_pass(0.1)
    assert hand.states == {"user": "WAITING"}
    assert hand.change(spawn=["source"], on=["source", "user"]) == ""


def test_a_failed_change_keeps_order_lines_and_wishes(hand):  # R-X10
    hand.shop = rail_tasks()
    hand.task("broken", BROKEN)
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")])
    before = hand.standing()
    assert "no sensor" in hand.change(spawn=["broken", "mass"], kill=["mass"], on=["mass"])
    assert hand.standing() == before
    assert list(hand.standing()) == list(before)


def test_a_line_that_was_answered_is_not_asked_for_again(hand):  # R-A10
    hand.shop = rail_tasks()
    hand.task("sulky", SULKY)
    hand.change(spawn=["mass", "servo"], on=["mass", "servo"])
    hand.asker.ask(Reply("s0", "servo", "5.0"))
    assert hand.reinit("mass") == ""
    assert hand.states == {"mass": "ON", "servo": "ON"}


def test_newcomers_learn_what_kept_tasks_say_after_they_have_learnt(hand):  # R-A13
    hand.task("other", SOURCE, module="other", local={"SIZE": "3"})
    hand.task("middle", MIDDLE)
    hand.task("last", LAST)
    hand.change(spawn=["source", "middle", "last"], on=["source", "middle", "last"])
    hand.let_pass(0.1)
    assert hand.values("SEEN") == {"SEEN": 4.0}
    hand.task("last", "# new\n" + LAST)
    assert hand.change(spawn=["other", "last"], kill=["source", "last"], on=["other"]) == ""
    assert hand.states == {"middle": "ON", "other": "ON", "last": "OFF"}
    assert hand.change(on=["last"]) == ""
    hand.let_pass(0.1)
    assert hand.values("SEEN") == {"SEEN": 6.0}


MIDDLE = """
from onika.module import InConst, Module, OutConst

class Middle(Module):
    N = InConst("int", "-", "how many")
    M = OutConst("int", "-", "twice as many")

    def init(self):
        self.M = 2 * self.N
"""
LAST = """
from onika.module import InConst, Module, OutVar

class Last(Module):
    M = InConst("int", "-", "twice as many")
    SEEN = OutVar("double", "-", "what it was initialised with")

    def init(self):
        self._seen = float(self.M)

    def cycle(self):
        self.SEEN = self._seen
"""
