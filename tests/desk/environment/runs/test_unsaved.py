import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.runs.unsaved import dirty
from onika.wire import act


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_a_nested_application_that_is_not_saved_counts_too(play):  # R-E12
    path = play.files.application("inner", [job("aC"), job("bC")])
    inner = play.do(act.Open(str(path)))
    doc = play.open([job("inner", "Complete application")])
    play.do(act.RemoveIcons(inner, (2,)))
    assert dirty(play.environment.model) == ((inner, "inner"),)
    no = play.no(act.Run(doc))
    assert "inner is changed here and not saved; play would run what its file says" in str(no.reason)
    play.do(no.remedies[0].act)
    assert dirty(play.environment.model) == () and play.view.of == 1


def test_what_is_not_used_is_nobodys_concern(play, tmp_path):  # R-E12
    doc = play.open([job("aC")])
    conf = play.do(act.Open(str(tmp_path / "conf" / "bC.conf")))
    play.do(act.Rate(conf, "b", 50.0))
    assert play.run(doc).state == "running"


def test_what_cannot_be_saved_is_told_and_nothing_runs(play, tmp_path):  # R-E12
    doc = play.open([job("aC")])
    path = tmp_path / "conf" / "aC.conf"
    conf = play.do(act.Open(str(path)))
    play.do(act.Rate(conf, "a", 50.0))
    path.write_text(path.read_text() + "\n")
    assert play.no(act.Run(doc, saves_unsaved=True)).remedies
