import pytest

from kit.environment_fixture import EnvironmentFixture
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
