import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.files.rmod import RmodText
from onika.model.task import LocalLine, Task
from onika.store.base_directory import BaseDirectory
from onika.wire import act

PD = Task("pd", "pd", invar=("Q",), outvar=("T",), frequency=10.0, local=(LocalLine("GAIN", ("1",)),))
FAR = Task("far", "far", outvar=("P",), frequency=10.0)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path / "here", (PD,))


@pytest.fixture
def away(tmp_path):
    base = BaseDirectory(tmp_path / "away")
    base.save_task(RmodText(FAR))
    return base


def keys(sitting, doc):
    return [reason.key for reason in sitting.do(act.Check(doc)) if reason.key.startswith("desk.")]


def test_a_configuration_that_says_it_all_by_itself_differs_nowhere(sitting):  # R-C26
    doc = sitting.new("pd")
    sitting.do(act.Local("pd", (("GAIN", ("2",)),), doc))
    sitting.do(act.Save(doc, "job", str(sitting.base.path)))
    assert keys(sitting, doc) == [] and all(say.level == "info" for say in sitting.says)


def test_a_task_of_a_library_that_no_search_path_has_is_told_at_the_check_and_when_it_is_saved(sitting, away):  # R-C26
    sitting.do(act.OpenLibrary(str(away.path)))
    doc = sitting.new("far")
    sitting.do(act.Save(doc, "job", str(sitting.base.path)))
    assert [say.text.key for say in sitting.says] == ["desk.not_found_elsewhere"]
    assert keys(sitting, doc) == ["desk.not_found_elsewhere"]


def test_a_task_that_another_program_takes_from_another_file_is_told(sitting, away):  # R-C26, reading 35
    away.save_task(RmodText(Task("pd", "pd", invar=("Q",), outvar=("T",), frequency=99.0)))
    doc = sitting.new("pd")
    sitting.do(act.Save(doc, "job", str(away.path)))
    (say,) = sitting.says
    assert (say.text.key, say.text.args["path"]) == ("desk.other_file_elsewhere", str(away.task_file("pd")))


def test_what_was_changed_in_the_library_after_saving_is_told_at_the_check(sitting):  # R-C26
    doc = sitting.new("pd")
    sitting.do(act.Save(doc, "job", str(sitting.base.path)))
    sitting.do(act.Local("pd", (("GAIN", ("2",)),)))
    assert keys(sitting, doc) == ["desk.changed_here_only"]
    sitting.do(act.Save(doc))
    assert keys(sitting, doc) == []
