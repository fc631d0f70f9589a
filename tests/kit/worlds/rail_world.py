"""A mass on a rail of the small world and a servo that drives it, as modules in text, for tests of what runs them."""

from kit.plans.plan_builder import PlanBuilder
from onika.host.loading.module_facts import ModuleFacts
from onika.words.fault import Fault

MASS = """
from onika.module import InVar, Module, ModuleError, OutConst, OutVar

class Mass(Module):
    hardware = True

    SIDES = OutConst("int", "-", "left and right")
    FORCE = InVar("double", "N", "what pushes it")
    X = OutVar("double[SIDES]", "m,m/s", "where it is, how fast")

    @classmethod
    def constants(cls, local, identity):
        return {"SIDES": 2}

    @classmethod
    def resolve(cls, constants, targets):
        return [None if abs(values[0]) < 10 else f"{values[0]:g} m is beyond the rail" for _, values in targets]

    def init(self):
        self.SIDES = 2

    def on(self, inputs):
        self.X = self.device.read()

    def cycle(self):
        self.X = self.device.read()
        if self.device.is_tripped:
            raise ModuleError("the drive has tripped")
        self.device.write((self.FORCE,))
"""

SERVO = """
from onika.module import InConst, Input, InVar, Module, OutVar, finish

class Servo(Module):
    trigger = True

    SIDES = InConst("int", "-", "left and right")
    X = InVar("double[SIDES]", "m,m/s", "where it is, how fast")
    FORCE = OutVar("double", "N", "what pushes it")

    goal = Input("double", "m", "where to", low=-9.0, high=9.0)

    def on(self, inputs):
        self._goal = inputs.goal

    def cycle(self):
        self.FORCE = 100.0 * (self._goal - self.X[0]) - 20.0 * self.X[1]
        near = abs(self.X[0] - self._goal) < 1e-3 and abs(self.X[1]) < 1e-3
        return finish() if near else None
"""


def rail_tasks(rtpu: str = "unknown", mass: str = "yard:m0") -> PlanBuilder:
    """A plan builder with the tasks `mass` and `servo`, at 500 and 100 Hz; the servo runs on `rtpu`."""
    shop = PlanBuilder()
    shop.task("mass", MASS, frequency=500.0, local={"DEVICE": mass})
    shop.task("servo", SERVO, rtpu=rtpu)
    return shop


class YardLoading(ModuleFacts):
    """Knows the small world by the name that tests give it, besides those that are installed."""

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """Two masses and a scale in the yard."""
        return ("m0", "m1", "scale") if world == "yard" else super().devices(world)
