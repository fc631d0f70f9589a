import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.initial_model import opened
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.pose_solution import solve
from onika.store.site import open_site
from onika.wire import act, live, request
from onika.words.reason import Reason

BETWEEN = (0.6, 0.2, 0.25)
"""Where both arms come to."""
DOWN = (0.0, 0.0, -1.0)


class Solver(LiveRuntime):
    """A runtime that asks the modules of arms, as the real one does."""

    def ask(self, wish):
        self.asked.append(wish)
        if isinstance(wish, live.Solve):
            return solve(wish, ModuleFacts())
        return super().ask(wish)


class Beginner(FakeRuntimeEnv):
    """Somebody with what is shipped and an application that moves both arms."""

    def __init__(self, folder):
        site = open_site([], {}, folder)
        model, _ = opened(site, None, {})
        super().__init__(folder, (), Solver(), model, site)
        self.doc = self.do(act.NewApplication(1))
        self.right = self.do(act.InsertIcon(self.doc, "cmove_rightC", "0", 0))
        self.left = self.do(act.InsertIcon(self.doc, "cmoveC", "0", 0))

    def wish(self, kind="Cartesian object", position=BETWEEN, approach=DOWN, world="boxes", **more):
        return act.PointAt(kind, world, position, approach, **{"doc": self.doc, "after": self.left} | more)


@pytest.fixture
def me(tmp_path):
    return Beginner(tmp_path)


def test_a_place_becomes_a_pose_that_points_there_and_the_joints_that_reach_it(me):  # R-D25
    pointed = me.do(me.wish())
    pose = pointed.values["pose"]
    assert pose[:3] == DOWN and pose[6:] == BETWEEN
    assert (pointed.type, pointed.arm, pointed.device) == ("Cartesian object", "puma", "boxes:arm_left")
    assert pointed.arms == ("puma", "puma_right") and len(pointed.joints) == 6
    assert pointed.made_for == ""  # a pose is one for any arm
    assert str(pointed.source) == "the place that was clicked, as puma reaches it"
    assert not me.edits()  # nothing lives for it


def test_a_target_of_joints_takes_the_joints_of_the_place(me):  # R-D25
    pointed = me.do(me.wish("Joint object"))
    assert pointed.values == {"endpoint": pointed.joints}
    assert pointed.made_for == "puma"


def test_the_arm_that_is_named_is_asked(me):  # R-D25
    left, right = me.do(me.wish()), me.do(me.wish(arm="puma_right"))
    assert right.device == "boxes:arm_right" and right.joints != left.joints
    assert right.values["pose"][6:] == left.values["pose"][6:]


def test_how_the_tool_is_turned_about_its_approach_is_as_wished_where_the_arm_reaches_it_so(me):  # R-D25
    pointed = me.do(me.wish(normal=(0.0, 1.0, 0.0)))
    assert pointed.values["pose"][3:6] == pytest.approx((0.0, 1.0, 0.0))


def test_what_the_arm_does_not_reach_is_told_with_the_arm(me):  # R-D25, R-X01
    no = me.answer(me.wish(position=(3.0, 0.0, 0.2))).no
    assert str(no.reason).startswith("puma does not reach this place from this side: ")


def test_where_no_arm_of_the_program_stands_a_pose_is_taken_unjudged_and_joints_are_none(me):  # R-D25
    for elsewhere in ({"world": "yard"}, {"doc": ""}):
        pointed = me.do(me.wish(**elsewhere))
        assert pointed.values["pose"][:3] == DOWN and pointed.joints == () and "nobody says" in str(pointed.source)
        assert "expected an arm" in str(me.answer(me.wish("Joint object", **elsewhere)).no.reason)


def test_what_says_no_place_takes_none(me):  # R-D25
    assert "does not say where an arm goes" in str(me.answer(me.wish("Pause object")).no.reason)
    assert "does not say where an arm goes" in str(me.answer(me.wish("nonsense")).no.reason)
    assert "no length" in str(me.answer(me.wish(approach=(0.0, 0.0, 0.0))).no.reason)


def test_what_a_runtime_refuses_is_told(me):  # R-X01
    me.rebuffs = {live.Solve: request.Refused(Reason.plain("not now"))}
    assert str(me.answer(me.wish()).no.reason) == "not now"
