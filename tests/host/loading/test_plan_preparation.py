import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.rail_world import YardLoading
from onika.host.loading.plan_preparation import inspect, prepare
from onika.wire.request import TargetValues
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

ROBOT = """
from onika.module import InVar, Local, Module, OutConst, OutVar

class Robot(Module):
    hardware = True
    N = OutConst("int", "-", "number of joints")
    QMAX = OutConst("double[N]", "m", "how far")
    Q_REF = InVar("double[N]", "m", "where to")
    Q_MEZ = OutVar("double[N]", "m", "where it is")

    @classmethod
    def constants(cls, local, identity):
        return {"N": 2, "QMAX": [1.0, 1.0]}

    @classmethod
    def resolve(cls, constants, targets):
        return [None if max(values) <= constants["QMAX"][0] else f"{max(values)} is too far" for _, values in targets]
"""
MOVE = """
from onika.module import InConst, Input, InVar, Module, OutVar, finish

class Move(Module):
    trigger = True
    N = InConst("int", "-", "number of joints")
    QMAX = InConst("double[N]", "m", "how far")
    Q_MEZ = InVar("double[N]", "m", "where it is")
    Q_REF = OutVar("double[N]", "m", "where to")
    end = Input("double[N]", "m", "where to", low=0.0, high="QMAX")

    def cycle(self):
        return finish()
"""
BELL = """
from onika.module import Module, finish
from onika.words.reason import Reason

class Bell(Module):
    trigger = True
"""


def module(body, name="Some", kind="trigger"):
    lines = "\n".join(f"    {line}" for line in body.splitlines())
    return f"from onika.module import *\nclass {name}(Module):\n    {kind} = True\n{lines}\n"


@pytest.fixture
def shop():
    shop = PlanBuilder()
    shop.task("robot", ROBOT, local={"DEVICE": "yard:m0"}, frequency=500.0)
    shop.task("move", MOVE)
    shop.task("bell", BELL)
    return shop


def preparation(shop, *flows, targets=()):
    return prepare(shop.plan(*flows), targets, YardLoading())


def texts(prepared):
    return [f"{fault.place}: {fault.reason}" for fault in prepared.faults]


def test_a_plan_that_can_run_has_no_fault_and_knows_its_triggers_and_constants(shop):  # R-E01, law 26
    prepared = preparation(shop, [action("robot", "move", arguments="0.5 0.5"), action("robot", "bell")])
    assert prepared.faults == []
    assert prepared.triggers == {(0, 0): "move", (0, 1): "bell"}
    assert prepared.constants == {0: {"N": 2, "QMAX": [1.0, 1.0]}}
    assert [wired.name for wired in prepared.flows[0]] == ["robot", "move", "bell"]


def test_a_task_that_differs_from_its_module_is_told_in_all_that_differs(shop):  # R-B01
    task = shop.task("slow", ROBOT, frequency=20.0, aliases={"Q_REF": "WISH"})
    wrong = type(task)(**{name: getattr(task, name) for name in task.__struct_fields__} | {"outvar": ("Q_MEZ", "ODD")})
    shop._tasks["slow"] = wrong
    sentences = texts(preparation(shop, [action("slow", "bell")]))
    assert any("DEVICE" in sentence for sentence in sentences)
    assert any("40 Hz" in sentence and "20 Hz" in sentence for sentence in sentences)
    assert any("ODD" in sentence for sentence in sentences)
    assert all(sentence.startswith("slow.rmod") for sentence in sentences)
    faults, notes = inspect([wrong], [shop.code("slow")], YardLoading())
    assert [str(fault.place) for fault in faults] == ["slow.rmod"] * 3
    assert notes == []


@pytest.mark.parametrize(
    ("first", "second", "sentence"),
    [
        ('A = OutVar("double", "m", "")', 'A = InVar("double[2]", "m", "")', "A double in m, as one declares"),
        ('A = OutVar("double", "m", "")', 'A = InVar("double", "mm", "")', "double in mm"),
        ('A = OutVar("double", "m", "")', 'A = InVar("int", "m", "")', "int in m"),
        ("", 'A = InConst("double", "m", "")', "expected a task that supplies the constant A, found none"),
        ('A = OutVar("double", "m", "")', 'A = InConst("double", "m", "")', "task one writes it at every cycle"),
        ('A = OutConst("int", "-", "")', 'A = OutConst("int", "-", "")', "one supplier of the constant A"),
        (
            'A = OutConst("int", "-", "")\nB = InConst("int", "-", "")',
            'B = OutConst("int", "-", "")\nA = InConst("int", "-", "")',
            "constants that do not wait for each other",
        ),
        (
            'N = OutConst("int", "-", "")\nQ = OutVar("double[N]", "m", "")',
            'Q = InVar("double[N]", "m", "")',
            "N from `constants` of module one",
        ),
    ],
)
def test_tasks_that_do_not_go_together_are_told(shop, first, second, sentence):  # laws 7, 9, 10, 12
    shop.task("one", module(first, "One"))
    shop.task("two", module(second, "Two"))
    assert any(sentence in text for text in texts(preparation(shop, [action("one", "two")])))


def test_one_module_twice_in_a_flow_is_told(shop):  # law 9
    shop.task("ring", BELL, module="bell")
    assert any(
        "module bell once in a flow" in text for text in texts(preparation(shop, [action("bell"), action("ring")]))
    )
    assert texts(preparation(shop, [action("bell")], [action("ring")])) == []


