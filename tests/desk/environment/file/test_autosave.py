from dataclasses import replace
from pathlib import Path

from hypothesis import given, strategies as st

from onika.desk.environment.file.autosave import APART_S, REST_S, Autosave, UnsavedChange
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import History, UndoStep
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Judgement, OpenApplication
from onika.model.application import AppFlow, Application, Icon
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.store.opened_text import OpenedText
from onika.words.reason import Reason


def document(x, doc="c1"):
    return Document(doc, Content(Configuration("a", (Placed("pd", x),))))


def model(*documents):
    return Model(documents={document.id: document for document in documents})


def test_it_is_written_when_the_user_rests():
    autosave = Autosave()
    autosave.look(model(document(1)), 10.0)
    assert autosave.due_s == 10.0 + REST_S
    assert autosave.take(10.1) == ()
    assert autosave.take(10.3) == (UnsavedChange("c1", document(1)),)
    assert autosave.due_s is None
    assert autosave.take(99.0) == ()


def test_it_is_written_at_most_so_often():
    autosave = Autosave()
    autosave.look(model(document(1)), 0.0)
    autosave.take(REST_S)
    autosave.look(model(document(2)), 0.5)
    assert autosave.due_s == REST_S + APART_S


def test_who_never_rests_is_kept_all_the_same():
    autosave = Autosave()
    for n in range(30):
        autosave.look(model(document(n)), 0.1 * n)
    assert autosave.due_s == APART_S
    assert autosave.take(3.0) == (UnsavedChange("c1", document(29)),)


def test_nothing_is_written_of_what_is_saved_or_the_same():
    autosave = Autosave()
    saved = document(1)
    saved = replace(saved, opened=OpenedText(saved.content.configuration, "a.conf", ""))
    autosave.look(model(saved, Document("c2", Content(Configuration("blank")))), 0.0)
    assert autosave.due_s is None
    autosave.look(model(document(1)), 0.0)
    autosave.take_all(0.0)
    past = History((UndoStep(Reason.plain("moving"), "me", Content(Configuration("a")), Content(Configuration("a"))),))
    autosave.look(model(replace(document(1), history=past)), 5.0)
    assert autosave.due_s is None


def test_what_is_saved_or_closed_is_kept_no_longer():
    autosave = Autosave()
    autosave.look(model(document(1), document(2, "c2")), 0.0)
    assert len(autosave.take(1.0)) == 2
    opened = replace(document(1), opened=OpenedText(document(1).content.configuration, "a.conf", ""))
    autosave.look(model(opened), 3.0)
    assert autosave.take(9.0) == (UnsavedChange("c1", None), UnsavedChange("c2", None))
    assert autosave.take_all(9.0) == ()


def test_looks_alone_are_kept_too():
    autosave = Autosave()
    moved = replace(document(5), opened=OpenedText(document(1).content.configuration, "a.conf", ""))
    assert moved.is_moved
    autosave.look(model(moved), 0.0)
    assert autosave.take_all(0.0) == (UnsavedChange("c1", moved),)


@given(st.lists(st.tuples(st.floats(0.0, 3.0), st.integers(0, 3), st.integers(0, 2))))
def test_after_every_writing_the_disk_holds_what_is_not_saved(acts):
    autosave, now_s, disk, last_s = Autosave(), 0.0, {}, None
    for pause_s, x, count in acts:
        now_s += pause_s
        unsaved = {f"c{n}": document(x, f"c{n}") for n in range(count)}
        autosave.look(model(*unsaved.values()), now_s)
        changes = autosave.take(now_s)
        if changes:
            assert last_s is None or now_s >= last_s + APART_S
            last_s = now_s
        disk |= {change.doc: change.document for change in changes}
        disk = {doc: document for doc, document in disk.items() if document is not None}
        if autosave.due_s is None:
            assert disk == unsaved
        else:
            assert autosave.due_s <= now_s + APART_S + REST_S


def application(name, doc="a2"):
    steps = (Icon(Onikon(name, "Complete job", "", (), blank())),)
    return OpenApplication(doc, Application("b", False, (AppFlow(steps),)))


def test_applications_that_are_not_saved_are_kept_too():  # R-X10
    autosave = Autosave()
    opened = application("grip")
    saved = replace(application("grip", "a3"), opened=OpenedText(opened.application, Path("/b.appl"), ""))
    autosave.look(Model(documents={"c1": document(1)}, applications={"a2": opened, "a3": saved}), 0.0)
    assert autosave.take(REST_S) == (UnsavedChange("c1", document(1)), UnsavedChange("a2", opened))
    judged = replace(opened, judgement=Judgement(opened.application))
    autosave.look(Model(documents={"c1": document(1)}, applications={"a2": judged}), 5.0)
    assert autosave.due_s is None, "what is wrong with it is no change"
    autosave.look(Model(documents={"c1": document(1)}), 9.0)
    assert autosave.take_all(9.0) == (UnsavedChange("a2", None),)
