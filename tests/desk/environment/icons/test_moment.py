from functools import partial

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.initial_model import opened
from onika.desk.environment.reconcile import runtime_loss
from onika.desk.plan.preparation import prepare_run
from onika.model.lifecycle import State
from onika.store.site import open_site
from onika.wire import act, event, live, request
from onika.words.reason import NOTHING, Reason

JOINTS = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
POSE = [[1.0, 0.0, 0.0, 0.5], [0.0, -1.0, 0.0, 0.6], [0.0, 0.0, -1.0, 0.7], [0.0, 0.0, 0.0, 1.0]]


class Beginner(FakeRuntimeEnv):
    """Somebody with what is shipped and an application that moves one arm, beside a runtime without modules."""

    def __init__(self, folder):
        site = open_site([], {}, folder)
        model, _ = opened(site, None, {})
        super().__init__(folder, (), LiveRuntime(), model, site)
        self.doc = self.do(act.NewApplication(1))
        self.job = self.do(act.InsertIcon(self.doc, "jmoveC", "0", 0))
        self.runtime.variables["measuring"] = {"Q_MEZ": JOINTS, "X_MEZ": POSE}

    def wish(self, kind="Joint object", **more):
        return act.Teach(kind, doc=self.doc, after=self.job, **more)

    @property
    def left(self):
        """What lives, and what is still thought of it."""
        return [home for home, lives in self.runtime.lives.items() if lives], self.environment.model.measuring


@pytest.fixture
def me(tmp_path):
    return Beginner(tmp_path)


def test_an_arm_at_rest_is_measured_by_its_driver_which_is_gone_again(me):  # R-D23, law 4
    taught = me.do(me.wish())
    assert (taught.values, taught.arm) == ({"endpoint": tuple(JOINTS)}, "puma")
    (born,) = me.edits()
    assert ([task.name for task in born.spawn], [turn.task for turn in born.on]) == (["puma"], ["puma"])
    assert any(isinstance(wish, live.Close) for wish in me.carried_out)
    assert me.left == ([], None)


def test_what_reads_the_driver_comes_on_after_it(me):  # R-D23
    taught = me.do(me.wish("Cartesian object"))
    assert len(taught.values["pose"]) == 9
    born, more = me.edits()
    assert [[turn.task for turn in edit.on] for edit in (born, more)] == [["puma"], ["fwdkin"]]
    assert me.left == ([], None)


def test_where_the_driver_is_on_the_arm_is_read_there(me):  # R-D13, R-D23
    puma = next(task for task in prepare_run("go_home", me.site).plan.flows[0].tasks if task.name == "puma")
    me.runtime.perform("go_home", "flow0", (puma,))
    me.runtime.turn("flow0", "puma", State.ON)
    me.runtime.variables["flow0"] = {"Q_MEZ": [6.0] * 6}
    assert me.do(me.wish()).values == {"endpoint": (6.0,) * 6}
    assert me.edits() == []


def test_a_name_that_is_taken_is_not_used(me):
    me.do(me.wish())
    me.runtime.lives["measuring"] = me.runtime.lives.pop("measuring", {})
    me.runtime.variables["measuring-2"] = {"Q_MEZ": JOINTS}
    me.do(me.wish())
    assert [edit.subsystem for edit in me.edits()] == ["measuring", "measuring-2"]


@pytest.mark.parametrize("kind", [live.Change, live.Read])
def test_what_a_runtime_refuses_is_told_and_nothing_is_left(me, kind):  # R-X01
    me.rebuffs = {kind: request.Refused(Reason.plain("not now"))}
    assert str(me.answer(me.wish()).no.reason) == "not now"
    assert me.left == ([], None)


def test_while_all_is_stopped_the_way_out_is_offered(me):  # R-X01, law 27
    me.do(me.wish())
    me.runtime.is_stopped = True
    me.tell(event.Stopped(True, NOTHING))
    no = me.answer(me.wish()).no
    assert "stopped" in str(no.reason) and no.remedies[0].act == act.Reset()
    assert me.left == ([], None)


def test_two_do_not_measure_at_once(me):
    answers = []
    me.rebuffs = {live.Change: live.Accepted(99)}
    for _ in range(2):
        me.environment.do(me.wish(), "me", answers.append)
        me.pump()
    assert [str(answer.no.reason) for answer in answers] == ["where an arm stands is being measured already"]
    me.environment.become(partial(runtime_loss.lost, reason=Reason.plain("it is gone")))
    me.pump()
    assert len(answers) == 2 and answers[1].no is not None and me.environment.model.measuring is None


def test_where_another_type_will_do_the_first_that_is_measured_is_taken(me):  # R-D23
    assert me.do(me.wish("Pause object", or_another=True)).type == "Joint object"
    assert "typed in" in str(me.answer(me.wish("Pause object")).no.reason)
