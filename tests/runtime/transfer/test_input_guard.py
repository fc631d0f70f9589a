import pytest

from kit.runtime.executive_rig import ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.runtime import command, news

MS = 1_000_000

ARM = """
from onika.module import InVar, Module

class Arm(Module):
    hardware = True
    FORCE = InVar("double", "N", "what pushes it", step=1.0)

    def init(self):
        self.words = []

    def hold(self):
        self.words.append("hold")
        self.device.hold()

    def cycle(self):
        self.words.append(self.FORCE)
        self.device.write((self.FORCE,))
"""

PUSH = """
from onika.module import Module, OutVar

class Push(Module):
    FORCE = OutVar("double", "N", "what pushes it")
    def init(self):
        self.level = 0.5

    def set(self, name, value):
        self.level = float(value)

    def cycle(self):
        self.FORCE = self.level
"""


@pytest.fixture
def rig():
    return ExecutiveRig(MassWorld()).spawn("arm", ARM, device="m0").spawn("push", PUSH, rank=1)


def test_it_holds_until_every_input_is_fresh_and_nothing_of_that_is_a_step(rig):  # law 4, R-X04
    rig.switch(on=["arm", "push"]).run(100 * MS)
    words = rig.task("arm").module.words
    assert words[:3] == ["hold", 0.5, 0.5]
    assert rig.task("arm").input_guard.is_waiting is False
    assert rig.task("push").input_guard is None
    assert [event.step for event in rig.news_of(news.Stepped)] == [0.0]


def test_what_is_no_number_is_a_fault_before_it_is_a_step(rig):  # law 5
    rig.switch(on=["arm", "push"]).run(100 * MS)
    rig.task("push").module.level = float("nan")
    rig.switch(off=["push"], on=["push"]).run(200 * MS)
    (failed,) = rig.news_of(news.Failed)
    assert "expected finite inputs, found NaN or infinity in FORCE" in failed.text


def test_a_device_that_says_nothing_is_a_fault(rig):  # law 16
    rig.switch(on=["arm", "push"]).run(100 * MS)
    rig.bus = None
    rig.run(400 * MS)
    assert "has published nothing for 60 ms" in rig.news_of(news.Failed)[0].text


def test_a_value_that_is_told_to_a_module_is_a_reconfiguration_too(rig):  # R-X04
    rig.switch(on=["arm", "push"]).run(200 * MS)
    rig.do(command.Set("rig", "push", "level", "4.5")).run(400 * MS)
    last = rig.news_of(news.Stepped)[-1]
    assert (last.step, last.cycles) == (4.0, 8)
    assert rig.task("arm").module.words[-1] == 4.5


def test_going_off_in_the_midst_of_a_step_tells_it(rig):  # R-X04
    rig.switch(on=["arm", "push"]).run(200 * MS)
    rig.task("push").module.level = 4.5
    rig.switch(off=["push"], on=["push"]).run(rig.now + 20 * MS)
    rig.switch(off=["arm"])
    assert rig.news_of(news.Stepped)[-1].step == 4.0
