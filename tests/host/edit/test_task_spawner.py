import pytest

from kit.live_edits import LiveEdits, live_edits_with_tasks
from kit.rail_world import rail_tasks
from onika.host.edit.task_spawner import Cradle, plainly

BYSTANDER = """
from onika.module import Module, OutVar

class Bystander(Module):
    SEEN = OutVar("double", "m", "where the mass is")

    def cycle(self):
        self.SEEN = self.device.read()[0]
"""


def test_a_device_is_free_again_when_its_task_is_gone():  # law 16, law 18
    hand = LiveEdits()
    hand.shop = rail_tasks()
    for _ in range(3):
        assert hand.change(spawn=["mass"], on=["mass"]) == ""
        assert hand.change(kill=["mass"]) == ""


def test_a_device_that_a_task_without_hardware_was_granted_is_free_again_too():  # law 16
    hand = LiveEdits()
    hand.task("bystander", BYSTANDER, local={"DEVICE": "yard:m1"})
    for _ in range(2):
        assert hand.change(spawn=["bystander"], on=["bystander"]) == ""
        hand.let_pass(0.1)
        assert hand.states == {"bystander": "ON"}
        assert hand.change(kill=["bystander"]) == ""


def test_a_device_is_free_again_when_its_task_could_not_be_born():  # R-X10
    hand = LiveEdits()
    hand.shop = rail_tasks()
    good = hand.shop.planned("mass")
    hand.task(
        "mass",
        hand.shop.code("mass").source.replace("init(self):", "init(self):\n        1 / 0"),
        local={"DEVICE": "yard:m0"},
    )
    assert "init: ZeroDivisionError" in hand.change(spawn=["mass"])
    hand.shop = rail_tasks()
    assert hand.shop.planned("mass") == good
    assert hand.change(spawn=["mass"], on=["mass"]) == ""


def test_a_birth_that_a_stopped_unit_refuses_gives_its_device_back():  # law 27
    hand = LiveEdits()
    hand.shop = rail_tasks()
    hand.driver.stop()
    assert "stopped" in hand.change(spawn=["mass"])
    assert hand.states == {}
    hand.driver.reset()
    assert hand.change(spawn=["mass"], on=["mass"]) == ""


def test_code_that_nobody_runs_any_more_is_forgotten():  # R-A14
    hand = live_edits_with_tasks()
    hand.change(spawn=["counter"], on=["counter"])
    source = hand.shop.code("counter").source
    for number in range(5):
        hand.task("counter", f"# {number}\n{source}", frequency=50.0)
        assert hand.swap("counter") == ""
    cradle = hand.asker.program.stage.live["s0"].cradle
    assert isinstance(cradle, Cradle)
    assert list(cradle.code) == [hand.shop.code("counter").digest]


@pytest.mark.parametrize(
    ("wrong", "text"), [(KeyError("N"), "the constant N has no value"), (ValueError("too big"), "too big")]
)
def test_what_is_wrong_with_a_shape_is_said_in_words(wrong, text):
    assert plainly(wrong) == text
