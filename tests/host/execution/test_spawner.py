import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import LiveEdits, live_edits_with_tasks
from kit.worlds.rail_world import YardLoading, rail_tasks
from onika.host.execution.spawner import Spawner, shape_fault
from onika.host.loading.plan_preparation import prepare
from onika.ring.segment import Segment
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table

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
    source, first = hand.shop.code("counter").source, hand.shop.code("counter").digest
    for number in range(5):
        hand.task("counter", f"# {number}\n{source}", frequency=50.0)
        assert hand.swap("counter") == ""
    spawner = hand.asker.program.subsystems.live["s0"].executor.spawner
    assert spawner.code(hand.shop.code("counter").digest).source.startswith("# 4")
    with pytest.raises(KeyError):
        spawner.code(first)


@pytest.mark.parametrize(
    ("error", "text"), [(KeyError("N"), "the constant N has no value"), (ValueError("too big"), "too big")]
)
def test_what_is_wrong_with_a_shape_is_said_in_words(error, text):
    assert str(shape_fault(error)) == text


# In a run


class Units:
    def __init__(self, refuses=""):
        self.sent, self.released, self._refuses = [], [], refuses

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def grant(self, rtpu, device):
        if self._refuses:
            raise ValueError(self._refuses)
        return command.DeviceGrant("bus:yard", device, ("x",), ("f",), {}, 1, 0, 64)

    def release(self, device):
        self.released.append(device)


def mass_alone(units, lost=None, seed=0):
    """A spawner that has the code of a mass, and the subsystem of it."""
    prepared = prepare(rail_tasks().plan([action("mass", "servo", arguments="1")]), (), YardLoading())
    table = Table(Segment.create("table", SIZE))
    subsystem = RunningSubsystem("flow0", table, prepared.flows[0], {"mass": "rt0", "servo": "rt1"}, {"SIDES": 2})
    spawner = Spawner(units, lost or {}, seed)
    for code in prepared.code.values():
        spawner.add_code(code)
    return spawner, subsystem


def test_a_device_that_is_not_granted_is_said_with_the_reason():  # law 16
    units = Units(refuses="yard:m0 is claimed by another")
    spawner, subsystem = mass_alone(units)
    assert str(spawner.spawn(subsystem, "mass")) == "yard:m0 is claimed by another"
    assert units.sent == []


def test_a_unit_that_is_gone_is_given_no_task_and_no_device():  # R-E10
    units = Units()
    spawner, subsystem = mass_alone(units, lost={"rt0": "rt0 was killed"})
    assert str(spawner.spawn(subsystem, "mass")) == "rt0 was killed"
    assert (units.sent, units.released) == ([], [])


def test_a_device_is_given_back_once():  # law 18
    units = Units()
    spawner, subsystem = mass_alone(units)
    assert str(spawner.spawn(subsystem, "mass")) == ""
    spawner.release("mass", subsystem.members["mass"])
    spawner.release("mass", subsystem.members["mass"])
    spawner.release("servo", subsystem.members["servo"])
    assert units.released == ["yard:m0"]


@pytest.mark.parametrize("seed", [0, 7])
def test_the_seed_of_the_run_reaches_every_task(seed):  # law 14
    units = Units()
    spawner, subsystem = mass_alone(units, seed=seed)
    assert str(spawner.spawn(subsystem, "mass")) == ""
    ((rtpu, order),) = units.sent
    assert (rtpu, order.task, order.seed) == ("rt0", "mass", seed)
