import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import action
from kit.worlds.rail_world import rail_tasks
from onika.desk.plan.varied import LocalAddress, varied


@pytest.fixture
def plan():
    """A plan of two flows with the same task, which has LOCAL lines of its own."""
    one = rail_tasks().plan([action("mass", "servo", arguments="1.0")])
    (flow,) = one.flows
    lines = (("STIFF", ("1.0",)), ("HOME", ("0", "0.5", "1")), ("DEVICE", ("yard:m0",)))
    tasks = tuple(replace(task, local=lines) if task.name == "mass" else task for task in flow.tasks)
    return replace(one, flows=(replace(flow, tasks=tasks), replace(flow, tasks=tasks, subsystem="flow1")))


def local(plan, number=0):
    return dict(next(task.local for task in plan.flows[number].tasks if task.name == "mass"))


def test_a_number_of_a_task_is_otherwise_in_every_flow_that_has_it(plan):  # R-X23
    other, _, faults = varied(plan, [("mass.STIFF", 0.25), ("mass.HOME[1]", -2.0)])
    assert faults == ()
    for number in (0, 1):
        assert local(other, number)["STIFF"] == ("0.25",)
        assert local(other, number)["HOME"] == ("0", "-2", "1")
    assert local(plan)["STIFF"] == ("1.0",)


def test_nothing_else_of_the_plan_changes(plan):  # R-X23
    other, _, _ = varied(plan, [("mass.STIFF", 1.0)])
    assert [task for task in other.flows[0].tasks if task.name != "mass"] == [
        task for task in plan.flows[0].tasks if task.name != "mass"
    ]
    assert varied(plan, []) == (plan, {}, ())


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("mass", "expected TASK.NAME"),
        ("mass.STIFF[x]", "expected TASK.NAME"),
        ("arm.STIFF", "expected one of mass, servo and yard, found no task arm"),
        ("mass.DAMP", "expected one of the LOCAL lines STIFF, HOME and DEVICE of mass, found DAMP"),
        ("mass.HOME", "mass.HOME has 3 numbers: say which, as mass.HOME[0]"),
        ("mass.HOME[3]", "found that there are 3"),
        ("mass.DEVICE", "expected a number there, found yard:m0"),
    ],
)
def test_what_cannot_be_varied_is_a_fault_that_says_what_can(plan, name, words):  # R-X23
    other, of_worlds, (fault,) = varied(plan, [(name, 1.0)])
    assert words in str(fault.reason)
    assert (other, of_worlds) == (plan, {})


def test_what_begins_with_the_name_of_a_world_means_that_world(plan):  # R-X23
    other, of_worlds, faults = varied(plan, [("yard.friction", 0.5), ("yard.mass", 2.0)])
    assert (other, of_worlds, faults) == (plan, {"yard": {"friction": 0.5, "mass": 2.0}}, ())


def test_an_address_is_written_as_it_is_read():  # R-X23
    assert [str(LocalAddress.parse(text)) for text in ("pd.STIFF", " pd.HOME[2] ")] == ["pd.STIFF", "pd.HOME[2]"]
