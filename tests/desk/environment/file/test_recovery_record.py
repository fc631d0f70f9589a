from dataclasses import replace
from pathlib import Path

import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.file.recovery_record import (
    RecoveryRecord,
    application_of,
    document_of,
    read,
    rescue_of,
    write,
)
from onika.desk.environment.state.content import Content, KeptConfiguration
from onika.desk.environment.state.document import Document
from onika.model.configuration import Configuration, Placed
from onika.model.own_lines import OwnLines
from onika.model.task import LocalLine
from onika.store.base_directory import BaseDirectory
from onika.wire import act
from onika.words.fault import Refusal


@pytest.fixture
def document(tmp_path):
    base = BaseDirectory(tmp_path)
    opened = base.save_configuration(Configuration("move", (Placed("pd", 1, 2),)))
    assert not isinstance(opened, Refusal)
    content = Content(Configuration("move", (Placed("pd", 3, 4, frequency=50.0), Placed("robot"))))
    return Document("c7", content, opened=opened, base=tmp_path)


def test_a_document_comes_back_as_it_was_and_as_unsaved(document):  # R-X10
    again = document_of(read(write(rescue_of(document))), "c2")
    assert again == replace(document, id="c2")
    assert again.is_dirty
    assert not again.has_changed_on_disk


def test_what_a_task_says_otherwise_here_comes_back_with_it(document):  # R-B09, R-X10
    own = OwnLines((("Q", "Q_LEFT"),), (LocalLine("STIFF", ("0.5",)),), ("DAMP",))
    tuned = Configuration("move", (Placed("pd_left", own=own, rmod="pd"),))
    again = document_of(read(write(rescue_of(replace(document, content=Content(tuned))))), "c2")
    assert again.content.configuration.placed == tuned.placed


def test_what_is_kept_alive_and_not_saved_comes_back_as_a_document_of_its_own(document):  # R-C32, R-X10
    own = OwnLines(local=(LocalLine("STIFF", ("0.5",)),))
    tuned = Configuration("tuned", (Placed("pd", own=own),))
    kept = (KeptConfiguration(tuned), KeptConfiguration(document.opened.value, document.opened, document.base))
    keeper = replace(document, content=replace(document.content, kept=kept))
    main, other = read(write(rescue_of(keeper))).every
    assert document_of(main, "c7") == document
    assert document_of(other, "c8").content == Content(tuned) and document_of(other, "c8").is_dirty


def test_a_document_without_a_file_comes_back_too():
    document = Document("c1", Content(Configuration("Untitled-1", (Placed("pd"),))))
    assert document_of(rescue_of(document), "c1") == document
    assert document_of(rescue_of(document), "c1", "Untitled-2").name == "Untitled-2"


@pytest.mark.parametrize("change", [lambda path: path.write_text("EOF\n"), Path.unlink])
def test_a_file_that_has_changed_meanwhile_is_not_overwritten_unseen(document, change):  # R-B07
    record = rescue_of(document)
    change(document.opened.path)
    again = document_of(record, "c1")
    assert again.has_changed_on_disk
    assert isinstance(BaseDirectory(again.base).save_configuration(again.content.configuration, again.opened), Refusal)


@pytest.mark.parametrize("content", ["", "{", "[]", '{"name": "x"}'])
def test_what_is_no_rescue_raises(content):
    with pytest.raises(ValueError, match=r"\w"):
        read(content)


def test_a_text_that_is_no_configuration_raises():
    with pytest.raises(ValueError, match="EOF"):
        document_of(RecoveryRecord("x", "nonsense"), "c1")


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_an_application_comes_back_as_it_was_and_as_unsaved(gallery):  # R-X10
    doc = gallery.begun("grip", "move")
    gallery.do(act.Save(doc, "job1", str(gallery.base.path)))
    gallery.do(act.SetBreakpoint(doc, (gallery.number(doc, "grip"),)))
    opened, syntax = gallery.environment.model.applications[doc], gallery.environment.model.syntax
    record = read(write(rescue_of(opened)))
    assert record.kind == ".appl"
    again = application_of(record, "a9", syntax)
    assert (again.application, again.opened.value) == (opened.application, opened.opened.value)
    assert (again.is_dirty, again.has_changed_on_disk, again.is_partial, again.base) == (
        True,
        False,
        False,
        opened.base,
    )
    assert all(step.number for step in again.application.flows[0].steps)
    opened.opened.path.write_text("EOF\n")
    assert application_of(record, "a9", syntax).has_changed_on_disk


def test_an_application_without_a_file_comes_back_under_a_free_name(gallery):
    doc = gallery.begun("grip")
    record = rescue_of(gallery.environment.model.applications[doc])
    again = application_of(record, "a5", gallery.environment.model.syntax, "Untitled-7")
    assert (again.name, again.opened, again.is_dirty) == ("Untitled-7", None, True)
    with pytest.raises(ValueError, match="expected"):
        application_of(replace(record, text=""), "a5", gallery.environment.model.syntax)


def test_one_whose_file_could_be_read_in_part_still_asks_before_it_is_saved(gallery):
    doc = gallery.begun("grip")
    path = gallery.base.application_file("job1")
    gallery.do(act.Save(doc, "job1", str(gallery.base.path)))
    gallery.do(act.Close(doc))
    path.write_text(path.read_text().replace("EOF", ""))
    doc = gallery.do(act.Open(str(path)))
    gallery.add(doc, "open")
    opened = gallery.environment.model.applications[doc]
    again = application_of(rescue_of(opened), "a9", gallery.environment.model.syntax)
    assert again.is_partial
    assert again.file_faults
