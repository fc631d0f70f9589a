import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, event, request, steer
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_a_line_of_steering_is_carried_out_and_what_comes_of_it_is_asked(play):  # R-E07
    play.run(play.open([job("aC"), job("bC")]))
    play.runtime.positions = (steer.Position("flow0", "running", 0, is_pausing=True),)
    play.do(act.Steer("pause"))
    assert play.carried(steer.Pause) == [steer.Pause("flow0")]
    assert play.view.flows["flow0"].is_pausing
    play.moved("paused")
    assert not play.view.flows["flow0"].is_pausing


def test_a_line_that_means_nothing_is_refused_in_its_words(play):  # R-X01
    assert str(play.no(act.Steer("pause")).reason) == "nothing runs"
    play.run(play.open([job("aC")]))
    assert "expected one of pause" in str(play.no(act.Steer("dance")).reason)
    assert "for scripts" in str(play.no(act.Steer("wait 3")).reason)
    play.rebuffs = {steer.Recover: request.Refused(Reason.plain("flow0 has not stopped"))}
    assert str(play.answer(act.Steer("clear")).no.reason) == "flow0 has not stopped"


def test_to_go_on_is_for_whoever_pauses_also_in_what_is_nested(play):  # R-E07
    play.files.application("both", [job("aC")], [job("bC")], parallel=True)
    play.run(play.open([job("both", "Complete application"), job("cC")]))
    for line in ("continue", "continue 0"):
        play.do(act.Steer(line))
    assert play.carried(steer.Resume) == [steer.Resume(""), steer.Resume("flow0")]


def test_where_nothing_pauses_it_is_told_what_lets_flows_go_on(play):  # R-E07, R-X01
    play.run(play.open([job("aC")], [job("bC")], parallel=True))
    play.rebuffs = {steer.Resume: request.Refused(Reason.plain("expected flow 0 paused, found running"))}
    assert str(play.answer(act.Steer("continue")).no.reason) == "expected flow 0 paused, found running"
    play.moved("stopped")
    play.moved("waiting", flow="flow1", tag="play meet")
    no = play.answer(act.Steer("continue")).no
    assert str(no.reason) == "nothing pauses: flow0 stands at an error; flow1 waits at meet for flow0"
    assert [remedy.act.line for remedy in no.remedies] == ["clear flow0", "pass flow1"]
    assert [remedy.act.line for remedy in play.answer(act.Steer("continue 1")).no.remedies] == ["pass flow1"]


def test_who_is_a_line_too(play):  # R-X03
    play.run(play.open([job("aC")]))
    play.runtime.positions = (steer.Position("flow0", "running", 0, loops=("round",)),)
    play.do(act.Steer("who"))
    assert play.view.flows["flow0"].loops == ("round",)
    play.rebuffs = {steer.Who: request.Refused(Reason.plain("not now"))}
    assert str(play.answer(act.Steer("who")).no.reason) == "not now"


def test_a_flow_is_sent_to_a_step_or_to_the_first_action_in_it(play):  # R-E13
    play.files.application("inner", [job("aC"), job("bC")])
    inner = job("inner", "Complete application")
    branch = ["BRANCH\nFLOW\n", job("cC"), "ENDFLOW\nFLOW\n", job("aC"), "ENDFLOW\nENDBRANCH\n"]
    path = play.files.application("play", [job("cC"), inner, *branch], [job("bC")], parallel=True)
    path.write_text(path.read_text().replace("VERSION     1.3", "VERSION     2.0"))
    doc = play.do(act.Open(str(path)))
    view = play.run(doc)
    assert set(view.flows) == {"flow0", "flow1"}
    numbers = sorted(map(int, play.environment.tree.applications[doc].steps))
    assert len(numbers) == 6
    steps = play.environment.tree.applications[doc].flows["0"].steps
    beside = play.environment.tree.applications[doc].flows["1"].steps
    for step, subsystem, action in ((steps[1], "flow0", 1), (steps[2], "flow0", 3), (beside[0], "flow1", 0)):
        play.do(act.SkipTo(step))
        assert play.carried(steer.Skip)[-1] == steer.Skip(subsystem, action)
    assert "begun without it" in str(play.no(act.SkipTo(99)).reason)


def test_a_question_of_the_run_is_answered(play):  # R-E15
    doc = play.open([job("aC")])
    play.run(doc)
    assert str(play.no(act.Answer(doc, "flow0/a", "3")).reason) == "flow0/a asks for nothing"
    play.tell(event.Asked("flow0", "a", NOTHING, (), 1.0))
    play.rebuffs = {request.Reply: request.Done()}
    play.do(act.Answer(doc, "flow0/a", "3 4"))
    assert play.carried(request.Reply) == [request.Reply("flow0", "a", "3 4")]


def test_a_question_of_a_configuration_is_answered_as_before(play):  # R-C13
    assert "no longer open" in str(play.no(act.Answer("c9", "a", "3")).reason)


def test_a_run_is_put_away_when_it_is_over(play):
    doc = play.open([job("aC")])
    play.run(doc)
    assert play.no(act.Dismiss()).remedies[0].act == act.Steer("abort", doc)
    play.end()
    play.do(act.Dismiss())
    assert play.environment.tree.run is None
    play.do(act.Dismiss())
