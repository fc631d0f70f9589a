"""What a page is told of applications and runs, in Spanish too."""

from functools import partial

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import HOLE, job
from onika.desk.environment.outcome.fault_text import said
from onika.desk.environment.reconcile.runtime_loss import lost
from onika.desk.environment.runs.readiness import ReadinessJudge, judged
from onika.wire import act
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason, in_language


def is_known(text):
    return isinstance(text, Reason) and in_language(text, "es") != str(text)


def test_what_is_unknown_is_not_taken_for_known():
    assert not is_known("a sentence that nobody has said") and not is_known(Reason.plain("neither this one"))


def test_what_another_did_and_is_taken_back():  # R-X10
    assert is_known(Reason.of("run.undone_elsewhere", label="inserting a", name="play"))
    assert is_known(Reason.of("run.redone_elsewhere", label="inserting a", name="play"))


FLOW = Reason.of("rules.flow", number=2)
AT = Reason.of("rules.at", step=Reason.of("rules.icon", name="a"), position=3, flow=FLOW)
ICONS = [Reason.of("rules.icon_of_kind", name=name, kind="Number job") for name in "ab"]
MEETING = Reason.of("rules.waits_at", tag="A", place="play:7", action="putC", other="flow0")
WAIT = Reason.of("rules.flow_waits", flow="flow1", wait=MEETING)


@pytest.mark.parametrize(
    "reason",
    [
        Reason.of("rules.flow_empty", flow=FLOW),
        Reason.of("rules.edges_unfit", left=ICONS[0], right=ICONS[1], position=1, flow=FLOW),
        Reason.of("host.unreachable", target="p", why="joint 3 at 9.00 rad is beyond 3.93"),
        Reason.of("host.posture_missing", task="scara", old="puma", target="home", why="the hand leans"),
        Reason.of("host.no_such_device", world="boxes", devices=("arm",), device="boxes:bulb"),
        Reason.of("host.device_unlike", task="puma", device="b:x", why="expected y, found z"),
        Reason.of("host.device_claimed", device="b:arm", other="puma"),
        Reason.of("runtime.constant_missing", svar="NDOF"),
        Reason.of(
            "desk.substitute_unfit", old="a", reason=Reason.of("rules.outputs_lacking", new="b", svars=("X",), old="a")
        ),
        Reason.of("host.values_unfit", task="jtraj", target="home", why="expected 7 values, found 5"),
        Reason.of("rules.target_missing", kind="Joint object", at=AT),
        Reason.of("rules.configuration_missing", name="aC", at=AT),
        Reason.of("rules.tags_as_often", wait=WAIT),
        Reason.of("rules.loop_tag_count", tag="l", flow=FLOW, count=1, at=AT),
    ],
    ids=lambda reason: reason.key,
)
def test_what_is_wrong_with_an_application(reason):  # R-X01
    assert is_known(said(Fault(Place("play.appl", 3), reason, NOT_RUN)))


def test_what_is_judged_and_what_can_be_done(tmp_path):  # R-X01, R-E01
    play = RunFixture(tmp_path)
    judge, doc = ReadinessJudge(play.site), play.open([job("aC"), HOLE, job("newC")], [])
    for case in judge.cases(play.environment.model):
        play.environment.become(partial(judged, doc=case.opened.id, judgement=judge.judge(case)))
    faults = list(play.environment.tree.applications[doc].faults.values())
    assert len(faults) > 2
    assert all(is_known(fault.text) and all(is_known(remedy.label) for remedy in fault.remedies) for fault in faults)


def test_how_a_run_begins_and_ends(tmp_path):  # R-E10, R-E14
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC")]))
    play.environment.become(lambda model: lost(model, Reason.plain("the runtime is gone: it ended")))
    assert len(play.says) > 2 and all(is_known(say.text) for say in play.says)
    assert is_known(play.no(act.Steer("abort")).reason)
