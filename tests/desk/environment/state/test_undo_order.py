from dataclasses import replace

import pytest

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import History, UndoStep
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.undo_order import label_of, redoable, undoable
from onika.model.configuration import Configuration
from onika.wire import act
from onika.words.reason import NOTHING, Reason


def step(label, number):
    return UndoStep(Reason.plain(label), "", act.Prefer({}), act.Prefer({}), number)


def history(past=(), future=()):
    return History(tuple(step(*row) for row in past), tuple(step(*row) for row in future))


def situation(of_file, own):
    file = replace(Document("d1", Content(Configuration("a"))), history=of_file)
    return Model(documents={"d1": file}, own=own), file


@pytest.mark.parametrize(
    ("of_file", "own", "label"),
    [((), (), ""), ([("place", 1)], (), "place"), ((), [("prefer", 1)], "prefer"),
     ([("place", 2)], [("prefer", 1)], "place"), ([("place", 1)], [("prefer", 2)], "prefer")],
)  # fmt: skip
def test_the_later_of_two_steps_is_taken_back_and_done_again_first(of_file, own, label):  # R-X10
    model, file = situation(history(past=of_file), history(past=own))
    assert str(label_of(undoable(model, file))) == label
    model, file = situation(history(future=of_file), history(future=own))
    assert str(label_of(redoable(model, file))) == label


def test_without_a_file_there_is_what_belongs_to_none():  # R-X10
    model, _ = situation(history([("place", 2)]), history([("prefer", 1)]))
    assert str(label_of(undoable(model, None))) == "prefer"
    assert label_of(redoable(model, None)) is NOTHING


def test_the_next_step_has_a_larger_number_than_all_that_are_kept():  # R-X10
    model, _ = situation(history([("place", 2)], [("move", 5)]), history([("prefer", 4)]))
    assert model.next_step == 6
    assert Model().next_step == 1


def test_a_step_that_is_taken_back_or_done_again_is_the_newest():  # R-X10
    undone = history([("place", 1), ("move", 2)]).undone(7)
    assert (undone.last.number, undone.next.number, undone.newest) == (1, 7, 7)
    assert undone.redone(8).last.number == 8
