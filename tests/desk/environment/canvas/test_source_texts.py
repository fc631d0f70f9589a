import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.installed_fixture import InstalledFixture
from onika.desk.environment.initial_model import opened
from onika.files import rmod, whole
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.wire import act

PD = Task("pd", "pd", outvar=("Q",), frequency=10.0)
FREE = Task("free", "elsewhere", frequency=10.0)
CODE = "import os\n\nclass Pd:\n    pass\n"


@pytest.fixture
def sitting(tmp_path):
    BaseDirectory(tmp_path).save_task(RmodText(PD))
    (tmp_path / "module" / "pd.py").write_text(CODE)
    return EnvironmentFixture(tmp_path, (FREE,))


def write(sitting, kind, text, **more):
    source = sitting.do(act.ReadText("pd", kind))
    return sitting.do(act.WriteText("pd", kind, text, source.stamp, **more))


def file(sitting, name):
    return sitting.base.path / "module" / name


def test_a_tasks_file_and_its_modules_code_are_read_with_their_stamps(sitting):  # R-C05
    text = sitting.do(act.ReadText("pd", "rmod"))
    assert (text.path, str(text.text), text.faults) == (str(file(sitting, "pd.rmod")), rmod.write(RmodText(PD)), ())
    code = sitting.do(act.ReadText("pd", "code"))
    assert (str(code.text), code.stamp, code.is_read_only) == (CODE, whole.stamp(CODE), False)


def test_without_source_a_sentence_says_so(sitting):  # R-C23
    no = sitting.no(act.ReadText("free", "code"))
    assert str(no.reason) == "no open library has the source of elsewhere, the module of free"
    assert sitting.environment.tree.tasks["free"].code == ""
    assert sitting.environment.tree.tasks["pd"].code == str(file(sitting, "pd.py"))


def test_the_source_is_found_in_another_open_library(sitting, tmp_path):  # R-C05
    other = tmp_path / "other"
    (other / "module").mkdir(parents=True)
    (other / "module" / "elsewhere.py").write_text("x = 1\n")
    sitting.do(act.OpenLibrary(str(other)))
    assert str(sitting.do(act.ReadText("free", "code")).text) == "x = 1\n"


@pytest.mark.parametrize("task", ["nobody", "../pd", "", ".", "pd.rmod", "a/b", "pd\x00"])
def test_what_is_no_task_of_an_open_library_has_no_text(sitting, task):  # R-C05
    for kind in ("rmod", "code"):
        assert "no open library has a task" in str(sitting.no(act.ReadText(task, kind)).reason)
        assert "no open library" in str(sitting.no(act.WriteText(task, kind, "x", "0" * 64)).reason)


def test_a_link_that_leads_out_of_the_libraries_is_followed_neither_way(sitting, tmp_path_factory):  # R-C05
    secret = tmp_path_factory.mktemp("outside") / "secret.py"
    secret.write_text("password = 1\n")
    file(sitting, "pd.py").unlink()
    file(sitting, "pd.py").symlink_to(secret)
    assert "leads out of the open libraries" in str(sitting.no(act.ReadText("pd", "code")).reason)
    stamp = whole.stamp("password = 1\n")
    assert "leads out" in str(sitting.no(act.WriteText("pd", "code", "x", stamp)).reason)
    assert secret.read_text() == "password = 1\n"


FAULTY = {
    "def f(:\n    pass\n": (1, "invalid syntax"),
    "x = 1\nreturn 2\n": (2, "'return' outside function"),
    "x = 1\n  y = 2\n": (2, "unexpected indent"),
    "a = 1\nb = '\\d'\n": (2, "invalid escape sequence"),
    "x = 1\x00\n": (0, "null bytes"),
    "(" * 5000: (1, "too many nested parentheses"),
}


@pytest.mark.parametrize("text", FAULTY, ids=range(len(FAULTY)))
def test_faults_of_code_are_told_beside_their_lines_and_it_is_saved_all_the_same(sitting, text):  # R-C05
    line, words = FAULTY[text]
    written = write(sitting, "code", text)
    assert written.faults[0][0] in (line, 1)
    assert words in str(written.faults[0][1])
    assert file(sitting, "pd.py").read_text() == text
    assert written.stamp == whole.stamp(text) == sitting.do(act.ReadText("pd", "code")).stamp


