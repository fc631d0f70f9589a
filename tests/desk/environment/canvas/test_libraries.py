import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.wire import act

OWN = Task("own", "own", outvar=("Q",), frequency=10.0)
FAR = Task("far", "far", invar=("Q",), frequency=10.0)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path / "own", (OWN,))


@pytest.fixture
def far(tmp_path):
    base = BaseDirectory(tmp_path / "far")
    base.save_task(RmodText(FAR))
    return base


def test_a_base_directory_is_opened_behind_the_others_with_its_configurations(sitting, far):  # R-C01
    (far.path / "conf").mkdir()
    (far.path / "conf" / "job.conf").write_text("VERSION 1.2\nRMODFILE far\nCOORDS 1 2\nEOF\n")
    assert sitting.do(act.OpenLibrary(str(far.path))) == str(far.path)
    tree = sitting.environment.tree
    assert [(library.name, library.order, library.tasks) for library in tree.libraries.values()] == [
        ("own", 0, 1),
        ("far", 1, 1),
    ]
    assert tree.tasks["far"].library == str(far.path)
    assert [file.name for file in tree.files.values()] == ["job"]


def test_a_library_that_is_open_is_not_opened_twice(sitting, far, tmp_path):  # R-C01
    sitting.do(act.OpenLibrary(str(far.path)))
    (tmp_path / "link").symlink_to(far.path)
    assert sitting.do(act.OpenLibrary(str(tmp_path / "link"))) == str(far.path)
    assert len(sitting.environment.model.libraries.libraries) == 2


def test_what_is_no_base_directory_is_refused_with_what_was_found(sitting, far, tmp_path):  # R-C01, R-B07
    assert str(sitting.no(act.OpenLibrary(str(tmp_path / "nowhere"))).reason) == f"there is no {tmp_path / 'nowhere'}"
    (tmp_path / "file").write_text("")
    assert str(sitting.no(act.OpenLibrary(str(tmp_path / "file"))).reason) == f"{tmp_path / 'file'} is no directory"
    assert "is no base directory" in str(sitting.no(act.OpenLibrary(str(tmp_path))).reason)
    no = sitting.no(act.OpenLibrary(str(far.path / "module")))
    assert no.remedies[0].act == act.OpenLibrary(str(far.path))
    assert "path" in sitting.no(act.OpenLibrary("a\x00b")).fields
    assert "path" in sitting.no(act.OpenLibrary("~nobody-of-that-name/x")).fields


def test_a_relative_path_begins_in_the_users_own_base_directory(sitting, tmp_path, monkeypatch):  # R-C01, R-C06
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    own = sitting.home / "onika" / "lab"
    (own / "module").mkdir(parents=True)
    assert sitting.do(act.OpenLibrary("lab")) == str(own)
    doc = sitting.new("own")
    assert sitting.do(act.Save(doc, "job2", "lab")) == str(own / "conf" / "job2.conf")
    assert list(elsewhere.iterdir()) == []


def test_a_task_at_fault_is_left_out_and_told(sitting, far):  # R-C01
    (far.path / "module" / "bad.rmod").write_text("MODULE\n")
    sitting.do(act.OpenLibrary(str(far.path)))
    assert list(sitting.environment.tree.tasks) == ["own", "far"]
    assert any("bad.rmod" in str(say.text) for say in sitting.says)
    assert sitting.environment.tree.libraries[str(far.path)].faults != ()


def test_closing_a_library_keeps_what_is_placed_and_opening_it_again_changes_nothing(sitting, far):  # R-C01
    sitting.do(act.OpenLibrary(str(far.path)))
    doc = sitting.new("own", "far")
    sitting.do(act.Move(doc, loci={"Q": (500, 500)}))
    before = sitting.environment.model.documents[doc].content
    sitting.do(act.CloseLibrary(str(far.path)))
    view = sitting.environment.tree.documents[doc]
    assert view.tasks["far"].is_missing and not view.tasks["own"].is_missing
    assert "far" not in sitting.environment.tree.tasks
    sitting.do(act.OpenLibrary(str(far.path)))
    assert sitting.environment.model.documents[doc].content == before
    assert "is not open" in str(sitting.no(act.CloseLibrary("/nowhere")).reason)


def test_what_was_changed_of_a_task_comes_back_with_its_library(sitting, far):  # R-C04
    sitting.do(act.OpenLibrary(str(far.path)))
    sitting.do(act.Alias("far", "Q", "P"))
    sitting.do(act.CloseLibrary(str(far.path)))
    sitting.do(act.OpenLibrary(str(far.path)))
    assert sitting.environment.tree.tasks["far"].pins[0].svar == "P"


def test_a_change_is_not_put_on_the_task_of_that_name_of_another_library(sitting, tmp_path):  # reading 11, R-C04
    other = BaseDirectory(tmp_path / "other")
    other.save_task(RmodText(OWN))
    sitting.do(act.OpenLibrary(str(other.path)))
    sitting.do(act.Alias("own", "Q", "P"))
    sitting.do(act.CloseLibrary(str(sitting.base.path)))
    tree = sitting.environment.tree
    assert (tree.tasks["own"].library, tree.tasks["own"].is_changed) == (str(other.path), False)
    assert any("as its file says again" in str(say.text) for say in sitting.says)


def test_a_library_read_again_is_the_same_library_where_nothing_is_new(sitting):  # R-C01
    from onika.desk.environment.canvas import libraries

    model = sitting.environment.model
    assert libraries.reread(model, {sitting.base.task_file("own")}).model is model
    sitting.base.task_file("own").write_text(rmod.write(RmodText(Task("own", "own", outvar=("R",), frequency=10.0))))
    done = libraries.reread(model, {sitting.base.task_file("own")})
    assert done.model.libraries.tasks["own"].outvar == ("R",)
