"""What a configuration says of its tasks otherwise than their files: seen, saved, read again and run as it is."""

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.files import conf
from onika.model.own_lines import NO_OWN_LINES
from onika.model.task import LocalLine, Task
from onika.wire import act

GAIN = (LocalLine("GAIN", ("1",)), LocalLine("LIMIT", ("9",)))
PD = Task("pd", "pd", invar=("Q",), outvar=("T",), frequency=10.0, local=GAIN)
OTHER = Task("other", "o", invar=("T",), outvar=("P",), frequency=10.0)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (PD, OTHER))


def placed(sitting, doc, name="pd"):
    return sitting.environment.model.documents[doc].content.placed(name)


def view(sitting, doc):
    return sitting.environment.tree.documents[doc]


def seen(sitting, doc, name="pd"):
    model = sitting.environment.model
    return model.libraries_of(model.documents[doc]).tasks[name]


def tune(sitting, doc, gain):
    sitting.do(act.Local("pd", (("GAIN", (gain,)), ("LIMIT", ("9",))), doc))


def save(sitting, doc, name="job"):
    return sitting.do(act.Save(doc, name, str(sitting.base.path)))


def test_an_alias_of_a_placed_task_is_of_its_configuration_alone(sitting):  # R-C04, R-B09
    here, there = sitting.new("pd"), sitting.new("pd")
    sitting.do(act.Alias("pd", "T", "GOAL", here))
    assert set(view(sitting, here).loci) == {"Q", "GOAL"}
    assert set(view(sitting, there).loci) == {"Q", "T"}
    assert [pin.svar for pin in view(sitting, here).own["pd"].pins] == ["Q", "GOAL"]
    assert view(sitting, there).own == {}
    assert not sitting.environment.tree.tasks["pd"].is_changed
    sitting.do(act.Undo(here))
    assert (placed(sitting, here).own, view(sitting, here).own) == (NO_OWN_LINES, {})
    assert set(view(sitting, here).loci) == {"Q", "T"}
    sitting.do(act.Redo(here))
    assert set(view(sitting, here).loci) == {"Q", "GOAL"}


def test_parameters_of_one_task_differ_in_two_configurations(sitting):  # R-C04, R-B09
    here, there = sitting.new("pd"), sitting.new("pd")
    tune(sitting, here, "2")
    tune(sitting, there, "3")
    assert [seen(sitting, doc).local[0].words for doc in (here, there)] == [("2",), ("3",)]
    assert view(sitting, here).own["pd"].is_changed
    tune(sitting, here, "1")
    assert placed(sitting, here).own == NO_OWN_LINES


def test_what_is_saved_is_what_is_seen_when_it_is_opened_again(sitting):  # R-B09, R-C06
    doc = sitting.new("pd")
    sitting.do(act.Alias("pd", "T", "GOAL", doc))
    tune(sitting, doc, "2")
    before = seen(sitting, doc)
    assert view(sitting, doc).is_dirty
    path = save(sitting, doc)
    assert not view(sitting, doc).is_dirty
    sitting.do(act.Close(doc))
    again = sitting.do(act.Open(path))
    assert seen(sitting, again) == before
    assert set(view(sitting, again).loci) == {"Q", "GOAL"}
    assert [say for say in sitting.says if say.level != "info"] == []


def test_what_was_changed_in_the_library_alone_is_saved_with_a_configuration_that_shows_it(sitting):  # R-C04, R-E12
    sitting.do(act.Local("pd", (("GAIN", ("5",)),)))
    doc = sitting.new("pd")
    path = save(sitting, doc)
    text = sitting.base.configuration_file("job").read_text()
    configuration, _ = conf.read(text, "job", path)
    assert configuration.placed[0].of(PD) == seen(sitting, doc)
    assert "NOLOCAL     LIMIT" in text


def test_a_configuration_whose_tasks_are_as_filed_is_written_as_before(sitting):  # R-B06
    doc = sitting.new("pd", "other")
    save(sitting, doc)
    assert sitting.base.configuration_file("job").read_text().startswith("VERSION     1.3")


def test_a_change_that_the_configuration_cannot_bear_is_refused_and_bothers_no_other(sitting):  # reading 9, R-C07
    here, there = sitting.new("pd", "other"), sitting.new("pd")
    no = sitting.no(act.Alias("pd", "T", "P", here))
    assert "`other` already writes" in str(no.fields["svar"])
    sitting.do(act.Alias("pd", "T", "P", there))


def test_saving_the_task_makes_its_lines_those_of_the_file(sitting):  # R-C04
    doc, other = sitting.new("pd"), sitting.new("pd")
    tune(sitting, doc, "2")
    sitting.do(act.SaveTask("pd", doc=doc))
    assert placed(sitting, doc).own == NO_OWN_LINES
    assert [seen(sitting, each).local[0].words for each in (doc, other)] == [("2",), ("2",)]
    assert "GAIN        2" in sitting.base.task_file("pd").read_text()


def test_forgetting_takes_a_placed_task_as_its_library_has_it(sitting):  # R-C04
    doc = sitting.new("pd")
    tune(sitting, doc, "2")
    sitting.do(act.ForgetTask("pd", doc))
    assert (placed(sitting, doc).own, seen(sitting, doc)) == (NO_OWN_LINES, PD)
    sitting.do(act.Undo(doc))
    assert seen(sitting, doc).local[0].words == ("2",)


def test_what_is_copied_brings_its_lines_along_also_as_text(sitting):  # R-C10
    doc, other = sitting.new("pd"), sitting.new()
    tune(sitting, doc, "2")
    text = sitting.do(act.Copy(doc, ("pd",)))
    sitting.do(act.Paste(other, 0, 0, text))
    assert seen(sitting, other) == seen(sitting, doc)
    assert sitting.no(act.Paste(sitting.new(), 0, 0, text.replace("GAIN", "7 8")))
