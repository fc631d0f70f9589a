import json
import os
import subprocess
import sys

import pytest

from kit.desk.app_fixture import AppFixture
from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.file.autosave import Autosave, UnsavedChange
from onika.desk.environment.file.recovery import Recovery, reopened
from onika.desk.environment.file.recovery_record import RecoveryRecord, rescue_of
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration, Placed
from onika.model.task import Task
from onika.wire import act
from onika.words.reason import NOTHING


def document(doc="c1", name="move"):
    return Document(doc, Content(Configuration(name, (Placed("pd"),))))


def kept(recovery, *documents):
    assert recovery.carry_out([UnsavedChange(document.id, document) for document in documents]) == NOTHING


@pytest.fixture
def dead(tmp_path):
    """What a process left that ended by force."""
    lines = (
        "import os, pathlib, sys",
        "from onika.desk.environment.file.recovery import Recovery",
        "from onika.desk.environment.file.autosave import UnsavedChange",
        "from onika.desk.environment.state.content import Content",
        "from onika.desk.environment.state.document import Document",
        "from onika.model.configuration import Configuration, Placed",
        "recovery = Recovery(pathlib.Path(sys.argv[1]))",
        "document = Document('c1', Content(Configuration('move', (Placed('pd'),))))",
        "recovery.carry_out([UnsavedChange('c1', document)])",
        "os.kill(os.getpid(), 9)",
    )
    done = subprocess.run([sys.executable, "-c", "\n".join(lines), str(tmp_path)], check=False)
    assert done.returncode == -9
    return tmp_path


def test_what_a_killed_process_left_is_had_back(dead):
    recovery = Recovery(dead)
    assert recovery.recovered() == (rescue_of(document()),)
    recovery.leave()


def test_it_stays_on_the_disk_until_it_is_kept_again(dead):
    first = Recovery(dead)
    (rescued,) = first.recovered()
    os.close(first._lock)  # as if it were killed at this moment
    for lock in first._taken.values():
        os.close(lock)
    second = Recovery(dead)
    assert second.recovered() == (rescued,)
    kept(second, document("c5"))
    third = Recovery(dead)
    assert third.recovered() == ()
    assert len(list((dead / "recovery").iterdir())) == 2
    second.leave()
    third.leave()
    assert list((dead / "recovery").iterdir()) == []


def test_two_environments_of_one_user_leave_each_other_alone(tmp_path):
    first, other = Recovery(tmp_path), Recovery(tmp_path)
    kept(first, document())
    assert other.recovered() == ()
    other.leave()
    assert len(list(first.folder.glob("*.json"))) == 1
    first.leave()


def test_of_two_that_come_one_takes_over(dead):
    first, other = Recovery(dead), Recovery(dead)
    assert len(first.recovered()) == 1
    assert other.recovered() == ()
    first.leave()
    other.leave()
    assert list((dead / "recovery").iterdir()) == []


def test_what_is_saved_is_kept_no_longer_and_a_clean_end_leaves_nothing(tmp_path):
    recovery = Recovery(tmp_path)
    kept(recovery, document(), document("c2"))
    assert recovery.carry_out([UnsavedChange("c1", None), UnsavedChange("c9", None)]) == NOTHING
    assert [path.stem for path in recovery.folder.glob("*.json")] == ["c2"]
    recovery.leave()
    assert not recovery.folder.exists()


def test_an_end_that_nobody_could_save_before_keeps_what_is_not_saved(tmp_path):
    recovery = Recovery(tmp_path)
    kept(recovery, document())
    recovery.leave(keeps=True)
    empty = Recovery(tmp_path)
    assert len(empty.recovered()) == 1
    empty.leave(keeps=True)
    assert not empty.folder.exists()
    last = Recovery(tmp_path)
    assert len(last.recovered()) == 1
    last.leave()
    assert list((tmp_path / "recovery").iterdir()) == []


