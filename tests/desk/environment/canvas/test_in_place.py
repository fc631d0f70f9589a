import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, live, request
from onika.words.reason import Reason

TASKS = (
    Task("const", "const", outconst=("N",), frequency=10.0),
    Task("new_const", "new_const", outconst=("N",), frequency=10.0),
    Task("user", "user", inconst=("N",), outvar=("U",), frequency=10.0),
    Task("stays", "stays", outvar=("S",), frequency=10.0),
    Task("goes", "goes", outvar=("G",), frequency=10.0),
    Task("comes", "comes", outvar=("C",), frequency=10.0),
)


@pytest.fixture
def duet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, TASKS)
    doc = duet.new("new_const", "user", "stays", "comes")
    duet.do(act.Save(doc, name="other", base=str(tmp_path)))
    duet.do(act.Close(doc))
    return duet


def test_what_becomes_of_every_task_is_said_before_it_happens(duet):  # R-C15
    doc = duet.connected("const", "user", "stays", "goes")
    refused = duet.no(act.OpenInPlace(doc, "other"))
    assert str(refused.reason).partition(": ")[2] == (
        "stays goes on untouched; user is initialised anew; const, goes are killed; new_const, comes are spawned, OFF"
    )
    assert refused.remedies[0].act == act.OpenInPlace(doc, "other", confirmed=True)


def test_it_is_one_change_and_one_step(duet):  # R-C15, R-X10
    doc = duet.connected("const", "user", "stays", "goes")
    duet.do(act.Toggle(doc, "stays"))
    count = len(duet.edits())
    duet.do(act.OpenInPlace(doc, "other", confirmed=True))
    assert len(duet.edits()) == count + 1
    assert set(duet.edits()[-1].kill) == {"const", "goes"}
    assert duet.state(doc, "stays") == "ON" and duet.state(doc, "comes") == "OFF"
    assert duet.document(doc).name == "other"
    duet.do(act.Undo(doc))
    assert set(duet.runtime.lives[duet.document(doc).live.subsystem]) == {"const", "user", "stays", "goes"}


def test_where_nothing_lives_nothing_is_asked(duet):  # reading 15
    doc = duet.new("const")
    assert duet.do(act.OpenInPlace(doc, "other")) == doc
    assert duet.document(doc).content.names == ("new_const", "user", "stays", "comes")
    assert not duet.document(doc).is_dirty


def test_a_file_that_is_not_there_is_said(duet):  # R-X01
    assert "nowhere" in str(duet.no(act.OpenInPlace(duet.new(), "nowhere")).reason)
    assert str(duet.no(act.OpenInPlace("c9", "other")).reason) == "this configuration is no longer open"


def test_what_the_runtime_refuses_leaves_the_document_tied_to_its_own_file(duet, tmp_path):  # R-C15, R-X10
    doc = duet.connected("const")
    duet.do(act.Save(doc, name="mine", base=str(tmp_path)))
    duet.rebuffs = {live.Change: request.Refused(Reason.plain("there is no room"))}
    assert "no room" in str(duet.answer(act.OpenInPlace(doc, "other", confirmed=True)).no.reason)
    assert (duet.document(doc).name, duet.document(doc).opened.path.name) == ("mine", "mine.conf")
    assert not duet.document(doc).is_dirty


def test_taking_it_back_ties_the_document_to_its_own_file_again(duet, tmp_path):  # R-C15, R-X10
    doc = duet.new("const")
    duet.do(act.Save(doc, name="mine", base=str(tmp_path)))
    duet.do(act.OpenInPlace(doc, "other", confirmed=True))
    duet.do(act.Undo(doc))
    assert duet.document(doc).opened.path.name == "mine.conf"
    assert not duet.document(doc).is_dirty
    duet.do(act.Redo(doc))
    assert duet.document(doc).opened.path.name == "other.conf"
    assert not duet.document(doc).is_dirty
