from dataclasses import replace

import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.outcome.outcome import Done
from onika.wire import act


@pytest.fixture
def shared(tmp_path):
    """An application that two browsers look at."""
    fixture = AppFixture(tmp_path)
    fixture.environment.become(lambda model: Done(replace(model, people=2)))
    return fixture


def notices(sitting):
    return [say.text.key for say in sitting.says if say.text.key.endswith("_elsewhere")]


def test_taking_back_what_another_did_is_told_to_both(shared):  # R-X10
    doc = shared.begun()
    shared.do(act.InsertIcon(doc, "open", "0", 0), by="first")
    shared.do(act.Undo(doc), by="second")
    assert notices(shared) == ["run.undone_elsewhere"]
    shared.do(act.Redo(doc), by="second")
    assert notices(shared)[1] == "run.redone_elsewhere"


def test_so_it_is_of_what_belongs_to_no_file(shared):  # R-X10
    doc = shared.begun()
    shared.do(act.Prefer({"pin_length": 9}), by="first")
    shared.do(act.Undo(doc), by="second")
    shared.do(act.Redo(doc), by="second")
    assert notices(shared) == ["run.own_undone_elsewhere", "run.own_redone_elsewhere"]


def test_taking_back_what_one_did_oneself_needs_no_word(shared):  # R-X10
    doc = shared.begun()
    shared.add(doc, "open")
    shared.do(act.Undo(doc))
    shared.do(act.Redo(doc))
    assert not notices(shared)


def test_who_is_alone_has_nobody_to_tell(shared):
    doc = shared.begun()
    shared.add(doc, "open")
    shared.environment.become(lambda model: Done(replace(model, people=1)))
    shared.do(act.Undo(doc), by="the same, with the page loaded anew")
    assert not notices(shared)
