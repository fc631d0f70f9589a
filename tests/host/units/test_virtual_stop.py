"""A stop in virtual time: everything is off and every drive holds at that instant, until it is reset (law 27)."""

import pytest

from kit.runtime.live_edits import COUNTER, LiveEdits
from kit.worlds.rail_world import MASS
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.ring.drive import DriveMode

PUSH = """
from onika.module import Module, OutVar

class Push(Module):
    FORCE = OutVar("double", "N", "what pushes it")

    def cycle(self):
        self.FORCE = 0.1
"""
EVERYBODY = ["mass", "push", "there"]


@pytest.fixture
def edits():
    """A mass that is pushed from one unit, and a task on another."""
    edits = LiveEdits(("rt0", "rt1"))
    edits.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"}, rtpu="rt0")
    edits.task("push", PUSH, frequency=500.0, rtpu="rt0")
    edits.task("there", COUNTER, frequency=50.0, rtpu="rt1")
    assert edits.change(spawn=EVERYBODY, on=EVERYBODY) == ""
    edits.let_pass(0.1)
    return edits


def states(edits):
    return {name: task.state for (_, name), task in edits.driver.living().items()}


def world(edits):
    return edits.driver._buses._buses["yard"].world


def drive(edits):
    return DriveState(int(world(edits).state("m0")[1]))


def test_at_a_stop_every_task_of_every_unit_is_off_and_the_drive_holds_at_once(edits):  # law 27
    assert set(states(edits).values()) == {State.ON} and drive(edits) is DriveState.DRIVEN
    edits.driver.stop()
    assert states(edits) == dict.fromkeys(EVERYBODY, State.OFF)
    assert world(edits).modes()["m0"] is DriveMode.STOPPED
    edits.let_pass(0.1)
    assert drive(edits) is DriveState.HELD


def test_what_comes_on_during_a_stop_moves_nothing_and_after_a_reset_it_moves_again(edits):  # law 27
    edits.driver.stop()
    edits.let_pass(0.1)
    edits.change(on=["mass", "push"])
    edits.let_pass(0.1)
    assert drive(edits) is DriveState.HELD
    edits.change(off=["mass", "push"])
    edits.driver.reset()
    edits.let_pass(0.1)
    assert drive(edits) is DriveState.HELD
    assert edits.change(on=EVERYBODY) == ""
    edits.let_pass(0.1)
    assert drive(edits) is DriveState.DRIVEN
