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


@pytest.fixture
def cell(play):
    """Task `a` has its device in the world `cell`, which is real."""
    play.files.plain_task("a", writes="A", local="DEVICE cell:arm\n")
    play.runtime.worlds = {"cell": False, "boxes": True}
    return play


def judge_all(play, doc):
    judge = ReadinessJudge(play.site)
    for case in judge.cases(play.environment.model):
        judgement = judge.judge(case)
        play.environment.become(lambda model, judgement=judgement: judged(model, doc, judgement))


def devices(play):
    flows = play.carried(request.Prepare)[-1].plan.flows
    return [dict(flow.tasks[0].local)["DEVICE"] for flow in flows]


def worlds(play, doc):
    return play.environment.tree.applications[doc].worlds


def test_one_flow_drives_another_world_and_the_page_is_told_which_drives_which(cell):  # R-E09
    doc = cell.open([job("aC")], [job("aC")], parallel=True)
    cell.do(act.Redirect(doc, "flow1", "cell:", "boxes:"))
    assert shown(cell, doc) == (RedirectView("cell:", "boxes:", "flow1", ("flow1",)),)
    judge_all(cell, doc)
    assert worlds(cell, doc) == {"flow0": ("cell",), "flow1": ("boxes",)}
    cell.run(doc)
    assert devices(cell) == [("cell:arm",), ("boxes:arm",)]
    assert [flow.worlds for flow in cell.view.flows.values()] == [("cell",), ("boxes",)]
    assert cell.environment.tree.runtime.world_kinds == {"cell": "real", "boxes": "simulated"}


def test_the_worlds_of_each_flow_are_offered_and_taken_back(cell):  # R-E09
    doc = cell.open([job("aC")], [job("aC")], parallel=True)
    cell.do(act.Redirect(doc, "flow1", "cell:", "boxes:"))
    seats = cell.do(act.Seats(doc)).worlds
    assert {flow: [(seat.world, seat.taken_by) for seat in some] for flow, some in seats.items()} == {
        "": [("cell", "")],
        "flow0": [("cell", "cell")],
        "flow1": [("cell", "boxes")],
    }
    cell.do(act.Redirect(doc, "flow1", "cell:", ""))
    assert shown(cell, doc) == ()
    assert [seat.taken_by for seat in cell.do(act.Seats(doc)).worlds[""]] == ["cell"]


def test_the_runtime_tells_which_worlds_there_are_and_is_started_for_it(cell):  # R-E09
    cell.do(act.FindWorlds())
    assert cell.environment.tree.runtime.world_kinds == {"cell": "real", "boxes": "simulated"}
    assert cell.environment.tree.runtime.state == "linked"


def test_a_world_that_is_none_or_that_no_flow_drives_is_refused(cell):  # R-E09, R-X01
    doc = cell.open([job("aC")])
    for new in ("boxes", "bo xes:", "boxes@:"):
        assert "[FLOW:]WORLD:=WORLD:" in str(cell.no(act.Redirect(doc, "", "cell:", new)).reason)
    assert "expected a world of play (cell:), found sea:" in str(
        cell.no(act.Redirect(doc, "", "sea:", "boxes:")).reason
    )
    assert shown(cell, doc) == ()