def test_code_is_compiled_and_never_run(sitting, tmp_path):  # R-C05
    write(sitting, "code", f"open({str(tmp_path / 'ran')!r}, 'w')\nraise SystemExit\n")
    assert not (tmp_path / "ran").exists()


def test_a_changed_task_counts_at_once(sitting):  # R-C05, R-C01
    doc = sitting.new("pd")
    text = rmod.write(RmodText(Task("pd", "pd", outvar=("R",), frequency=10.0)))
    assert write(sitting, "rmod", text).faults == ()
    assert sitting.environment.tree.tasks["pd"].pins[0].svar == "R"
    assert list(sitting.environment.tree.documents[doc].loci) == ["R"]


def test_a_task_saved_half_done_is_left_out_until_it_is_mended(sitting):  # R-C01, R-C05
    doc = sitting.new("pd")
    good = file(sitting, "pd.rmod").read_text()
    written = write(sitting, "rmod", good.replace("TASKTYPE", "TASKTIPE"))
    assert written.faults[0][0] > 0
    assert "TASKT" in str(written.faults[0][1])
    assert "pd" not in sitting.environment.tree.tasks
    assert sitting.environment.tree.documents[doc].tasks["pd"].is_missing
    assert "left out until it is mended" in str(sitting.says[-1].text)
    again = sitting.do(act.ReadText("pd", "rmod"))
    assert again.faults == written.faults
    assert write(sitting, "rmod", good).faults == ()
    assert not sitting.environment.tree.documents[doc].tasks["pd"].is_missing


def test_what_was_changed_here_stays_when_the_file_is_edited(sitting):  # R-C04
    sitting.do(act.Alias("pd", "Q", "GOAL"))
    text = file(sitting, "pd.rmod").read_text()
    write(sitting, "rmod", text.replace("FREQ        10", "FREQ        50"))
    view = sitting.environment.tree.tasks["pd"]
    assert (view.pins[0].svar, view.hz, view.is_changed) == ("GOAL", 50.0, True)
    write(sitting, "rmod", text.replace("INCONST", "SVARALIAS   Q = GOAL\nINCONST"))
    view = sitting.environment.tree.tasks["pd"]
    assert (view.pins[0].svar, view.is_changed) == ("GOAL", False)


@pytest.mark.parametrize("kind", ["rmod", "code"])
def test_a_file_that_has_changed_is_refused_and_may_be_overwritten(sitting, kind):  # R-C05, R-B07
    path = file(sitting, "pd.rmod" if kind == "rmod" else "pd.py")
    source = sitting.do(act.ReadText("pd", kind))
    path.write_text(source.text + "# theirs\n")
    no = sitting.no(act.WriteText("pd", kind, source.text + "# mine\n", source.stamp))
    assert "has changed since it was read" in str(no.reason)
    assert path.read_text() == source.text + "# theirs\n"
    (overwrite,) = no.remedies
    sitting.do(overwrite.act)
    assert path.read_text() == source.text + "# mine\n"


def test_a_file_that_was_removed_is_written_only_when_meant(sitting):  # R-B07
    source = sitting.do(act.ReadText("pd", "rmod"))
    file(sitting, "pd.rmod").unlink()
    no = sitting.no(act.WriteText("pd", "rmod", source.text, source.stamp))
    assert "was removed since it was read" in str(no.reason)
    assert not file(sitting, "pd.rmod").exists()
    sitting.do(no.remedies[0].act)
    assert file(sitting, "pd.rmod").read_text() == str(source.text)


@pytest.mark.parametrize("stamp", ["", "*", "0", "z" * 64])
def test_what_is_no_stamp_overwrites_nothing(sitting, stamp):  # R-B07
    assert "read it again" in str(sitting.no(act.WriteText("pd", "code", "x", stamp)).reason)
    assert file(sitting, "pd.py").read_text() == CODE


def test_a_text_that_no_file_can_hold_is_refused(sitting):  # R-B07
    stamp = sitting.do(act.ReadText("pd", "code")).stamp
    assert "UTF-8" in str(sitting.no(act.WriteText("pd", "code", "x = '\ud800'", stamp)).reason)
    assert file(sitting, "pd.py").read_text() == CODE


