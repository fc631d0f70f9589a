from dataclasses import replace

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.file.disk_watch import DiskWatch
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.refresh import refreshed
from onika.desk.environment.state.live import SubsystemFacts
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.wire import act

A = Task("a", "a", outvar=("Q",), frequency=10.0)
B = Task("b", "b", invar=("Q",), frequency=10.0)


class Watched(EnvironmentFixture):
    """An environment beside which somebody else writes files."""

    def __init__(self, folder, tasks):
        super().__init__(folder, tasks)
        self.disk = DiskWatch(self.site)

    def look(self):
        """What the program does every second; the number of patches that came of it."""
        changed = self.disk.changed(self.environment.model)
        before = self.environment.revision
        self.says.clear()
        self.environment.become(lambda model: refreshed(model, changed))
        return self.environment.revision - before


def living(sitting, doc, wanted):
    """The document lives, as far as the model knows; nothing is asked of a runtime."""
    old = sitting.environment.model.documents[doc]
    content = replace(old.content, wanted=wanted)
    new = replace(old, live=SubsystemFacts("s", "lost"), content=content)
    sitting.environment.become(lambda model: Done(model.with_document(new)))


@pytest.fixture
def sitting(tmp_path):
    return Watched(tmp_path, (A, B))


def saved(sitting, name="job"):
    doc = sitting.new("a", "b")
    sitting.do(act.Save(doc, name, str(sitting.base.path)))
    return doc, sitting.base.configuration_file(name)


def rewrite(sitting, task):
    sitting.base.task_file(task.name).write_text(rmod.write(RmodText(task)))


def document(sitting, doc):
    return sitting.environment.model.documents[doc]


def test_what_was_saved_here_is_nothing_new(sitting):  # R-C06
    doc, path = saved(sitting)
    sitting.do(act.Alias("a", "Q", "R", doc))
    sitting.do(act.SaveTask("a", doc=doc))
    text = sitting.do(act.ReadText("b", "rmod"))
    sitting.do(act.WriteText("b", "rmod", text.text + "# more\n", text.stamp))
    sitting.look()  # the list of configurations
    assert list(sitting.environment.tree.files) == [str(path)]
    model = sitting.environment.model
    assert sitting.look() == 0
    path.touch()
    sitting.base.task_file("a").touch()
    assert sitting.look() == 0
    assert (sitting.environment.model is model, sitting.says) == (True, [])


def test_a_task_that_was_written_is_as_its_file_says_and_what_was_changed_here_stays(sitting):  # R-C01, R-C04
    doc, _ = saved(sitting)
    sitting.do(act.Alias("a", "Q", "R"))
    rewrite(sitting, Task("a", "a", description="new", outvar=("Q", "P"), frequency=10.0))
    sitting.look()
    view = sitting.environment.tree.tasks["a"]
    assert (view.description, [pin.svar for pin in view.pins], view.is_changed) == ("new", ["R", "P"], True)
    assert set(sitting.environment.tree.documents[doc].loci) == {"P", "Q", "R"}
    rewrite(sitting, Task("a", "a", aliases=(("Q", "R"),), outvar=("Q",), frequency=10.0))
    sitting.look()
    assert not sitting.environment.tree.tasks["a"].is_changed
    assert sitting.environment.model.libraries.edits == {}


def test_undo_takes_back_what_the_step_changed_and_not_what_a_file_has_changed_since(sitting):  # R-X10, R-C04
    rewrite(sitting, Task("a", "a", outvar=("Q", "P"), frequency=10.0))
    sitting.look()
    doc, _ = saved(sitting)
    sitting.do(act.Alias("a", "Q", "R", doc))
    rewrite(sitting, Task("a", "a", aliases=(("P", "S"),), outvar=("Q", "P"), frequency=10.0))
    sitting.look()
    sitting.do(act.Undo(doc))
    view = sitting.environment.tree.tasks["a"]
    assert ([pin.svar for pin in view.pins], view.is_changed) == (["Q", "S"], False)


