"""A device is not driven again while a task that feeds it is still in ERROR, however many tasks stand between."""

import pytest

from kit.runtime.live_edits import LiveEdits
from onika.host.edit.failed_writers import objection_to_clear, objections_to_switch
from onika.wire import live
from onika.words.reason import NOTHING

MASS = """
from onika.module import InVar, Module, OutVar

class Mass(Module):
    hardware = True

    FORCE = InVar("double", "N", "what pushes it")
    X = OutVar("double", "m", "where it is")

    def cycle(self):
        self.X = self.device.read()[0]
        self.device.write((self.FORCE,))
"""
PASS = """
from onika.module import InVar, Module, ModuleError, OutVar

class Pass(Module):
    passive = {passive}

    IN = InVar("double", "N", "what is passed on")
    OUT = OutVar("double", "N", "what was passed on")

    def on(self, inputs):
        self._is_sick = False

    def cycle(self):
        if self._is_sick:
            raise ModuleError("sick")
        self.OUT = self.IN
"""


def edits_of(*tasks):
    """A mass on a rail; `tasks` are name, variable that is read, variable that is written."""
    edits = LiveEdits()
    edits.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"})
    for name, reads, writes in tasks:
        source = PASS.format(passive=name == "lamp")
        edits.task(name, source, frequency=500.0, aliases={"IN": reads, "OUT": writes})
    names = ["mass", *(name for name, _, _ in tasks)]
    assert edits.change(spawn=names, on=names) == ""
    edits.let_pass(0.1)
    return edits


def sicken(edits, *names):
    for name in names:
        edits.driver.living()["s0", name].module._is_sick = True
    edits.let_pass(0.1)


@pytest.fixture
def edits():
    """`way` leads the `servo`, which drives the mass."""
    return edits_of(("way", "GOAL", "REF"), ("servo", "REF", "FORCE"))


CLEAR_WAY = "way feeds mass and is still in ERROR: clear it first, or remove it"
WOULD_BE_DRIVEN = "mass would be driven with what way wrote, which is still in ERROR: clear way first, or remove it"


def test_what_starved_a_device_is_cleared_before_it_two_steps_up(edits):  # law 4, R-X24
    sicken(edits, "way")
    assert edits.states == {"mass": "ERROR", "servo": "ON", "way": "ERROR"}
    assert edits.clear("mass") == CLEAR_WAY
    assert edits.states["mass"] == "ERROR"
    assert edits.clear("way") == ""
    assert edits.clear("mass") == ""
    assert edits.change(on=["way", "mass"]) == ""
    edits.let_pass(0.1)
    assert edits.states == {"mass": "ON", "servo": "ON", "way": "ON"}


def test_where_nothing_is_in_the_way_there_is_no_objection(edits):
    live_subsystem = edits.asker.program.subsystems.live["s0"]
    assert objection_to_clear(live_subsystem, "mass") == NOTHING
    assert objections_to_switch(live_subsystem, (), ["mass"]) == {}


def test_a_task_between_that_was_turned_off_makes_no_difference(edits):  # law 4
    sicken(edits, "way")
    assert edits.change(off=["servo"]) == ""
    assert edits.clear("mass") == CLEAR_WAY


def test_one_that_is_removed_is_in_nobodys_way(edits):  # law 6
    sicken(edits, "way")
    assert edits.change(kill=("way",)) == ""
    assert edits.clear("mass") == ""
    assert edits.change(on=["mass"]) == ""


def test_a_device_does_not_come_on_over_a_writer_that_failed_while_it_was_off(edits):  # law 4
    assert edits.change(off=["mass"]) == ""
    sicken(edits, "way")
    assert edits.change(on=["mass"]) == f"mass: on: {WOULD_BE_DRIVEN}"
    assert edits.states["mass"] == "OFF"


def test_nor_does_a_task_come_on_that_would_lead_to_a_device_what_such_a_writer_left(edits):  # law 4
    assert edits.change(off=["servo"]) == ""
    sicken(edits, "way")
    assert edits.states["mass"] == "ON"
    assert edits.change(on=["servo"]) == f"servo: on: {WOULD_BE_DRIVEN}"
    assert edits.states == {"mass": "ON", "servo": "OFF", "way": "ERROR"}


