"""What is asked of subsystems by hand gets one answer each, and what is accepted one outcome."""

import pytest

from kit.runtime.live_edits import COUNTER, LiveEdits, live_edits_with_tasks
from kit.worlds.rail_world import MASS, rail_tasks
from onika.wire import event, live, request
from onika.words.reason import Reason

GIVER = """
from onika.module import Module, ModuleError, OutVar

class Giver(Module):
    OUT = OutVar("double", "-", "what it was told")

    def init(self):
        self._value = 1.0

    def get(self, name):
        if name != "value":
            raise ModuleError(f"expected value, found {name}")
        return self._value

    def set(self, name, value):
        self._value = float(value)

    def cycle(self):
        self.OUT = self._value
"""


PUSH = """
from onika.module import Module, OutVar

class Push(Module):
    FORCE = OutVar("double", "N", "what pushes it")

    def on(self, inputs):
        self.FORCE = {force}

    def cycle(self):
        self.FORCE = {force}
"""


@pytest.fixture
def pushed():
    """A mass that a task pushes with 1 N, and which may step by 1 N in a cycle; others would push harder."""
    edits = LiveEdits()
    edits.shop = rail_tasks()
    limited = MASS.replace('"what pushes it")', '"what pushes it", step=1.0)')
    edits.task("mass", limited, frequency=500.0, local={"DEVICE": "yard:m0"})
    for name, force in (("push", 1.0), ("harder", 5.0), ("hardest", 500.0)):
        edits.task(name, PUSH.format(force=force), frequency=500.0)
    assert edits.change(spawn=["mass", "push"], on=["mass", "push"]) == ""
    edits.let_pass(0.2)
    edits.asker.server.events.clear()
    return edits


def test_a_change_after_which_a_device_would_step_too_far_is_taken_back_with_the_number(pushed):  # R-X04, R-X10
    cause = pushed.change(spawn=["hardest"], on=["hardest"], kill=("push",))
    assert cause == (
        "hardest: on: FORCE would step by 499 N: a cycle may change it by 1 N, 0.1 s by 50 N; "
        "begin near 1 N, or turn mass off first and on again after this task"
    )
    assert pushed.states == {"mass": "ON", "push": "ON"}
    pushed.let_pass(0.2)
    assert pushed.values("FORCE") == {"FORCE": 1.0}
    assert not any(message.is_too_far for message in pushed.asker.of(event.Stepped))


def test_an_exchange_of_code_after_which_a_device_would_step_too_far_leaves_the_old_code(pushed):  # R-X04, R-A14
    pushed.task("push", PUSH.format(force=500.0), frequency=500.0)
    assert pushed.swap("push").startswith("push: swap: FORCE would step by 499 N")
    pushed.let_pass(0.2)
    assert pushed.values("FORCE") == {"FORCE": 1.0}
    assert pushed.states == {"mass": "ON", "push": "ON"}


def test_a_change_after_which_a_device_steps_is_blended_and_told(pushed):  # R-X04
    assert pushed.change(spawn=["harder"], on=["harder"], kill=("push",)) == ""
    pushed.let_pass(0.2)
    (stepped,) = pushed.asker.of(event.Stepped)
    assert (stepped.task, stepped.variable, stepped.step, stepped.cycles) == ("mass", "FORCE", 4.0, 8)
    assert stepped.given <= stepped.limit == 1.0


@pytest.fixture
def hand():
    edits = live_edits_with_tasks(("rt0", "rt1"), counter="rt1")
    edits.task("giver", GIVER, rtpu="rt1")
    return edits


@pytest.mark.parametrize(
    "wish",
    [
        live.Clear("s0", "no"),
        live.Reinit("s0", "no"),
        live.Get("s0", "no", "value"),
        live.Set("s0", "no", "value", "1"),
        live.Close("no"),
        request.Reply("s0", "no", "1"),
    ],
    ids=lambda wish: type(wish).__name__,
)
def test_what_is_not_there_is_refused_by_name(hand, wish):  # R-A05
    hand.change(spawn=["counter"])
    answer = hand.asker.ask(wish)
    assert isinstance(answer, request.Refused)
    assert "no" in str(answer.reason).split()


def test_a_module_is_asked_and_told(hand):  # R-A05
    hand.change(spawn=["giver"], on=["giver"])
    assert hand.asker.ask(live.Get("s0", "giver", "value")) == live.Value(1.0)
    assert hand.asker.ask(live.Set("s0", "giver", "value", "2.5")) == live.Value("2.5")
    hand.let_pass(0.1)
    assert hand.values("OUT") == {"OUT": 2.5}
    assert "expected value, found other" in str(hand.asker.ask(live.Get("s0", "giver", "other")).reason)
    assert "could not convert" in str(hand.asker.ask(live.Set("s0", "giver", "value", "much")).reason)


def test_only_a_task_in_error_is_cleared(hand):  # law 11
    hand.change(spawn=["counter"])
    assert hand.clear("counter") == "counter is OFF, not ERROR"


def test_a_task_that_asks_for_nothing_is_not_answered(hand):  # R-A10
    hand.change(spawn=["counter"], on=["counter"])
    assert hand.outcome(hand.asker.ask(request.Reply("s0", "counter", "1"))) == "counter asks for nothing"


def test_an_answer_out_of_bounds_is_asked_for_again_with_the_reason():  # R-A10
    hand = LiveEdits()
    hand.shop = rail_tasks()
    hand.change(spawn=["mass", "servo"], on=["mass", "servo"])
    hand.asker.ask(request.Reply("s0", "servo", "99"))
    hand.work()
    assert hand.states["servo"] == "ASKING"
    assert "99" in str(hand.asker.of(event.Asked)[-1].reason)
    hand.asker.ask(request.Reply("s0", "servo", "1"))
    hand.work()
    assert hand.states["servo"] == "ON"


def test_every_accepted_order_has_a_number_of_its_own_and_one_outcome(hand):  # law 22
    hand.change(spawn=["source", "user", "counter"], on=["counter"])
    wishes = [
        live.Change("s0", on=(live.Turn("source"),)),
        live.Reinit("s0", "source"),
        live.Swap("s0", "counter", *hand.code("counter")),
        hand.order(("giver",), subsystem="s1"),
        live.Close("s1"),
        live.Change("s0", off=("counter",)),
    ]
    tickets = [hand.asker.send(wish) for wish in wishes]
    hand.work()
    numbers = [hand.asker.server.replies[ticket].number for ticket in tickets]
    assert len(set(numbers)) == len(wishes)
    assert [hand.edited(number) for number in numbers] == [[""]] * len(wishes)


def test_a_task_runs_on_the_unit_it_names_else_on_the_first_that_lives(hand):  # R-A06, reading 12
    hand.task("far", COUNTER.replace("COUNT", "FAR"), rtpu="rt9")
    hand.change(spawn=["counter", "source", "far"])
    assert {name: task.rtpu for name, task in hand.standing().items()} == {
        "counter": "rt1",
        "source": "rt0",
        "far": "rt0",
    }
    hand.driver.lose("rt0")
    hand.task("late", COUNTER.replace("COUNT", "LATE"))
    assert hand.change(spawn=["late"]) == ""
    assert {name: task.rtpu for name, task in hand.standing().items()} == {"counter": "rt1", "late": "rt1"}


def test_notes_travel_with_the_faults(hand):
    hand.task("counter", COUNTER, local={"NOBODY": "1"})
    answer = hand.asker.ask(hand.order(("counter", "counter")))
    assert [fault.reason for fault in answer.faults] == [Reason.of("host.task_twice", name="counter")]
    assert "NOBODY" in " ".join(map(str, answer.notes))
