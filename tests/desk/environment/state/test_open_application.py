from dataclasses import replace
from pathlib import Path

from kit.desk.app_fixture import ONIKONS
from onika.desk.environment.state.open_application import Judgement, OpenApplication
from onika.model.application import AppFlow, Application, Icon
from onika.store.opened_text import OpenedText

EMPTY = Application("a", False, (AppFlow(()),))
GRIP = Application("a", False, (AppFlow((Icon(ONIKONS[0], number=1),)),))


def test_without_a_file_it_is_unsaved_as_soon_as_something_is_in_it():
    assert not OpenApplication("a1", EMPTY).is_dirty
    assert OpenApplication("a1", GRIP).is_dirty


def test_with_a_file_it_is_unsaved_where_it_says_something_else_numbers_aside():  # R-D05
    numbered = replace(GRIP, flows=(AppFlow((Icon(ONIKONS[0], number=7),)),))
    opened = OpenApplication("a1", GRIP, opened=OpenedText(numbered, Path("/a.appl"), ""))
    assert not opened.is_dirty
    assert opened.having(EMPTY).is_dirty
    assert opened.name == "a"


def test_a_judgement_is_of_what_was_there_when_it_was_looked_at():
    opened = replace(OpenApplication("a1", GRIP), judgement=Judgement(GRIP))
    assert opened.is_judged
    assert not opened.having(EMPTY).is_judged