def test_a_device_is_claimed_by_one_task_over_all_flows(shop):  # laws 9, 28
    shop.task("twin", ROBOT + "\n", local={"DEVICE": "yard:m0"}, module="twin")
    sentences = texts(preparation(shop, [action("robot", "bell")], [action("twin", "bell")]))
    assert sentences == ["twin.rmod: expected device yard:m0 for one task, found task robot claims it too"]
    shop.task("twin", ROBOT + "\n", local={"DEVICE": "yard:m1"}, module="twin")
    assert preparation(shop, [action("robot", "bell")], [action("twin", "bell")]).faults == []


def test_a_device_clash_is_told_even_of_a_task_that_is_wrong_otherwise(shop):  # R-E01
    shop.task("twin", ROBOT + "\n", local={"DEVICE": "yard:m0"}, module="twin", frequency=10.0)
    sentences = texts(preparation(shop, [action("robot", "bell")], [action("twin", "bell")]))
    assert any("claims it too" in sentence for sentence in sentences)
    assert any("40 Hz" in sentence for sentence in sentences)


def test_an_action_without_a_trigger_never_ends(shop):  # R-E03
    sentences = texts(preparation(shop, [action("robot")]))
    assert sentences == ["test.appl:1: expected a trigger that ends job job0, found none"]


def test_of_several_triggers_the_first_counts_and_the_others_are_noted(shop):  # reading 16
    prepared = preparation(shop, [action("bell", "move", "robot")])
    assert prepared.triggers[0, 0] == "bell"
    assert prepared.faults == []
    assert "job0 ends with bell; move is a trigger too" in str(prepared.notes[0])


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("0.5", "expected 2 values (end[2]), found 1"),
        ("0.5 0.5 0.5", "found 3"),
        ("0.5 far", "found 'far'"),
        ("0.5 1.5", "end[1]: expected 0..1 m, found 1.5"),
        ("nan 0.5", "expected a finite number"),
    ],
)
def test_values_that_the_trigger_does_not_take_are_told_before_the_run(shop, line, sentence):  # R-E03, R-X02
    prepared = preparation(shop, [action("robot", "move", arguments=line)])
    assert len(prepared.faults) == 1
    assert sentence in str(prepared.faults[0].reason)
    assert str(prepared.faults[0].place) == "test.appl:1"


def test_targets_out_of_reach_are_told_each(shop):  # R-X02, R-E09, law 26
    flow = [action("robot", "move", arguments="0 0"), action("robot", "bell"), action("robot", "move", arguments="0 0")]
    targets = [TargetValues(0, n, "joint object", (float(n), 0.0)) for n in (0, 2)]
    sentences = texts(preparation(shop, flow, targets=targets))
    assert sentences == ["test.appl:3: expected a target within reach, found there: 2.0 is too far"]


def test_a_target_of_another_flow_is_none_of_a_robots_business(shop):  # R-K02
    targets = [TargetValues(1, 0, "joint object", (9.0, 9.0))]
    assert preparation(shop, [action("robot", "bell")], [action("bell")], targets=targets).faults == []


@pytest.mark.parametrize("hertz", [20.0, 39.9, 0.001])
def test_a_configuration_may_not_slow_hardware_below_forty_hertz(shop, hertz):  # law 17
    (sentences,) = texts(preparation(shop, [action("robot", "bell", rates={"robot": hertz, "bell": 1.0})]))
    assert sentences == f"test.appl:1: expected hardware task robot in job0 at 40 Hz or more, found {hertz:g} Hz"


def test_no_rate_is_beyond_what_the_clock_can_tell(shop):  # R-A04, law 13
    shop.task("fast", module("", "Fast"), frequency=1e9)
    sentences = texts(preparation(shop, [action("robot", "fast", rates={"robot": 2e9})]))
    assert sentences == [
        "fast.rmod: expected 0.001 Hz to 1e+06 Hz for fast, found 1e+09 Hz",
        "test.appl:1: expected 0.001 Hz to 1e+06 Hz for robot in job0, found 2e+09 Hz",
    ]


def test_code_that_cannot_be_loaded_is_told_once_and_the_rest_is_looked_at(shop):  # R-E01
    shop.task("bad", "class Bad(:\n")
    shop.task("slow", module("", "Slow", "hardware"), frequency=10.0, local={"DEVICE": "yard:m1"})
    sentences = texts(preparation(shop, [action("robot", "bad", "bell"), action("slow", "bell")]))
    assert len(sentences) == 2
    assert sentences[0].startswith("bad.py:1: expected Python")
    assert sentences[1].startswith("slow.rmod: expected a hardware task of at least 40 Hz")


def test_what_a_robot_cannot_say_of_itself_is_told(shop):  # R-B07
    shop.task("robot", ROBOT.replace("return {", "return 1 / 0, {"), local={"DEVICE": "yard:m0"}, frequency=500.0)
    sentences = texts(preparation(shop, [action("robot", "bell")]))
    assert any("ZeroDivisionError" in sentence for sentence in sentences)


def test_faults_stand_in_order_and_once(shop):
    prepared = preparation(shop, [action("robot"), action("robot"), action("move")])
    assert prepared.faults == sorted(set(prepared.faults))
    assert Fault(
        Place("test.appl", 1),
        Reason.of("host.trigger_missing", job="job0"),
        Reason.of("words.application_not_run"),
    ) in (prepared.faults)
