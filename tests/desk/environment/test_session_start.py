from dataclasses import asdict

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.session_start import SessionStart, digests
from onika.model.task import Task
from onika.wire import act


def test_a_session_begins_with_digests_of_files_and_what_was_not_saved(tmp_path):  # R-H08
    sitting = EnvironmentFixture(tmp_path, [Task("a", "a", outvar=("Q",), frequency=1.0)])
    doc = sitting.do(act.New())
    sitting.do(act.Place(doc, "a", 1, 2))
    sitting.home.mkdir()
    (sitting.home / ".onika").write_text("VERSION 1\n")
    (sitting.home / ".OnikaButtons").write_text("a password")
    facts = SessionStart(sitting.site).facts(sitting.environment.model)
    assert facts["settings"] == asdict(sitting.environment.model.settings)
    assert facts["bases"][0]["name"] == tmp_path.name and list(facts["bases"][0]["files"]) == ["module/a.rmod"]
    assert facts["own"] == {".onika": "VERSION 1\n"}
    assert len(facts["unsaved"]) == 1 and "Untitled-1" in facts["unsaved"][0]


def test_a_digest_changes_with_its_file(tmp_path):  # R-H08
    (tmp_path / "conf").mkdir()
    (tmp_path / "conf" / "a.conf").write_text("1")
    before = digests(tmp_path)
    (tmp_path / "conf" / "a.conf").write_text("2")
    assert before.keys() == digests(tmp_path).keys() == {"conf/a.conf"} and before != digests(tmp_path)


def test_without_a_site_nothing_is_told_of_it(tmp_path):  # R-H08
    start = SessionStart()
    assert (start.home, dict(start.places)) == ("", {})
    assert start.facts(EnvironmentFixture(tmp_path).environment.model)["bases"] == []
