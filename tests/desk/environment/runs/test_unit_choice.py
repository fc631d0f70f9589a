import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import Laboratory, job
from onika.wire import act, request


@pytest.fixture
def play(tmp_path):
    files = Laboratory(tmp_path)
    files.plain_task("settled", writes="S")
    files.module("settled", "# settled\n")
    files.configuration("settledC", "settled 100 rt1")
    return RunFixture(tmp_path, ("rt0", "rt1"))


def units(play):
    (flow,) = play.carried(request.Prepare)[-1].plan.flows
    return {task.name: task.rtpu for task in flow.tasks}


def labels(no):
    return [str(remedy.label) for remedy in no.remedies]


def test_who_names_no_unit_is_asked_about_and_runs_on_the_one_that_is_chosen(play):  # R-E12, reading 12
    doc = play.open([job("aC"), job("settledC")])
    no = play.answer(act.Run(doc)).no
    assert str(no.reason) == "play does not say on which processing unit a runs: rt0 or rt1?"
    assert labels(no) == ["a on rt0", "a on rt1"] and play.carried(request.Prepare) == []
    play.do(no.remedies[1].act)
    assert units(play) == {"a": "rt1", "settled": "rt1"}


def test_several_are_asked_about_one_by_one_or_all_together(play):  # R-E12, reading 12
    doc = play.open([job("aC"), job("bC"), job("cC")])
    no = play.answer(act.Run(doc)).no
    assert labels(no) == ["a on rt0", "a on rt1", "All on rt0", "All on rt1"]
    no = play.answer(no.remedies[1].act).no
    assert "b, c run" in str(no.reason) and labels(no)[:2] == ["b on rt0", "b on rt1"]
    play.do(no.remedies[2].act)
    assert units(play) == {"a": "rt1", "b": "rt0", "c": "rt0"}


def test_a_unit_that_is_gone_since_is_asked_about_anew(play):  # R-E12, R-X01
    doc = play.open([job("aC")])
    assert "rt0 or rt1" in str(play.answer(act.Run(doc, units=(("a", "rt7"),))).no.reason)


def test_where_there_is_one_unit_nothing_is_asked(tmp_path):  # reading 12
    play = RunFixture(tmp_path)
    assert play.run(play.open([job("aC")])).state == "running"
