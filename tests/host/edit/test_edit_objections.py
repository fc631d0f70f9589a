import pytest

from kit.runtime.live_edits import COUNTER, READER, SOURCE, USER, live_edits_with_tasks
from kit.worlds.rail_world import MASS, rail_tasks
from onika.wire import live, request


@pytest.fixture
def hand():
    edits = live_edits_with_tasks()
    edits.change(spawn=["source", "user", "counter"], on=["source", "user"])
    return edits


def objections(hand, order):
    """All that is wrong with what is asked, as sentences."""
    before = hand.standing()
    answer = hand.asker.ask(order)
    assert isinstance(answer, request.Prepared)
    assert answer.faults
    assert {str(fault.instead) for fault in answer.faults} <= {"nothing is changed", "module broken is not loaded"}
    assert hand.standing() == before
    return [str(fault.reason) for fault in answer.faults]


def test_everything_that_is_wrong_is_told_at_once(hand):  # R-B07
    order = live.Change("s0", kill=("no",), off=("nor",), on=(live.Turn("never"),), rates=(("none", 5.0),))
    assert objections(hand, order) == [
        "expected one of counter, source, user, found never",
        "expected one of counter, source, user, found no",
        "expected one of counter, source, user, found none",
        "expected one of counter, source, user, found nor",
    ]


def test_a_task_lives_once(hand):  # R-A06
    assert objections(hand, hand.order(("counter",))) == ["expected each task once in a subsystem, found counter twice"]
    twice = hand.order(("reader", "reader"))
    assert objections(hand, twice) == ["expected each task once in a subsystem, found reader twice"]


def test_a_module_is_instantiated_once(hand):  # R-A06
    hand.task("second", COUNTER, module="counter")
    assert objections(hand, hand.order(("second",))) == [
        "expected module counter once in a flow, found also in task counter"
    ]


def test_a_constant_has_one_supplier(hand):  # law 9
    hand.task("second", SOURCE, module="second")
    assert objections(hand, hand.order(("second",))) == [
        "expected one supplier of the constant N, found also task source"
    ]


def test_a_variable_has_one_shape_and_unit(hand):  # law 7
    hand.task("reader", READER.replace("double[N]", "double[3]"))
    assert objections(hand, hand.order(("reader",))) == [
        "expected ROW double[N] in m, as user declares, found double[3] in m"
    ]


@pytest.mark.parametrize("hz", [0.0, -1.0, 1e9, float("nan"), float("inf")])
def test_a_rate_that_no_task_can_have_is_refused(hand, hz):  # R-A04, law 17
    assert objections(hand, live.Change("s0", rates=(("counter", hz),))) == [
        f"expected 0.001 Hz to 1e+06 Hz for counter now, found {hz:g} Hz"
    ]


def test_hardware_is_not_made_slower_than_its_drive_allows(hand):  # law 17
    hand.shop = rail_tasks()
    hand.change(spawn=["mass"])
    assert objections(hand, live.Change("s0", rates=(("mass", 39.0),))) == [
        "expected hardware task mass now at 40 Hz or more, found 39 Hz"
    ]


def test_a_task_without_a_rate_is_given_none(hand):  # R-A04
    hand.task("once", COUNTER.replace("COUNT", "ONCE"), frequency=None)
    hand.change(spawn=["once"])
    assert objections(hand, live.Change("s0", rates=(("once", 5.0),))) == [
        "expected a rate for a task that has one, once is aperiodic, found 5 Hz"
    ]


def test_a_device_is_held_by_one_task_of_all_subsystems(hand):  # law 16
    hand.shop = rail_tasks()
    hand.change(spawn=["mass"], subsystem="s1")
    assert objections(hand, hand.order(("mass",))) == [
        "expected device yard:m0 for one task, found task mass claims it too"
    ]


@pytest.mark.parametrize(
    ("device", "expected"),
    [("yard:m9", "a device of world yard (m0, m1, scale)"), ("nowhere:m0", "a world (none installed)")],
)
def test_a_device_that_no_world_has_is_refused(hand, device, expected):  # law 16
    hand.task("mass", MASS, frequency=500.0, local={"DEVICE": device})
    assert objections(hand, hand.order(("mass",))) == [f"expected {expected}, found DEVICE {device}"]


def test_code_that_does_not_load_is_refused(hand):  # law 21
    hand.task("broken", "def broken(:\n")
    assert len(objections(hand, hand.order(("broken",)))) == 1


def test_a_parameter_that_cannot_be_is_refused_before_anything_goes_off(hand):  # law 12
    order = live.Reinit("s0", "source", (("SIZE", ("many",)),))
    hand.asker.server.events.clear()
    assert "'many'" in objections(hand, order)[0]
    assert hand.asker.server.events == []


def test_a_living_task_keeps_its_device(hand):  # law 16
    hand.shop = rail_tasks()
    hand.change(spawn=["mass"])
    assert objections(hand, live.Reinit("s0", "mass", (("DEVICE", ("yard:m1",)),))) == [
        "expected DEVICE yard:m0 as before; exchange the task, found DEVICE yard:m1"
    ]


def test_new_code_keeps_the_ports_that_others_are_bound_to(hand):  # law 21, law 7
    hand.task("user", USER.replace("double[N]", "double[5]"))
    assert objections(hand, live.Swap("s0", "user", *hand.code("user"))) == [
        "expected ROW double[N] in m, as it is bound, found double[5] in m"
    ]
    hand.task("user", USER.replace('"m", "the level', '"mm", "the level'))
    assert objections(hand, live.Swap("s0", "user", *hand.code("user"))) == [
        "expected ROW double[N] in m, as it is bound, found double[N] in mm"
    ]


def test_new_code_is_no_module_that_lives_here_already(hand):  # R-A06
    hand.task("other", COUNTER, module="source")
    assert "also in task" in " ".join(objections(hand, live.Swap("s0", "counter", *hand.code("other"))))


def test_new_code_does_not_become_hardware(hand):  # law 21
    hand.task("counter", COUNTER.replace("    COUNT", "    hardware = True\n    COUNT"), local={"DEVICE": "yard:m0"})
    assert hand.asker.ask(live.Swap("s0", "counter", *hand.code("counter"))).faults
