from pathlib import Path

import pytest

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.store.opened_text import OpenedText

FILE = OpenedText(Configuration("lamp"), Path("/conf/lamp.conf"), "as it was read")
LAMP = Document("c1", Content(Configuration("lamp")), opened=FILE)
PLAY = OpenApplication("a2", Application("play", False, ()))


@pytest.mark.parametrize("kind", list(DocumentKind))
def test_an_id_says_the_kind_of_what_is_or_was_open(kind):
    assert DocumentKind.of(kind.id(17)) is kind


def test_the_ids_of_both_kinds_are_those_that_pages_know():
    assert [kind.id(1) for kind in DocumentKind] == ["c1", "a1"]


def test_what_is_open_knows_its_kind_and_what_its_file_would_hold():
    assert (LAMP.kind, LAMP.value) == (DocumentKind.CONFIGURATION, Configuration("lamp"))
    assert (PLAY.kind, PLAY.value) == (DocumentKind.APPLICATION, PLAY.application)


def test_it_stays_itself_where_nothing_new_is_known_of_its_file():
    assert LAMP.differing(False) is LAMP
    assert LAMP.differing(True).has_changed_on_disk


def test_what_its_file_was_seen_to_hold_is_what_the_next_save_overwrites():
    assert LAMP.seen("as another wrote it").opened.text == "as another wrote it"
    assert PLAY.seen("there is no file") is PLAY
