import pytest

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.history import History, UndoStep
from onika.model.configuration import Configuration

HERE = Content(Configuration("c"))


def step(label):
    return UndoStep(label, "me", HERE, HERE)


def test_steps_are_taken_back_newest_first_and_done_again_oldest_first():  # R-X10
    history = History().done(step("a")).done(step("b"))
    assert history.last.label == "b"
    once = history.undone(0)
    assert (once.last.label, once.next.label) == ("a", "b")
    assert once.undone(0).redone(0) == once
    assert once.redone(0) == history


def test_a_new_step_ends_what_could_be_done_again():  # R-X10
    assert History().done(step("a")).undone(0).done(step("b")).next is None


def test_there_is_no_step_before_the_first_and_none_after_the_last():
    assert (History().last, History().next) == (None, None)
    with pytest.raises(IndexError):
        History().undone(0)
    with pytest.raises(IndexError):
        History().redone(0)


def test_a_long_past_is_cut_at_its_beginning():
    history = History()
    for number in range(600):
        history = history.done(step(str(number)))
    assert (len(history.past), history.last.label) == (500, "599")
