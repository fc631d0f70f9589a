import pytest

from kit.desk.dictionary_fixture import WHITE, DictionaryFixture, plain
from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.button import Button
from onika.model.task import Task
from onika.wire import act


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (Task("pd", "pd", invar=("Q",), outvar=("TAU",), frequency=100.0),))


@pytest.fixture
def cabinet(tmp_path):
    return DictionaryFixture(tmp_path, plain("grip"), plain("rest", "Pause object", "a while", (1.0,)))


def test_preferences_are_taken_back_and_done_again(sitting):  # R-X10
    sitting.do(act.Prefer({"pin_length": 9, "shows_period": True}))
    assert str(sitting.environment.tree.own_undo) == "changing preferences"
    sitting.do(act.Undo(""))
    shown = sitting.environment.tree.preferences
    assert (shown["pin_length"] != 9, shown["shows_period"]) == (True, False)
    sitting.do(act.Redo(""))
    assert sitting.environment.tree.preferences["pin_length"] == 9


def test_what_was_preferred_already_is_no_step(sitting):  # R-X10
    sitting.do(act.Prefer({"shows_period": False}))
    assert str(sitting.environment.tree.own_undo) == ""
    assert "nothing" in str(sitting.no(act.Undo("")).reason)
    assert "nothing" in str(sitting.no(act.Redo("")).reason)


def test_a_button_that_was_changed_or_removed_comes_back(sitting):  # R-X10, R-G02
    sitting.do(act.SetButton("tea", "echo tea"))
    sitting.do(act.SetButton("tea", "echo coffee"))
    sitting.do(act.SetButton("tea", ""))
    sitting.do(act.Undo(""))
    assert sitting.site.buttons()[0] == (Button("tea", "echo coffee"),)
    sitting.do(act.Undo(""))
    assert sitting.site.buttons()[0] == (Button("tea", "echo tea"),)
    sitting.do(act.Undo(""))
    assert sitting.site.buttons()[0] == ()


def test_a_rate_of_the_library_is_taken_back(sitting):  # R-X10, reading 10
    sitting.do(act.LibraryRate("pd", 50.0))
    sitting.do(act.Undo(""))
    assert sitting.environment.tree.tasks["pd"].hz == 100.0
    sitting.do(act.Redo(""))
    assert sitting.environment.tree.tasks["pd"].hz == 50.0


def test_an_icon_that_was_edited_or_deleted_comes_back_as_it_was(cabinet):  # R-X10, R-D05
    path = cabinet.base.onikon_file("rest")
    first = path.read_text()
    cabinet.do(act.EditOnikon("rest", "for long", (("9",),), WHITE))
    edited = path.read_text()
    cabinet.do(act.RemoveOnikon("rest", confirmed=True))
    assert not path.exists()
    cabinet.do(act.Undo(""))
    assert path.read_text() == edited and cabinet.icon("rest").description == "for long"
    cabinet.do(act.Undo(""))
    assert path.read_text() == first and cabinet.icon("rest").description == "a while"
    cabinet.do(act.Redo(""))
    assert path.read_text() == edited


def test_a_file_that_somebody_changed_since_is_left_alone(cabinet):  # R-X10, R-B07
    path = cabinet.base.onikon_file("rest")
    cabinet.do(act.EditOnikon("rest", "for long"))
    path.write_text(path.read_text() + "# by hand\n")
    theirs = path.read_text()
    assert str(path) in str(cabinet.no(act.Undo("")).reason)
    assert path.read_text() == theirs


def labels(sitting, doc):
    shown = sitting.environment.tree.documents[doc]
    return str(shown.undo), str(shown.redo)


def test_steps_of_a_file_and_of_none_are_taken_back_in_the_order_in_which_they_were_done(sitting):  # R-X10
    doc = sitting.new()
    sitting.do(act.Place(doc, "pd", 10, 10))
    placed, _ = labels(sitting, doc)
    sitting.do(act.Prefer({"pin_length": 9}))
    sitting.do(act.SetButton("tea", "echo tea"))
    sitting.do(act.Undo(doc))
    assert sitting.site.buttons()[0] == ()
    assert labels(sitting, doc)[0] == "changing preferences"
    sitting.do(act.Undo(doc))
    assert sitting.environment.tree.preferences["pin_length"] != 9
    assert labels(sitting, doc) == (placed, "changing preferences")
    sitting.do(act.Undo(doc))
    assert sitting.environment.tree.documents[doc].tasks == {}
    assert labels(sitting, doc) == ("", placed)
    for _ in range(3):
        sitting.do(act.Redo(doc))
    assert set(sitting.environment.tree.documents[doc].tasks) == {"pd"}
    assert sitting.environment.tree.preferences["pin_length"] == 9
    assert sitting.site.buttons()[0] == (Button("tea", "echo tea"),)
    assert labels(sitting, doc)[1] == ""


def test_a_step_of_a_file_that_came_later_goes_first(sitting):  # R-X10
    doc = sitting.new()
    sitting.do(act.Prefer({"pin_length": 9}))
    sitting.do(act.Place(doc, "pd", 10, 10))
    sitting.do(act.Undo(doc))
    assert sitting.environment.tree.documents[doc].tasks == {}
    assert sitting.environment.tree.preferences["pin_length"] == 9


def test_what_was_taken_back_last_is_done_again_first(sitting):  # R-X10
    doc = sitting.new()
    sitting.do(act.Prefer({"pin_length": 9}))
    sitting.do(act.Undo(doc))
    sitting.do(act.Place(doc, "pd", 10, 10))
    sitting.do(act.Undo(doc))
    sitting.do(act.Redo(doc))
    assert set(sitting.environment.tree.documents[doc].tasks) == {"pd"}
    assert labels(sitting, doc)[1] == "changing preferences"


def test_without_a_file_only_what_belongs_to_none_is_taken_back(sitting):  # R-X10
    doc = sitting.new()
    sitting.do(act.Prefer({"pin_length": 9}))
    sitting.do(act.Place(doc, "pd", 10, 10))
    sitting.do(act.Undo(""))
    assert sitting.environment.tree.preferences["pin_length"] != 9
    assert set(sitting.environment.tree.documents[doc].tasks) == {"pd"}


def test_on_a_file_that_is_closed_nothing_is_taken_back(sitting):  # R-X10
    sitting.do(act.Prefer({"pin_length": 9}))
    assert sitting.no(act.Undo("d99")).reason.key == "run.configuration_closed"
    assert sitting.environment.tree.preferences["pin_length"] == 9
