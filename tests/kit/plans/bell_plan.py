"""The plan of one action that prints a line and finishes in its first cycle."""

from kit.plans.plan_builder import PlanBuilder, action
from onika.wire.plan import Plan

_BELL = """
from onika.module import Module, finish

class Bell(Module):
    trigger = True

    def cycle(self):
        print("ding", self.now)
        return finish()
"""


def bell() -> Plan:
    """The plan, of one task `bell` in flow0."""
    shop = PlanBuilder()
    shop.task("bell", _BELL)
    return shop.plan([action("bell")])