def test_what_cannot_be_read_is_put_aside(dead):
    (path,) = (dead / "recovery").glob("*/*.json")
    path.write_text("{")
    recovery = Recovery(dead)
    assert recovery.recovered() == ()
    assert [path.read_text() for path in (dead / "recovery").glob("*.broken")] == ["{"]
    recovery.leave()
    again = Recovery(dead)
    assert again.recovered() == ()
    again.leave()


def test_of_what_cannot_be_read_only_the_newest_is_kept(dead):
    (path,) = (dead / "recovery").glob("*/*.json")
    path.write_text("{")
    for number in range(30):
        older = dead / "recovery" / f"of-{number:02}.broken"
        older.write_text("{")
        os.utime(older, (number, number))
    Recovery(dead).recovered()
    kept = sorted(broken.name for broken in (dead / "recovery").glob("*.broken"))
    assert len(kept) == 20
    assert "of-29.broken" in kept
    assert "of-10.broken" not in kept


def test_where_nothing_can_be_written_the_reason_is_given(tmp_path):
    recovery = Recovery(tmp_path)
    os.rename(recovery.folder, tmp_path / "away")  # noqa: PTH104 - the folder is another's from now on
    assert recovery.carry_out([UnsavedChange("c1", document())]).key == "files.not_savable"
    (tmp_path / "state").write_text("no directory")
    with pytest.raises(OSError, match="state"):
        Recovery(tmp_path / "state")


def test_documents_are_reopened_unsaved_and_each_is_told(tmp_path):  # R-X10
    sitting = EnvironmentFixture(tmp_path, (Task("pd", "pd", outvar=("Q",), frequency=1.0),))
    doc = sitting.new("pd")
    sitting.do(act.Save(doc, "move", str(tmp_path)))
    sitting.do(act.Rate(doc, "pd", 2.0))
    blank = sitting.new("pd")
    autosave = Autosave()
    autosave.look(sitting.environment.model, 0.0)
    rescues = [rescue_of(change.document) for change in autosave.take_all(0.0)]
    assert [rescue.name for rescue in rescues] == ["move", sitting.environment.model.documents[blank].name]

    done = reopened(Model(sitting.environment.model.libraries), (*rescues, RecoveryRecord("broken", "nonsense")))
    first, other = done.model.documents.values()
    assert (first.id, first.name, first.is_dirty, first.base) == ("c1", "move", True, tmp_path)
    assert first.content.placed("pd").frequency == 2.0
    assert (other.id, other.is_dirty) == ("c2", True)
    assert [say.level for say in done.says] == ["info", "info", "warning"]
    assert done.model.opened == 2


def test_names_of_documents_without_a_file_stay_apart(tmp_path):  # R-C21
    untitled = rescue_of(document(name="Untitled-1"))
    done = reopened(Model(), (untitled, untitled))
    assert [document.name for document in done.model.documents.values()] == ["Untitled-1", "Untitled-2"]


def test_a_file_of_a_rescue_is_plain_text(tmp_path):
    recovery = Recovery(tmp_path)
    kept(recovery, document())
    (path,) = recovery.folder.glob("*.json")
    assert "RMODFILE" in json.loads(path.read_text())["text"]
    recovery.leave()


def test_applications_are_had_back_beside_configurations(tmp_path):  # R-X10
    gallery = AppFixture(tmp_path / "base")
    doc, conf = gallery.begun("grip", "open"), gallery.do(act.New())
    model = gallery.environment.model
    records = [rescue_of(model.applications[doc]), rescue_of(model.documents[conf])]
    after = AppFixture(tmp_path / "base")
    after.environment.become(lambda model: reopened(model, records))
    assert list(after.environment.tree.applications) == ["a1"]
    assert after.flow("a1") == "grip open"
    assert after.view("a1").is_dirty
    after.environment.become(lambda model: reopened(model, records[:1]))
    assert after.view("a3").name == "Untitled-3"
    assert "is open as it was" in str(after.says[-1].text)
    lost = EnvironmentFixture(tmp_path / "other")
    lost.environment.become(lambda model: reopened(model, records[:1]))
    assert "cannot be had back" in str(lost.says[-1].text)
