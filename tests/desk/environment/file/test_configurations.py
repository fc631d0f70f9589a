import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, live
from onika.wire.view import ShowSaveAs

TASKS = (
    Task("cubic", "cubic", outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", invar=("Q_REF",), frequency=100.0),
)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, TASKS)


def documents(sitting):
    return sitting.environment.tree.documents


def saved(sitting, name="mine"):
    doc = sitting.new("cubic")
    path = sitting.do(act.Save(doc, name, str(sitting.base.path)))
    return doc, path


def test_new_configurations_have_names_of_their_own(sitting):  # R-C21
    sitting.new()
    sitting.new()
    assert [document.name for document in documents(sitting).values()] == ["Untitled-1", "Untitled-2"]


def test_a_configuration_is_saved_and_opened_again(sitting):  # R-C06
    doc, path = saved(sitting)
    assert (documents(sitting)[doc].name, documents(sitting)[doc].is_dirty) == ("mine", False)
    sitting.do(act.Close(doc))
    again = sitting.do(act.Open(path))
    assert sorted(documents(sitting)[again].tasks) == ["cubic"]


def test_a_configuration_is_opened_by_its_name_on_the_search_path(sitting):  # R-C06
    doc, _ = saved(sitting)
    sitting.do(act.Close(doc))
    doc = sitting.do(act.Open("mine"))
    assert documents(sitting)[doc].name == "mine"


def test_what_is_open_already_is_shown_and_not_opened_twice(sitting):
    doc, path = saved(sitting)
    assert sitting.do(act.Open(path)) == doc
    assert len(documents(sitting)) == 1


def test_an_untouched_blank_makes_room_for_what_is_opened(sitting):  # R-C21
    doc, path = saved(sitting)
    sitting.do(act.Close(doc))
    assert [document.name for document in documents(sitting).values()] == ["Untitled-1"]
    sitting.do(act.Open(path))
    assert [document.name for document in documents(sitting).values()] == ["mine"]


def test_what_is_not_saved_is_not_closed_without_a_word(sitting):
    doc = sitting.new("cubic")
    refused = sitting.no(act.Close(doc))
    assert [remedy.act for remedy in refused.remedies] == [act.Save(doc), act.Close(doc, True)]
    sitting.do(refused.remedies[1].act)
    assert doc not in documents(sitting)


def test_a_configuration_without_a_file_asks_where(sitting):
    assert sitting.no(act.Save(sitting.new("cubic"))).remedies[0].show == ShowSaveAs()


def test_a_name_that_is_none_is_refused_at_its_field(sitting):
    refused = sitting.no(act.Save(sitting.new("cubic"), "no name", str(sitting.base.path)))
    assert list(refused.fields) == ["name"]


def test_a_file_that_another_has_written_is_kept_until_the_user_says_otherwise(sitting):  # R-B07
    doc, _ = saved(sitting)
    sitting.base.configuration_file("mine").write_text("other\n")
    sitting.do(act.Place(doc, "pd", 300, 0))
    refused = sitting.no(act.Save(doc))
    assert sitting.base.configuration_file("mine").read_text() == "other\n"
    sitting.do(refused.remedies[0].act)
    assert "pd" in sitting.base.configuration_file("mine").read_text()


def test_reading_again_takes_the_file_over_and_can_be_taken_back(sitting):
    doc, _ = saved(sitting)
    file = sitting.base.configuration_file("mine")
    file.write_text(file.read_text().replace("cubic", "pd"))
    sitting.do(act.Reload(doc))
    assert sorted(documents(sitting)[doc].tasks) == ["pd"]
    sitting.do(act.Undo(doc))
    assert sorted(documents(sitting)[doc].tasks) == ["cubic"]


@pytest.mark.parametrize("path", ["nothing", "/nowhere/conf/nothing.conf"])
def test_what_is_not_there_is_not_opened(sitting, path):
    assert "nothing" in str(sitting.no(act.Open(path)).reason)


def test_a_file_outside_a_base_directory_is_not_opened(sitting, tmp_path):
    (tmp_path / "lonely.conf").write_text("EOF\n")
    assert "conf/" in str(sitting.no(act.Open(str(tmp_path / "lonely.conf"))).reason)


def test_a_file_at_fault_is_not_opened_and_says_where(sitting):  # R-B07
    sitting.base.path.joinpath("conf").mkdir()
    sitting.base.configuration_file("bad").write_text("RMODFILE pd\nCOORDS x y\nEOF\n")
    assert "bad.conf:2" in str(sitting.no(act.Open("bad")).reason)


def test_keeping_what_is_here_ends_the_question(sitting):
    doc, _ = saved(sitting)
    sitting.do(act.Keep(doc))
    assert not documents(sitting)[doc].has_changed_on_disk


def test_what_comes_with_onika_is_not_saved_over(sitting, tmp_path, monkeypatch):  # R-C06
    doc, _ = saved(sitting)
    monkeypatch.setattr("onika.store.shipped.shipped", lambda: tmp_path)
    sitting.do(act.Place(doc, "pd", 300, 0))
    refused = sitting.no(act.Save(doc))  # here one's own directory would be shipped too
    assert "comes with Onika" in str(refused.reason)
    sitting.no(act.Save(doc, overwrites=True))
    assert "pd" not in sitting.base.configuration_file("mine").read_text()


def test_a_name_alone_saves_into_the_directory_of_the_users_own(sitting, monkeypatch):  # R-C06
    path = sitting.do(act.Save(sitting.new("cubic"), "mine"))
    assert path == str(sitting.site.own / "conf" / "mine.conf")


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def test_tasks_that_are_off_end_with_their_configuration(duet):  # R-C11
    doc = duet.connected("cubic")
    duet.do(act.Close(doc, discards=True))
    assert duet.runtime.lives.get("Untitled-1", {}) == {}
    assert not any(isinstance(message, live.Release) for message in duet.carried_out)


def test_tasks_that_are_on_are_asked_about_before_their_tab_closes(duet):  # R-C11
    doc = duet.connected("cubic", "pd")
    duet.do(act.Toggle(doc, "cubic"))
    refused = duet.no(act.Close(doc, discards=True))
    assert "cubic of Untitled-1 is ON" in str(refused.reason)
    end, leave = [remedy.act for remedy in refused.remedies]
    assert (end.alive, leave.alive) == ("end", "leave")
    duet.do(leave)
    assert set(duet.runtime.lives["Untitled-1"]) == {"cubic", "pd"}


def test_a_file_without_loci_draws_its_wires_and_is_not_changed_thereby(sitting):  # R-C09, R-B06
    path = sitting.base.configuration_file("bare")
    path.parent.mkdir(exist_ok=True)
    rows = "COORDS 0 0\nINLEFT yes\nFREQ 0\nRTPU unknown\n"
    path.write_text(f"VERSION 1.3\nRMODFILE cubic\n{rows}RMODFILE pd\n{rows}EOF\n")
    text = path.read_text()
    doc = sitting.do(act.Open(str(path)))
    view = documents(sitting)[doc]
    assert (view.loci["Q_REF"].writers, view.loci["Q_REF"].readers) == (("cubic",), ("pd",))
    assert (view.is_dirty, view.is_moved, path.read_text()) == (False, False, text)
