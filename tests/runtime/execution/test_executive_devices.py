"""Tasks that have a device: how they begin, fail and hold."""

import pytest

from kit.labs.module_source import HEAD, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.runtime import command, news
from onika.words.reason import Reason

MS = 1_000_000


# Devices

ARM = """
class One(Module):
    hardware = True
    F = InVar("double", "N", "force")
    X = OutVar("double", "m", "place")

    def cycle(self):
        self.X = self.device.read()[0]
        self.device.write((self.F,))

    def error(self, fault):
        return True
"""
FORCE = module(
    "    F = OutVar('double')\n    value = 1.0\n    def on(self, inputs):\n        self.F = 0.0\n"
    "    def cycle(self):\n        self.F = self.value"
)


def arm_rig(error_mends=True):
    source = HEAD + ARM if error_mends else HEAD + ARM.partition("    def error")[0]
    return ExecutiveRig(MassWorld()).spawn("arm", source, device="m0").spawn("force", FORCE, rank=1)


def order_of(rig):
    rig.bus.deliver()
    return rig.bus.world.state("m0")[1]


def test_hardware_without_a_device_cannot_come_on():  # law 16
    rig = ExecutiveRig().spawn("arm", HEAD + ARM).switch(on=["arm"])
    assert rig.last(news.Failed).text == "ModuleError: a hardware task needs a device"


def test_hardware_commands_nothing_until_all_inputs_are_fresh():  # law 4
    rig = arm_rig().switch(on=["arm"]).run(100 * MS)
    assert rig.bus.world.state("m0")[1] == 1.0  # held
    rig.switch(on=["force"]).run(500 * MS)
    assert rig.bus.world.state("m0")[1] == 0.0  # driven
    assert rig["X"] > 0.0


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_nan_at_the_copy_in_is_error_plus_hold(value):  # law 5
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    rig.task("force").module.value = value
    rig.run(120 * MS)
    assert "expected finite inputs, found NaN or infinity in F" in rig.last(news.Failed).text
    assert rig.task("arm").state is State.ERROR
    assert order_of(rig) == 1.0


def test_what_an_old_nan_left_behind_does_not_keep_hardware_off():  # laws 4, 5
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    rig.task("force").module.value = float("nan")
    rig.run(120 * MS).do(command.Clear(HOME, "arm"))
    rig.task("force").module.value = 1.0
    rig.switch(off=["force"]).switch(on=["arm", "force"]).run(300 * MS)
    assert rig.task("arm").state is State.ON


@pytest.mark.parametrize("mends", [True, False])
def test_nan_written_to_the_device_is_a_hold_and_an_error_unless_mended(mends):  # law 5
    rig = arm_rig(mends).switch(on=["arm", "force"]).run(100 * MS)
    rig.task("arm").module.cycle = lambda: rig.task("arm").module.device.write((float("nan"),))
    rig.run(110 * MS)
    assert rig.task("arm").state is (State.ON if mends else State.ERROR)
    assert order_of(rig) == 1.0


def test_a_device_that_falls_silent_is_an_error():  # law 17
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    rig.bus.step = lambda until: None
    rig.run(300 * MS)
    assert "device m0 has published nothing for 60 ms" in rig.last(news.Failed).text
    assert (rig.last(news.Failed).now_ns - 100 * MS) <= 80 * MS


@pytest.mark.parametrize(
    "order",
    [
        command.Switch(HOME, ("arm",), (), ()),
        command.Kill(HOME, "arm"),
        command.Stop(),
        command.Quit(),
        command.Fail(Reason.plain("server gone")),
    ],
)
def test_a_device_is_left_in_hold_whatever_ends_the_task(order):  # laws 17, 27
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    assert order_of(rig) == 0.0
    rig.do(order)
    assert order_of(rig) == 1.0


def test_a_stop_turns_everything_off_and_is_latched():  # law 27
    rig = arm_rig().switch(on=["arm", "force"]).run(50 * MS).do(command.Stop())
    assert {task.state for task in rig.executive.tasks.values()} == {State.OFF}
    rig.switch(on=["arm"]).spawn("more", module())
    assert [event.reason for event in rig.news_of(news.Refused)] == ["this unit was stopped"] * 2
    assert rig.run(100 * MS).executive.next_release() is None


def test_devices_that_are_gone_put_their_tasks_in_error_and_no_others():  # law 17
    rig = arm_rig().switch(on=["arm", "force"]).run(50 * MS).do(command.Fail(Reason.plain("the device server died")))
    assert (rig.last(news.Failed).entry, rig.last(news.Failed).text) == (
        "device", "ModuleError: the device server died",
    )  # fmt: skip
    assert rig.task("force").state is State.ON


def test_a_tripped_drive_is_cleared_though_the_task_comes_on_at_once():  # law 17
    source = HEAD + ARM.replace("        self.X =", "        assert not self.device.is_tripped\n        self.X =")
    source = source.partition("    def error")[0] + "    def clear(self):\n        self.device.clear()\n"
    rig = ExecutiveRig(MassWorld()).spawn("arm", source, device="m0").spawn("force", FORCE, rank=1)
    rig.switch(on=["arm", "force"]).run(100 * MS)
    rig.bus.world._turn(rig.bus.world._masses["m0"], DriveState.TRIPPED, "planted")
    rig.run(130 * MS)
    assert rig.task("arm").state is State.ERROR
    rig.do(command.Clear(HOME, "arm")).switch(on=["arm"]).run(300 * MS)
    assert rig.task("arm").state is State.ON
    assert rig.bus.world.state("m0")[1] == 0.0
