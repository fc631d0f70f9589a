import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.runs.readiness import ReadinessJudge, judged
from onika.wire import act, request
from onika.wire.view import RedirectView


@pytest.fixture
def play(tmp_path):
    play = RunFixture(tmp_path)
    play.files.module("twin", '"""Another way to do it."""\n')
    play.files.plain_task("twin", writes="A MORE")
    return play


def tasks(play):
    return [[task.name for task in flow.tasks] for flow in play.carried(request.Prepare)[-1].plan.flows]


def shown(play, doc):
    return play.environment.tree.applications[doc].redirects


def test_a_redirected_application_runs_with_the_other_task_and_is_not_changed(play):  # R-E09
    doc = play.open([job("aC"), job("bC")])
    play.do(act.Redirect(doc, "", "a", "twin"))
    assert shown(play, doc) == (RedirectView("a", "twin"),)
    assert not play.environment.tree.applications[doc].is_dirty
    play.run(doc)
    assert tasks(play) == [["twin", "b"]]
    play.end()
    play.do(act.Redirect(doc, "", "a", ""))
    assert shown(play, doc) == ()
    play.run(doc)
    assert tasks(play) == [["a", "b"]]


def test_each_flow_has_its_own_and_the_last_word_counts(play):  # R-E09
    doc = play.open([job("aC")], [job("aC")], parallel=True)
    play.do(act.Redirect(doc, "flow1", "a", "twin"))
    play.do(act.Redirect(doc, "flow1", "a", "twin"))
    assert shown(play, doc) == (RedirectView("a", "twin", "flow1", ("flow1",)),)
    play.run(doc)
    assert tasks(play) == [["a"], ["twin"]]


def test_who_cannot_stand_there_is_refused_with_all_reasons(play):  # R-E09
    doc = play.open([job("aC")])
    assert "`b` does not write A" in str(play.no(act.Redirect(doc, "", "a", "b")).reason)
    assert "found" not in str(play.no(act.Redirect(doc, "", "a", "nobody")).reason)
    assert str(play.no(act.Redirect(doc, "flow7", "a", "twin")).reason).endswith("flow7")
    assert shown(play, doc) == ()


def test_nobody_is_replaced_while_it_runs(play):  # R-D18
    doc = play.open([job("aC")])
    play.run(doc)
    assert "is running" in str(play.no(act.Redirect(doc, "", "a", "twin")).reason)


def test_who_could_stand_there_is_told_for_every_task_of_every_flow(play):  # R-E09
    doc = play.open([job("aC")], [job("bC")], parallel=True)
    play.do(act.Redirect(doc, "flow0", "a", "twin"))
    flows = play.do(act.Seats(doc)).flows
    assert list(flows) == ["", "flow0", "flow1"]
    (seat,) = flows["flow0"]
    assert (seat.task, seat.taken_by) == ("a", "twin")
    (candidate,) = seat.candidates
    assert (candidate.name, candidate.more, candidate.reasons) == ("twin", ("MORE",), ())


def test_what_holds_for_all_flows_is_told_of_them_together(play):  # R-E09
    doc = play.open([job("aC")], [job("aC"), job("bC")], parallel=True)
    play.do(act.Redirect(doc, "flow0", "a", "twin"))
    a, b = play.do(act.Seats(doc)).flows[""]
    assert (a.task, a.taken_by, a.is_hardware) == ("a", "", True)
    assert (b.task, b.taken_by, b.is_hardware) == ("b", "b", False)
    assert [candidate.name for candidate in a.candidates] == ["twin"]
    play.do(act.Redirect(doc, "", "a", "twin"))
    assert [flow.taken_by for flow in play.do(act.Seats(doc)).flows[""]] == ["twin", "b"]


def test_a_wish_for_one_flow_leaves_the_others_as_they_are_and_one_for_all_ends_it(play):  # R-E09
    doc = play.open([job("aC")], [job("aC")], [job("bC")], parallel=True)
    play.do(act.Redirect(doc, "", "a", "twin"))
    play.do(act.Redirect(doc, "flow0", "a", ""))
    assert shown(play, doc) == (RedirectView("a", "twin", "flow1", ("flow1",)),)
    play.do(act.Redirect(doc, "flow0", "a", "twin"))
    assert set(shown(play, doc)) == {
        RedirectView("a", "twin", "flow0", ("flow0",)),
        RedirectView("a", "twin", "flow1", ("flow1",)),
    }
    play.do(act.Redirect(doc, "", "a", "twin"))
    assert shown(play, doc) == (RedirectView("a", "twin"),)
    play.do(act.Redirect(doc, "", "a", ""))
    assert shown(play, doc) == ()


def test_a_redirected_application_is_judged_anew(play):  # R-E01, R-E09
    judge = ReadinessJudge(play.site)
    doc = play.open([job("aC")])
    for case in judge.cases(play.environment.model):
        judge.judge(case)
    assert judge.cases(play.environment.model) == ()
    play.do(act.Redirect(doc, "", "a", "twin"))
    assert [case.opened.id for case in judge.cases(play.environment.model)] == [doc]


def test_a_wish_for_all_flows_is_told_with_those_that_it_means(play):  # R-E09
    judge, doc = ReadinessJudge(play.site), play.open([job("bC")], [job("aC")], parallel=True)
    play.do(act.Redirect(doc, "", "a", "twin"))
    assert shown(play, doc) == (RedirectView("a", "twin"),)
    for case in judge.cases(play.environment.model):
        judgement = judge.judge(case)
        play.environment.become(lambda model, judgement=judgement: judged(model, doc, judgement))
    assert shown(play, doc) == (RedirectView("a", "twin", homes=("flow1",)),)
