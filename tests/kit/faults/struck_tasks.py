"""Tasks of a runtime that is struck: each raises as soon as a file of its name says that it is sick."""

from pathlib import Path

from kit.plans.plan_builder import PlanBuilder

SICK = ".sick"
"""What the name of that file ends with, after the task's."""

_IMPORTS = """
from pathlib import Path

from onika.module import InVar, Module, ModuleError, OutVar

sick = Path("{sick}")
"""
_CYCLE = """
    def cycle(self):
        if sick.exists():
            raise ModuleError("sick")
"""
_ARM = (
    _IMPORTS
    + """
class Arm(Module):
    hardware = True

    TURN = InVar("double", "rad", "how far the first joint is turned", step=1.0)
    X = OutVar("double", "rad", "where the first joint is")

    def init(self):
        self.clear_drive()

    def on(self, inputs):
        self._stand = [float(angle) for angle in self.device.read()[:6]]
"""
    + _CYCLE
    + """
        self.X = float(self.device.read()[0])
        self.check_drive()
        self.device.write((self._stand[0] + self.TURN, *self._stand[1:]))
"""
)
_PUSH = (
    _IMPORTS
    + """
class Push(Module):
    trigger = True

    X = InVar("double", "rad", "where the first joint is")
    TURN = OutVar("double", "rad", "how far it is turned")
"""
    + _CYCLE
    + """
        self.TURN = 0.01
"""
)
_LAMP = (
    _IMPORTS
    + """
class Lamp(Module):
    passive = True

    X = InVar("double", "rad", "where the first joint is")
    SEEN = OutVar("double", "rad", "where it was seen")
"""
    + _CYCLE
    + """
        self.SEEN = self.X
"""
)


def struck_tasks(folder: Path) -> PlanBuilder:
    """Two arms, what pushes each, and a lamp; the files that make them sick lie in this folder."""
    shop = PlanBuilder()

    def source(text: str, name: str) -> str:
        return text.format(sick=folder / f"{name}{SICK}")

    for name, device in (("arm", "arm_left_kin"), ("arm2", "arm_right_kin")):
        shop.task(name, source(_ARM, name), frequency=250.0, local={"DEVICE": f"boxes:{device}"}, rtpu="rt0")
    for name in ("push", "push2"):
        shop.task(name, source(_PUSH, name), frequency=50.0, rtpu="rt1")
    shop.task("lamp", source(_LAMP, "lamp"), frequency=50.0, rtpu="rt2")
    return shop
