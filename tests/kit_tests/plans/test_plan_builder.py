from kit.plans.plan_builder import PlanBuilder, action

SUM = """
from onika.module import InConst, InVar, Module, OutVar

class Sum(Module):
    N = InConst("int", "-", "how many")
    Y = InVar("double", "m", "one")
    Z = OutVar("double", "m", "all")
"""


def test_a_task_has_the_ports_of_its_module():
    task = PlanBuilder().task("total", SUM, frequency=20.0, local={"DEVICE": "yard:m0"}, aliases={"Y": "X"})
    assert (task.inconst, task.outconst, task.invar, task.outvar) == (("N",), (), ("Y",), ("Z",))
    assert (task.local, task.aliases, task.type) == ((("DEVICE", ("yard:m0",)),), (("Y", "X"),), "periodic")


def test_a_task_without_a_rate_is_aperiodic():
    assert PlanBuilder().task("total", SUM, frequency=None).type == "aperiodic"


def test_a_plan_holds_each_task_and_each_code_once_and_nothing_unused():
    shop = PlanBuilder()
    shop.task("one", SUM, module="sum")
    shop.task("two", SUM, module="sum")
    shop.task("idle", SUM + "\n# not the same\n")
    plan = shop.plan([action("one"), action("one", "two", arguments="5", rates={"two": 20.0})], [action("two")])
    assert [[task.name for task in flow.tasks] for flow in plan.flows] == [["one", "two"], ["two"]]
    assert [code.module for code in plan.code] == ["sum"]
    assert plan.flows[0].actions[1].rates == (("two", 20.0),)
    assert [planned.target for planned in plan.flows[0].actions] == [None, "there"]
    assert shop.code("one") is plan.code[0]


def test_a_module_that_cannot_be_loaded_has_no_ports():
    assert PlanBuilder().task("bad", "class Bad(:").invar == ()
