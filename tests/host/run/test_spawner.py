import pytest

from kit.plan_builder import action
from kit.rail_world import YardLoading, rail_tasks
from onika.host.loading.plan_preparation import prepare
from onika.host.run.spawner import Births
from onika.model.lifecycle import State
from onika.ring.segment import Segment
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table


class Units:
    def __init__(self, refuses=""):
        self.sent, self.released, self._refuses = [], [], refuses

    def send(self, rtpu, order):
        self.sent.append((rtpu, order.task))

    def grant(self, rtpu, device):
        if self._refuses:
            raise ValueError(self._refuses)
        return command.DeviceGrant("bus:yard", device, ("x",), ("f",), {}, 1, 0, 64)

    def release(self, device):
        self.released.append(device)


class Ward:
    def __init__(self, refuses=""):
        prepared = prepare(rail_tasks().plan([action("mass", "servo", arguments="1")]), (), YardLoading())
        table = Table(Segment.create("table", SIZE))
        self.subsystem = RunningSubsystem(
            "flow0", table, prepared.flows[0], {"mass": "rt0", "servo": "rt1"}, {"SIDES": 2}
        )
        self.units = Units(refuses)
        self.refused = []
        self.births = Births({0: self.subsystem}, prepared.code, self.units, 0, lambda *what: self.refused.append(what))
        for task in ("servo", "mass"):
            self.births.expect(0, task)
        self.births.go_on()

    def supply(self):
        self.subsystem.table.ring("SIDES").write((2).to_bytes(4, "little"))
        self.births.go_on()


def test_whoever_needs_a_constant_is_born_after_its_supplier():  # law 10
    ward = Ward()
    assert ward.units.sent == [("rt0", "mass")]
    ward.supply()
    assert ward.units.sent == [("rt0", "mass"), ("rt1", "servo")]
    assert ward.subsystem.members["mass"].is_sent


def test_nobody_is_born_twice():
    ward = Ward()
    ward.supply()
    ward.supply()
    assert len(ward.units.sent) == 2


def test_who_is_not_wanted_any_more_is_not_born():  # R-E14
    ward = Ward()
    ward.births.forget(0, "servo")
    ward.births.forget(0, "servo")
    ward.supply()
    assert ward.units.sent == [("rt0", "mass")]


def test_a_device_that_is_not_granted_is_told_with_the_reason():  # law 16
    ward = Ward(refuses="yard:m0 is claimed by another")
    assert ward.refused == [(0, "mass", "yard:m0 is claimed by another")]
    assert not ward.subsystem.members["mass"].is_sent


def test_a_device_is_given_back_once():  # law 18
    ward = Ward()
    member = ward.subsystem.members["mass"]
    assert member.state is State.WAITING
    ward.births.release(member)
    ward.births.release(member)
    ward.births.release(ward.subsystem.members["servo"])
    assert ward.units.released == ["yard:m0"]


@pytest.mark.parametrize("seed", [0, 7])
def test_the_seed_of_the_run_reaches_every_task(seed):  # law 14
    ward = Ward()
    sent = []
    births = Births({0: ward.subsystem}, ward.births._code, ward.units, seed, lambda *_: None)
    ward.units.send = lambda _rtpu, order: sent.append(order.seed)
    births.expect(0, "mass")
    births.go_on()
    assert sent == [seed]
