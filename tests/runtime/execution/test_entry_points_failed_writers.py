"""A device is not driven on with what a task wrote that has failed (law 4)."""

import pytest

from kit.labs.module_source import HEAD, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.runtime import command, news
from onika.words.reason import Reason

MS = 1_000_000
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
SICK = """
    sick = ""

    def off(self):
        if self.sick == "off":
            raise ValueError("ill")

    def cycle(self):
        if self.sick == "cycle":
            raise ValueError("ill")
        self.{writes} = {value}
        return off() if self.sick == "signal" else None
"""


def task(reads, writes, value, **flags):
    ports = f"    {writes} = OutVar('double')\n" + (f"    {reads} = InVar('double')\n" if reads else "")
    return module(ports + SICK.format(writes=writes, value=value), **flags)


def rig_with(world, **flags):
    """An arm, the servo that drives it, what the servo follows, somebody who looks on, and another arm."""
    other = {"F": "G", "X": "Y"}
    rig = ExecutiveRig(world)
    rig.spawn("arm", HEAD + ARM, device="m0").spawn("other", HEAD + ARM, device="m1", aliases=other)
    rig.spawn("way", task("", "REF", "1.0", **flags), rank=1).spawn("servo", task("REF", "F", "self.REF"), rank=2)
    rig.spawn("seen", task("F", "SEEN", "self.F"), rank=3).spawn("push", task("", "G", "1.0"), rank=3)
    return rig.switch(on=["arm", "other", "way", "servo", "seen", "push"]).run(100 * MS)


@pytest.fixture
def rig():
    return rig_with(MassWorld())


def sicken(rig, name, how="cycle"):
    rig.task(name).module.sick = how
    return rig.run(120 * MS)


def states(rig):
    return {name: task.state for (_, name), task in rig.executive.tasks.items() if task.state is not State.ON}


def drive(rig, device):
    rig.bus.deliver()
    return DriveState(int(rig.bus.world.state(device)[1]))


@pytest.mark.parametrize(("sick", "variable"), [("servo", "F"), ("way", "REF")])
def test_hardware_that_it_fed_directly_or_through_others_holds_at_that_instant(rig, sick, variable):
    sicken(rig, sick)
    assert states(rig) == {sick: State.ERROR, "arm": State.ERROR}
    first, second = rig.news_of(news.Failed)
    assert (first.task, second.task) == (sick, "arm")
    assert first.now_ns == second.now_ns
    said = f"task {sick}, which wrote {variable}, is ERROR: the device is not driven on with that"
    assert said in second.text
    assert drive(rig, "m0") is DriveState.HELD
    assert drive(rig, "m1") is DriveState.DRIVEN


def test_a_task_that_feeds_no_hardware_fails_alone(rig):
    sicken(rig, "seen")
    assert states(rig) == {"seen": State.ERROR}
    assert drive(rig, "m0") is DriveState.DRIVEN


def test_so_does_a_passive_one():  # law 24
    rig = sicken(rig_with(MassWorld(), passive=True), "way")
    assert states(rig) == {"way": State.ERROR}
    assert drive(rig, "m0") is DriveState.DRIVEN


def test_what_passes_on_no_more_starves_nobody(rig):
    rig.switch(off=["servo"])
    sicken(rig, "way")
    assert states(rig) == {"way": State.ERROR, "servo": State.OFF}


@pytest.mark.parametrize("leave", ["by command", "signal", "off"])
def test_who_goes_off_leaves_his_last_value_in_force(rig, leave):  # law 6
    if leave != "by command":
        rig.task("way").module.sick = leave
    if leave != "signal":
        rig.switch(off=["way"])
    rig.run(120 * MS)
    assert states(rig) == {"way": State.ERROR if leave == "off" else State.OFF}
    assert drive(rig, "m0") is DriveState.DRIVEN


def test_after_both_are_cleared_the_arm_is_driven_again(rig):
    sicken(rig, "servo")
    rig.task("servo").module.sick = ""
    rig.do(command.Clear(HOME, "arm")).switch(on=["arm"]).run(140 * MS)
    assert drive(rig, "m0") is DriveState.HELD  # nobody has written anew
    rig.do(command.Clear(HOME, "servo")).switch(on=["servo"]).run(160 * MS)
    assert states(rig) == {}
    assert drive(rig, "m0") is DriveState.DRIVEN


def test_hardware_is_starved_by_command_where_the_writer_lived_elsewhere(rig):
    why = Reason.plain("task servo is KILLED")
    rig.do(command.Starve(HOME, "arm", why)).do(command.Starve(HOME, "nobody", why))
    assert states(rig) == {"arm": State.ERROR}
    assert "task servo is KILLED" in rig.last(news.Failed).text
    assert drive(rig, "m0") is DriveState.HELD
    rig.do(command.Clear(HOME, "arm")).do(command.Starve(HOME, "arm", why))
    assert states(rig) == {"arm": State.OFF}