def test_a_file_that_is_no_text_is_told(sitting):  # R-B07
    file(sitting, "pd.py").write_bytes(b"\xff\xfe")
    assert "UTF-8" in str(sitting.no(act.ReadText("pd", "code")).reason)


@pytest.fixture
def installed(tmp_path, monkeypatch):
    return InstalledFixture(tmp_path, monkeypatch)


def test_saving_shipped_code_makes_a_copy_that_counts_and_nothing_installed_is_written(installed):  # R-C05, R-B07
    installed.do(act.Alias("jtraj", "Q_REF", "Q_WISH"))
    view = installed.write("pd", "code", "def (")
    assert view.path == str(installed.own.code_file("pd")) and view.faults and not view.is_read_only
    tree = installed.environment.tree
    assert (tree.tasks["pd"].library, tree.tasks["pd"].code) == (str(installed.own.path), view.path)
    assert next(iter(tree.libraries)) == str(installed.own.path)
    assert tree.tasks["jtraj"].is_changed and installed.installed_files() == installed.before
    assert "saved as your own" in str(installed.says[-1].text)
    again = installed.write("pd", "code", "x = 1\n")  # from now on it is a file like any of one's own
    assert (again.path, again.faults) == (view.path, ())
    assert installed.site.code_file(installed.environment.model.libraries.tasks["pd"]) == installed.own.code_file("pd")
    installed.look()
    assert not any("left out" in sentence or "changed" in sentence for sentence in installed.sentences())


def test_what_was_changed_of_a_task_stays_when_its_code_becomes_ones_own(installed):  # R-C04
    installed.do(act.Alias("pd", "TAU_PD", "TAU_WISH"))
    installed.write("pd", "code", "x = 1\n")
    assert installed.environment.tree.tasks["pd"].is_changed


def test_saving_a_shipped_rmod_makes_a_copy_that_counts(installed):  # R-C05, R-B07
    text = installed.do(act.ReadText("pd", "rmod")).text
    view = installed.write("pd", "rmod", "# mine\n" + text)
    tree = installed.environment.tree
    assert view.path == str(installed.own.task_file("pd")) == tree.tasks["pd"].path
    assert tree.tasks["pd"].code == str(installed.generic.code_file("pd"))
    assert installed.installed_files() == installed.before


def test_a_shipped_file_that_was_exchanged_meanwhile_is_told_and_shown(installed):  # R-B07
    source = installed.do(act.ReadText("pd", "code"))
    installed.generic.code_file("pd").write_text("newer = 1\n")
    no = installed.no(act.WriteText("pd", "code", "mine = 1\n", source.stamp))
    assert no.reason.key == "desk.shipped_changed" and str(no.fields["theirs"]) == "newer = 1\n"
    installed.do(no.remedies[0].act)
    assert installed.own.code_file("pd").read_text() == "mine = 1\n"
    assert installed.generic.code_file("pd").read_text() == "newer = 1\n"


def test_where_ones_own_directory_cannot_be_written_nothing_is_changed(installed):  # R-B07
    installed.own.path.write_text("no folder")
    source = installed.do(act.ReadText("pd", "code"))
    no = installed.no(act.WriteText("pd", "code", "mine = 1\n", source.stamp))
    assert no.reason.key == "files.not_savable" and installed.installed_files() == installed.before


def test_two_environments_that_save_the_same_shipped_file_do_not_write_over_each_other(installed, tmp_path):  # R-B07
    source = installed.do(act.ReadText("pd", "code"))
    elsewhere = EnvironmentFixture(tmp_path, (), opened(installed.site, None, {})[0], installed.site)
    elsewhere.do(act.WriteText("pd", "code", "theirs = 1\n", source.stamp))
    no = installed.no(act.WriteText("pd", "code", "mine = 1\n", source.stamp))
    assert no.reason.key == "files.is_there" and installed.own.code_file("pd").read_text() == "theirs = 1\n"
    installed.look()
    assert str(installed.do(act.ReadText("pd", "code")).text) == "theirs = 1\n"
