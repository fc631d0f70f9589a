import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.loading.target_resolution import JOINT
from onika.wire.request import TargetValues

ROBOT = """
from onika.module import InVar, Local, Module, OutConst, OutVar

class Robot(Module):
    '''A rail: joint 1 is `SCALE` times as far as its tool.'''
    hardware = True
    NDOF = OutConst("int", "-", "number of joints")
    Q_REF = InVar("double[NDOF]", "m", "where to")
    Q_MEZ = OutVar("double[NDOF]", "m", "where it is")
    SCALE = Local("double", "-", "of its joint", default=1.0)
    JOINTS = Local("int", "-", "how many", default=1)

    @classmethod
    def constants(cls, local, identity):
        return {"NDOF": local.JOINTS, "SCALE": local.SCALE}

    @classmethod
    def resolve(cls, constants, targets):
        return [None if abs(values[0]) <= 10.0 else "beyond" for _, values in targets]

    @classmethod
    def poses(cls, constants, targets):
        return [[values[0] / constants["SCALE"]] for values in targets]

    @classmethod
    def postures(cls, constants, poses):
        found = [nine[0] * constants["SCALE"] for nine in poses]
        return [[one] * constants["NDOF"] if abs(one) <= 10.0 else f"{one:g} is beyond" for one in found]
"""
MOVE = """
from onika.module import InConst, Input, InVar, Module, OutVar, finish

class Move(Module):
    trigger = True
    NDOF = InConst("int", "-", "number of joints")
    Q_MEZ = InVar("double[NDOF]", "m", "where it is")
    Q_REF = OutVar("double[NDOF]", "m", "where to")
    end = Input("double[NDOF]", "m", "where to")
    duration = Input("double", "s", "how long")

    def cycle(self):
        return finish()
"""
MUTE = ROBOT.replace("def poses", "def gestures").replace("def postures", "def attitudes")


class Shop:
    """Two robots, and plans in which the second one stands for the first."""

    def __init__(self, old=ROBOT, new=ROBOT, **local):
        self.shop = PlanBuilder()
        self.old = self.shop.task("old", old, local={"DEVICE": "w:a", "JOINTS": "1"})
        self.shop.task("new", new, module="another", local={"DEVICE": "w:b", **local})
        self.shop.task("move", MOVE)

    def prepared(self, *places, replaced=True, knows_old=True):
        actions = [action("new", "move", arguments=f"{place} 1.5") for place in places]
        plan = self.shop.plan(actions)
        old = self.old if knows_old else replace(self.old, digest="")
        flow = replace(plan.flows[0], replaced=(("new", old),) if replaced else ())
        plan = replace(plan, flows=(flow,), code=tuple({*plan.code, self.shop.code("old")}))
        targets = [TargetValues(0, at, JOINT, (place, 1.5), f"t{at}") for at, place in enumerate(places)]
        return prepare(plan, targets, Loading())


class Loading(ModuleFacts):
    """Knows the devices of the shop."""

    def devices(self, world):
        return ("a", "b")


def lines(preparation):
    return [planned.arguments for planned in preparation.plan.flows[0].actions]


def test_a_joint_target_becomes_the_posture_that_brings_the_other_robot_to_its_pose():  # law 26, R-E09
    preparation = Shop(SCALE="2", JOINTS="2").prepared(1.0, 4.0)
    assert preparation.faults == []
    assert lines(preparation) == ["2.0 2.0 1.5", "8.0 8.0 1.5"]
    assert [
        (resolved.flow, resolved.action, resolved.target, resolved.task, resolved.instead_of)
        for resolved in preparation.resolved
    ] == [
        (0, 0, "t0", "new", "old"),
        (0, 1, "t1", "new", "old"),
    ]
    assert (preparation.resolved[0].were, preparation.resolved[0].values) == ((1.0, 1.5), (2.0, 2.0, 1.5))


def test_what_both_robots_take_in_the_same_way_stays_as_it_is():  # law 26
    preparation = Shop(MODE="other").prepared(1.0)
    assert (preparation.faults, preparation.resolved, lines(preparation)) == ([], [], ["1.0 1.5"])
    again = Shop(new=ROBOT.replace('"SCALE": local.SCALE}', '"SCALE": local.SCALE, "HOME": 3}')).prepared(1.0)
    assert (again.faults, again.resolved, lines(again)) == ([], [], ["1.0 1.5"])


def test_a_target_that_the_other_robot_cannot_take_is_told_with_its_place_and_no_other():  # law 26, R-X02
    preparation = Shop(SCALE="2").prepared(1.0, 6.0, 2.0)
    (fault,) = preparation.faults
    assert (str(fault.place), str(fault.reason)) == (
        "test.appl:2",
        "expected a posture of new where old would be, found t1: 12 is beyond",
    )
    assert str(fault.where) == "flow0, action 2: action 1"
    assert [resolved.target for resolved in preparation.resolved] == ["t0", "t2"]


def test_a_plan_that_is_not_redirected_is_left_alone():  # law 26
    preparation = Shop(SCALE="2").prepared(1.0, replaced=False)
    assert (preparation.faults, preparation.resolved, lines(preparation)) == ([], [], ["1.0 1.5"])


@pytest.mark.parametrize(
    ("shop", "knows_old", "key"),
    [
        (Shop(old=MUTE, SCALE="2"), True, "host.poses_unknown"),
        (Shop(new=MUTE, SCALE="2"), True, "host.postures_unknown"),
        (Shop(SCALE="2"), False, "host.robot_unknown"),
    ],
    ids=["the old one knows no poses", "the new one knows no poses", "the old one has no code"],
)
def test_where_nobody_knows_the_pose_every_joint_target_is_refused(shop, knows_old, key):  # law 26, R-X02
    preparation = shop.prepared(1.0, 2.0, knows_old=knows_old)
    assert [(fault.reason.key, fault.reason.args["target"]) for fault in preparation.faults] == [
        (key, "t0"),
        (key, "t1"),
    ]


@pytest.mark.parametrize("name", ["poses", "postures"])
def test_a_module_that_breaks_at_the_question_is_named(name):  # law 21
    broken = ROBOT.replace(f"def {name}(cls, constants, ", f"def {name}(cls, ")
    faults = Shop(new=broken, SCALE="2").prepared(1.0).faults
    assert "another.py" in {fault.place.file for fault in faults}


def test_a_target_is_told_once_however_often_it_is_used():  # law 26
    preparation = Shop(SCALE="2").prepared(1.0)
    (note,) = preparation.notes
    assert str(note) == "test.appl:1: t0 is re-resolved for new, by the pose that it is for old: 2 1.5"
