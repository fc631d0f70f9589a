from dataclasses import replace
from pathlib import Path

import pytest

from onika.desk.environment.content import Content
from onika.desk.environment.document import Document
from onika.desk.environment.rescue import Rescue, document_of, read, rescue_of, write
from onika.model.configuration import Configuration, Placed
from onika.store.base_directory import BaseDirectory
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


def test_a_document_without_a_file_comes_back_too():
    document = Document("c1", Content(Configuration("Untitled-1", (Placed("pd"),))))
    assert document_of(rescue_of(document), "c1") == document
    assert document_of(rescue_of(document), "c1", "Untitled-2").name == "Untitled-2"


@pytest.mark.parametrize("change", [lambda path: path.write_text("EOF\n"), Path.unlink])
def test_a_file_that_has_changed_meanwhile_is_not_overwritten_unseen(document, change):  # R-B07
    rescue = rescue_of(document)
    change(document.opened.path)
    again = document_of(rescue, "c1")
    assert again.has_changed_on_disk
    assert isinstance(BaseDirectory(again.base).save_configuration(again.content.configuration, again.opened), Refusal)


@pytest.mark.parametrize("content", ["", "{", "[]", '{"name": "x"}'])
def test_what_is_no_rescue_raises(content):
    with pytest.raises(ValueError, match=r"\w"):
        read(content)


def test_a_text_that_is_no_configuration_raises():
    with pytest.raises(ValueError, match="EOF"):
        document_of(Rescue("x", "nonsense"), "c1")
