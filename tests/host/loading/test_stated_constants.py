"""What tasks state before they live; who cannot is told of once."""

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.rail_world import YardLoading
from onika.host.loading.stated_constants import stated_constants
from onika.runtime.wiring import wire

ARM = """
from onika.module import Module, OutConst, OutVar

class Arm(Module):
    hardware = True
    NDOF = OutConst("int", "-", "joints")
    Q_MEZ = OutVar("double[NDOF]", "rad", "where they are")

    @classmethod
    def constants(cls, local, identity):
        return {"NDOF": int(identity["NDOF"][0])}
"""


@pytest.mark.parametrize(("device", "keys"), [("yard:m7", []), ("yard:m0", ["host.constants_failed"])])
def test_a_task_is_told_of_once_and_not_of_each_variable_that_it_cannot_shape(device, keys):  # R-B07, law 7
    shop = PlanBuilder()
    shop.task("arm", ARM, local={"DEVICE": device}, frequency=500.0)
    plan, loading = shop.plan([action("arm")]), YardLoading()
    (task,) = plan.flows[0].tasks
    stated = stated_constants([wire(task, loading.sheet(plan.code[0]))], {task.digest: plan.code[0]}, loading)
    assert ([fault.reason.key for fault in stated.faults], stated.robots) == (
        keys,
        [],
    )  # of a device that is nowhere it is told already