def test_what_is_off_between_leads_nothing_to_a_device(edits):  # law 6
    assert edits.change(off=["servo", "mass"]) == ""
    sicken(edits, "way")
    assert edits.change(on=["mass"]) == ""


def test_who_names_the_failed_task_as_one_that_is_to_be_off_wants_it_so(edits):  # law 6
    assert edits.change(off=["mass"]) == ""
    sicken(edits, "way")
    assert edits.change(off=["way"], on=["mass"]) == ""
    edits.let_pass(0.1)
    assert edits.states == {"mass": "ON", "servo": "ON", "way": "ERROR"}


def test_a_failed_task_that_is_exchanged_for_another_is_in_nobodys_way(edits):  # R-A14
    sicken(edits, "way")
    edits.task("path", PASS.format(passive=False), frequency=500.0, aliases={"IN": "GOAL", "OUT": "REF"})
    assert edits.change(spawn=["path"], on=["path"], kill=("way",)) == ""
    assert edits.clear("mass") == ""
    assert edits.change(on=["mass"]) == ""


def test_who_failed_before_it_was_on_and_who_is_passive_are_in_nobodys_way():  # laws 22, 24
    edits = edits_of(("lamp", "GOAL", "REF"), ("servo", "REF", "FORCE"))
    sicken(edits, "lamp")
    assert edits.states == {"lamp": "ERROR", "mass": "ON", "servo": "ON"}
    assert edits.change(off=["mass"]) == ""
    assert edits.change(on=["mass"]) == ""


def test_all_that_failed_are_named_and_none_that_feeds_another_device():  # law 4
    edits = edits_of(("way", "GOAL", "REF"), ("servo", "REF", "FORCE"), ("seen", "REF", "SEEN"))
    sicken(edits, "servo", "way", "seen")
    assert edits.clear("mass") == "servo and way feed mass and are still in ERROR: clear them first, or remove them"
    for name in ("way", "servo", "mass"):
        assert edits.clear(name) == ""
    assert edits.states["seen"] == "ERROR"


def test_two_devices_that_feed_each_other_are_cleared_one_after_the_other():  # law 4
    edits = LiveEdits()
    edits.task("left", MASS, frequency=500.0, local={"DEVICE": "yard:m0"}, aliases={"FORCE": "F_L", "X": "X_L"})
    edits.task("right", MASS, frequency=500.0, local={"DEVICE": "yard:m1"}, aliases={"FORCE": "F_R", "X": "X_R"})
    for name, reads, writes in (("to_left", "X_R", "F_L"), ("to_right", "X_L", "F_R")):
        source = PASS.format(passive=False).replace('IN = InVar("double", "N"', 'IN = InVar("double", "m"')
        edits.task(name, source, frequency=500.0, aliases={"IN": reads, "OUT": writes})
    everybody = ["left", "right", "to_left", "to_right"]
    assert edits.change(spawn=everybody, on=everybody) == ""
    edits.let_pass(0.1)
    sicken(edits, "to_left")
    assert edits.states == {"left": "ERROR", "right": "ERROR", "to_left": "ERROR", "to_right": "ON"}
    assert edits.clear("to_left") == ""
    assert edits.clear("left") == ""
    assert edits.change(on=["to_left", "left"]).startswith("left: on: left would be driven with what right wrote")
    assert edits.clear("right") == ""
    assert edits.change(on=["to_left", "left", "right"]) == ""


def test_clears_that_wait_for_each_other_are_judged_when_their_turn_has_come(edits):  # law 4
    sicken(edits, "way")
    first = edits.asker.ask(live.Clear("s0", "way"))
    second = edits.asker.ask(live.Clear("s0", "mass"))
    assert (edits.outcome(first), edits.outcome(second)) == ("", "")
    assert edits.states["mass"] == "OFF"
