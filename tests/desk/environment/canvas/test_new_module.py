import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.installed_fixture import InstalledFixture
from onika.model.task import Task
from onika.wire import act


@pytest.fixture
def desk(tmp_path, monkeypatch):
    return InstalledFixture(tmp_path, monkeypatch)


def test_a_module_its_rmod_and_a_test_are_written_and_the_task_is_in_the_library(desk):  # R-C31
    assert desk.do(act.NewModule("low_pass")) == "low_pass"
    own = desk.own.path
    assert sorted(path.relative_to(own).as_posix() for path in own.rglob("*.*")) == [
        "module/low_pass.py",
        "module/low_pass.rmod",
        "tests/test_low_pass.py",
    ]
    task = desk.environment.tree.tasks["low_pass"]
    assert (task.library, task.code) == (str(own), str(own / "module" / "low_pass.py"))
    assert "low_pass is a new module now" in str(desk.says[-1].text)
    for kind in ("code", "rmod", "test"):
        text = desk.do(act.ReadText("low_pass", kind))
        assert text.faults == () and "low_pass" in str(text.text)


def test_a_name_that_is_taken_is_refused_and_another_is_offered(desk):  # R-C31, R-X01
    no = desk.no(act.NewModule("pd"))
    assert str(no.reason) == "there is a pd in generic already"
    assert no.remedies[0].act == act.NewModule("pd_2")
    assert desk.do(no.remedies[0].act) == "pd_2"
    assert desk.installed_files() == desk.before


@pytest.mark.parametrize("name", ["", "9lives", "class", "../up", "a b"])
def test_what_is_no_name_is_refused_at_its_field(desk, name):  # R-C31, R-B08
    no = desk.no(act.NewModule(name))
    assert no.reason.key == "desk.module_name" and "name" in no.fields
    assert not desk.own.path.exists()


def test_it_is_kept_where_one_says_and_what_is_shipped_is_not_written(desk, tmp_path):  # R-C31, R-B07
    desk.do(act.NewModule("near", str(tmp_path / "mine")))
    assert desk.environment.tree.tasks["near"].library == str(tmp_path / "mine")
    desk.do(act.NewModule("far", str(desk.generic.path)))
    assert desk.environment.tree.tasks["far"].library == str(desk.own.path)
    assert desk.installed_files() == desk.before
    assert "base" in desk.no(act.NewModule("none", "\0")).fields


def test_a_module_without_a_test_says_so(tmp_path):  # R-C31
    sitting = EnvironmentFixture(tmp_path, (Task("pd", "pd", frequency=10.0),))
    (tmp_path / "module" / "pd.py").write_text("x = 1\n")
    sitting.do(act.CloseLibrary(str(tmp_path)))
    sitting.do(act.OpenLibrary(str(tmp_path)))
    assert "there is no test of pd" in str(sitting.no(act.ReadText("pd", "test")).reason)


def test_a_file_that_is_there_already_is_never_written_over(desk):  # R-C31, R-B07
    path = desk.own.path / "tests" / "test_gain.py"
    path.parent.mkdir(parents=True)
    path.write_text("mine")
    assert "is there already: nothing was written" in str(desk.no(act.NewModule("gain")).reason)
    assert path.read_text() == "mine" and not (desk.own.path / "module").exists()
