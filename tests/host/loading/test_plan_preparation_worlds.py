"""Worlds that come as files with a plan: they are known before devices are asked for, and what is wrong is told."""

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.rail_world import YardLoading
from onika.host.loading.plan_preparation import inspect, prepare
from onika.wire.request import TargetValues
from onika.wire.world_source import WorldFile, WorldSource, digest_of
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

HAND = """
from onika.module import Module, OutVar

class Hand(Module):
    hardware = True
    GRIP = OutVar("double", "N", "how it grips")
"""
BELL = """
from onika.module import Module, finish

class Bell(Module):
    trigger = True

    def cycle(self):
        return finish()
"""
EYE = """
from onika.module import Local, Module, OutConst, OutVar

class Eye(Module):
    WIDE = OutConst("int", "-", "how many it sees")
    SEEN = OutVar("byte[WIDE]", "-", "what it sees")

    @classmethod
    def constants(cls, local, identity):
        return {"WIDE": 3}
"""
SHELF = """
from onika.module import Module, OutConst

class Shelf(Module):
    WIDE = OutConst("int", "-", "how wide it is")

    @classmethod
    def constants(cls, local, identity):
        return {"WIDE": 4}
"""
FILES = (WorldFile("world/yard.world", "/lab/world/yard.world", b"VERSION 2.0\nEOF\n"),)
YARD = WorldSource("yard", digest_of(FILES), FILES)
WRONG = Fault(Place("yard.world", 3), Reason.plain("no such mesh"), Reason.plain("it is left out"))


class Loading(YardLoading):
    """Worlds are known by their files, one of which is wrong, once they were offered."""

    def __init__(self):
        super().__init__()
        self.offered = []
        self.resolved = []

    def offer(self, worlds):
        self.offered += [files.world for files in worlds]

    def world_faults(self, world):
        return (WRONG,) if world in self.offered else ()

    def resolve(self, code, constants, targets):
        self.resolved.append(code.module)
        return [None] * len(targets)

    def company(self, _world, _devices, *, is_of_flow=False):
        return ()

    def is_simulated(self, _world):
        return True


def plan_with(device):
    shop = PlanBuilder()
    shop.task("hand", HAND, local={"DEVICE": device}, frequency=500.0)
    shop.task("bell", BELL)
    return replace(shop.plan([action("hand", "bell")]), worlds=(YARD,))


def test_what_is_wrong_with_a_world_is_worth_knowing_where_every_device_is_there():  # R-X19
    preparation = prepare(plan_with("yard:m0"), (), Loading())
    assert preparation.faults == []
    assert WRONG.sentence in preparation.notes


def test_where_a_device_is_nowhere_it_is_a_fault_beside_that():  # R-X19
    preparation = prepare(plan_with("yard:m7"), (), Loading())
    assert WRONG in preparation.faults
    assert len(preparation.faults) == 2
    assert WRONG.sentence not in preparation.notes


def left_out(file, key, **args):
    return Fault(Place(file, 3), Reason.plain("no such joint"), Reason.of(key, **args))


class Wrong(Loading):
    """Its world has these faults."""

    def __init__(self, *faults):
        super().__init__()
        self.faults = faults

    def world_faults(self, world):
        return self.faults


@pytest.mark.parametrize(
    ("fault", "is_cause"),
    [
        (left_out("arm.xml", "workcell.robot_left_out", name="arm"), True),
        (left_out("arm.robot", "workcell.device_left_out", name="arm"), True),
        (left_out("yard.world", "workcell.place_left_out"), True),
        (left_out("yard.world", "workcell.device_left_out", name="m7"), True),
        (left_out("yard.world", "workcell.device_left_out", name="lamp"), False),
        (left_out("yard.world", "workcell.part_left_out", part="cube"), False),
    ],
)
def test_a_device_is_nowhere_because_of_what_its_world_leaves_out_for_it(fault, is_cause):  # R-B07, R-X19
    absent = next(each for each in prepare(plan_with("yard:m7"), (), Wrong(fault)).faults if each != fault)
    assert absent.reason.key == "host.no_such_device"
    assert absent.because == ((fault.place,) if is_cause else ())


@pytest.mark.parametrize("code", ["class Bad(:\n", None])
def test_who_looks_at_files_alone_is_told_of_all_that_is_wrong(code):  # R-X19
    shop = PlanBuilder()
    shop.task("bad", code or BELL)
    loading = Loading()
    faults, _ = inspect((), (shop.code("bad"),), loading, (YARD,))
    assert loading.offered == ["yard"]
    assert WRONG in faults
    assert len(faults) == (1 if code is None else 2)


def test_what_a_device_gives_the_shapes_of_is_asked_for_though_it_is_no_robot():  # R-F05, law 26
    shop = PlanBuilder()
    shop.task("eye", EYE, local={"DEVICE": "yard:scale"})
    shop.task("bell", BELL)
    loading = Loading()
    preparation = prepare(shop.plan([action("eye", "bell")]), (TargetValues(0, 0, "joint object", (1.0,)),), loading)
    assert preparation.constants == {0: {"WIDE": 3}}
    assert loading.resolved == []


def test_one_that_needs_no_shapes_is_not_asked_before_it_lives():  # law 26
    shop = PlanBuilder()
    shop.task("shelf", SHELF)
    shop.task("bell", BELL)
    assert prepare(shop.plan([action("shelf", "bell")]), (), Loading()).constants == {0: {}}