def test_a_changed_task_that_lives_stays_as_it_is_whatever_its_file_says(sitting):  # R-C04
    doc, _ = saved(sitting)
    sitting.do(act.Alias("a", "Q", "R"))
    living(sitting, doc, {"a": False})
    before = sitting.environment.model.libraries.tasks["a"]
    rewrite(sitting, Task("a", "a", description="new", outvar=("Q",), frequency=10.0))
    sitting.look()
    assert sitting.environment.model.libraries.tasks["a"] == before


def test_a_task_at_fault_or_gone_is_left_out_told_and_stays_placed_as_missing(sitting):  # R-C01
    doc, _ = saved(sitting)
    sitting.base.task_file("a").write_text("MODULE\n")
    sitting.base.task_file("b").unlink()
    sitting.look()
    assert sitting.environment.tree.tasks == {}
    assert all(task.is_missing for task in sitting.environment.tree.documents[doc].tasks.values())
    assert any("a.rmod" in str(say.text) for say in sitting.says)
    rewrite(sitting, A)
    rewrite(sitting, B)
    sitting.look()
    assert not any(task.is_missing for task in sitting.environment.tree.documents[doc].tasks.values())


def test_a_file_that_clashes_in_an_open_configuration_is_taken_and_told(sitting):  # reading 9
    saved(sitting)
    rewrite(sitting, Task("b", "b", outvar=("Q",), frequency=10.0))
    sitting.look()
    assert [str(say.text) for say in sitting.says] == ["in job, b writes Q, which `a` already writes"]


def test_a_document_that_is_as_it_was_saved_is_read_again_and_undo_brings_back_what_was_here(sitting):  # R-C06, R-X10
    doc, path = saved(sitting)
    before = document(sitting, doc).content
    path.write_text(path.read_text().replace("RTPU        unknown", "RTPU        rt7", 1))
    sitting.look()
    assert document(sitting, doc).content.configuration.placed[0].rtpu == "rt7"
    assert not sitting.environment.tree.documents[doc].is_dirty
    assert [str(say.text) for say in sitting.says] == ["job was changed on the disk by somebody else and is read again"]
    sitting.do(act.Undo(doc))
    assert document(sitting, doc).content == before


@pytest.mark.parametrize("how", ["dirty", "moved", "live"])
def test_a_document_with_something_to_lose_is_left_and_marked(sitting, how):  # R-C06
    doc, path = saved(sitting)
    if how == "dirty":
        sitting.do(act.Remove(doc, ("b",)))
    elif how == "moved":
        sitting.do(act.Move(doc, {"a": (5, 5)}))
    else:
        living(sitting, doc, {})
    content, mine = document(sitting, doc).content, path.read_text()
    path.write_text(mine.replace("RTPU        unknown", "RTPU        rt7"))
    sitting.look()
    assert document(sitting, doc).content is content
    assert sitting.environment.tree.documents[doc].has_changed_on_disk
    assert "stays until you read it again" in str(sitting.says[0].text)
    path.write_text(mine)
    sitting.look()
    assert not sitting.environment.tree.documents[doc].has_changed_on_disk


def test_a_document_whose_file_is_gone_or_at_fault_stays_and_is_marked(sitting):  # R-C06, R-B07
    doc, path = saved(sitting)
    content = document(sitting, doc).content
    path.write_text("VERSION 1.3\nRMODFILE a\nEOF\n")
    sitting.look()
    assert "is at fault now" in str(sitting.says[0].text)
    assert len(sitting.says) == 1
    path.unlink()
    sitting.look()
    assert "was removed" in str(sitting.says[0].text)
    assert document(sitting, doc).content is content
    assert sitting.environment.tree.documents[doc].has_changed_on_disk
    assert sitting.environment.tree.files == {}


def test_configurations_that_come_and_go_are_in_the_list_and_not_in_it(sitting):  # R-C06
    path = sitting.base.configuration_file("new")
    path.parent.mkdir()
    path.write_text("VERSION 1.2\nRMODFILE a\nCOORDS 1 2\nEOF\n")
    sitting.look()
    assert sitting.environment.tree.files[str(path)].tasks == 1
    path.write_text("nonsense")
    sitting.look()
    assert sitting.environment.tree.files[str(path)].tasks == 0
    assert any("new.conf" in str(say.text) for say in sitting.says)
    path.unlink()
    sitting.look()
    assert sitting.environment.tree.files == {}
