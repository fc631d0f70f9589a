import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import HOLE, job, joints
from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.runs.readiness import ReadinessCase, ReadinessJudge
from onika.model.application import Application
from onika.model.syntax import Syntax
from onika.wire import act
from onika.wire.view import ShowFits, ShowLoop, ShowStep, ShowTarget
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason

TAG = "SYNCHTAG    meet"


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def faults_of(play, *flows, **words):
    doc = play.open(*flows, **words)
    model = play.environment.model
    return ReadinessJudge(play.site).judge(ReadinessCase(model.applications[doc], model.syntax, ())).faults


def the(views, word):
    (match,) = [view for view in views if word in str(view.text)]
    return match


def test_nothing_is_wrong_with_what_can_run(play):  # R-E01
    assert faults_of(play, [job("aC"), job("bC")]) == ()


def test_a_hole_says_what_is_missing_and_what_fits(play):  # R-E01, R-D03
    views = faults_of(play, [job("aC"), HOLE, job("bC")])
    (hole,) = views
    assert (str(hole.text), hole.level, hole.remedies[0].show) == (
        "an action is missing here",
        "fault",
        ShowFits("0", 1),
    )


def test_a_hole_for_a_target_offers_to_make_one(play):  # R-E01, R-D08
    hole = the(faults_of(play, [job("bC"), job("aC", "Joint job"), HOLE]), "is missing here")
    assert (str(hole.text), hole.step) == ("a Joint target is missing here", 3)
    assert [remedy.show for remedy in hole.remedies] == [ShowFits("0", 2), ShowTarget("Joint object")]


def test_what_is_not_there_is_named_without_file_and_line(play):  # R-E01, R-X01
    gone = the(faults_of(play, [job("aC"), job("goneC")]), "goneC")
    assert (str(gone.text), gone.step) == ("there is no configuration goneC", 2)
    assert gone.remedies[0].act == act.RemoveIcons("a1", (2,)) and gone.remedies[-1].show == ShowStep(2)


def test_a_loop_that_is_none_can_be_taken_away(play):  # R-E05
    loop = the(faults_of(play, [job("aC", "Complete job", "WHILETAG    round", "WHILETEST   yes")]), "the loop")
    assert loop.remedies[0].act == act.RemoveLoop("a1", 1) and loop.remedies[1].show == ShowLoop(1)


def test_a_tag_that_nobody_meets_can_be_taken_away(play):  # R-E04, R-X03
    tag = the(faults_of(play, [job("aC", "Complete job", TAG)], [job("bC")], parallel=True), "tag meet")
    assert tag.remedies[0].act == act.SetSynchTag("a1", 1)


def test_a_deadlock_is_told_before_the_run(play):  # R-X03
    def met(name, tag):
        return job(name, "Complete job", f"SYNCHTAG    {tag}")

    flows = ([met("aC", "one"), met("bC", "two")], [met("bC", "two"), met("cC", "one")])
    views = faults_of(play, *flows, parallel=True)
    assert any(str(view.text).endswith("neither comes") and view.step for view in views)


def test_a_task_that_is_at_fault_leads_to_the_first_step_that_uses_it(play):  # R-E01
    play.files.configuration("bC", "b 100", "nobody 100")
    play.files.task("a", "MODULE a\nDESC")
    views = faults_of(play, [job("cC"), job("bC"), job("aC")])
    assert the(views, "nobody").step == 2
    assert {view.step for view in views if str(view.text) != str(the(views, "nobody").text)} == {3}


def test_what_is_wrong_inside_leads_to_the_icon_that_runs_it(play):  # R-E06
    play.files.application("inner", [job("aC"), job("goneC")])
    views = faults_of(play, [job("bC"), job("inner", "Complete application")])
    assert the(views, "goneC").step == 2


def test_an_icon_of_another_type_than_its_trigger_says_is_taken_anew(play):  # reading 36
    text = "MODULE a\nDESC a\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR A\nTASKTYPE periodic\nFREQ 10\n\nONIKA\n"
    play.files.task("a", f"{text}OBJECT Joint job")
    wrong = the(faults_of(play, [job("aC")]), "its trigger")
    assert wrong.remedies[0].act == act.ExchangeIcon("a1", 1, "aC")


def test_what_follows_from_a_fault_goes_with_it_and_a_file_of_a_workcell_is_named():  # R-B07, R-E01
    model = Place("/lab/robot/arm.xml", 11)
    faults = [
        Fault(Place("/lab/module/m.rmod"), Reason.plain("no device"), NOT_RUN, because=(model,)),
        Fault(model, Reason.plain("no joint"), Reason.plain("the robot is left out")),
        Fault(Place("/lab/world/hall.world", 8), Reason.plain("no robot"), Reason.plain("left out"), because=(model,)),
    ]
    troubles = FaultViews("doc", Application("go", False, ()), Syntax((), {}), Place("go"), None)
    (view,) = troubles.told(faults, is_of_runtime=True)
    assert str(view.text) == "arm.xml:11: no joint; the robot is left out"
    assert [str(reason) for reason in view.follows] == ["no device", "hall.world:8: no robot; left out"]


def test_notes_are_warnings(play):  # R-E01
    note = the(faults_of(play, [job("aC", "Complete job", TAG)]), "tag")
    assert note.level == "warning"


def test_a_stray_target_can_be_removed(play):
    stray = the(faults_of(play, [job("aC"), HOLE, joints("home", *[0.0] * 6)]), "no action before")
    assert stray.remedies[0].act == act.RemoveIcons("a1", (3,))
