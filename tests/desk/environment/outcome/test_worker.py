import threading
from queue import Queue

import pytest

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.state.model import Model
from onika.words.reason import Reason


@pytest.fixture
def changes():
    return Queue()


@pytest.fixture
def aside(changes):
    worker = BackgroundWorker(changes.put)
    yield worker
    worker.close()


def news(changes):
    """What the next work has come to, as an environment learns of it."""
    (result,) = changes.get(timeout=30)(Model()).news
    return result


def test_the_result_of_work_is_news_for_whoever_waits_for_it(aside, changes):
    aside.answer(lambda: "read", "the file")
    assert news(changes) == ("the file", "read")


def test_work_is_done_elsewhere_in_the_order_in_which_it_was_asked_for(aside, changes):
    def work():
        places.append(threading.get_ident())
        return len(places)

    places = []
    for name in "abc":
        aside.answer(work, name)
    assert [news(changes) for _ in range(3)] == [("a", 1), ("b", 2), ("c", 3)]
    assert len(set(places)) == 1 and places[0] != threading.get_ident()


def test_a_no_is_a_result_like_any_other(aside, changes):
    aside.answer(lambda: No(Reason.plain("no such file")), "the file")
    assert news(changes) == ("the file", No(Reason.plain("no such file")))


def test_a_fault_of_the_program_is_raised_where_acts_are_carried_out(aside, changes):
    def work():
        raise RuntimeError("a bug")

    aside.answer(work, "the file")
    with pytest.raises(RuntimeError, match="a bug"):
        changes.get(timeout=30)(Model())


def test_work_that_fails_does_not_keep_the_next_from_being_done(aside, changes):
    def work():
        raise RuntimeError("a bug")

    aside.do(work)
    aside.answer(lambda: "read", "the file")
    with pytest.raises(RuntimeError, match="a bug"):
        changes.get(timeout=30)(Model())
    assert news(changes) == ("the file", "read")


def test_nothing_is_told_once_it_is_closed(aside, changes):
    begun, go_on = threading.Event(), threading.Event()

    def work():
        begun.set()
        go_on.wait(30)

    last = threading.Event()
    aside.answer(work, "first")
    aside.answer(last.set, "last")
    begun.wait(30)
    aside.close()
    go_on.set()
    aside._thread.join(30)
    assert changes.empty() and not last.is_set()


def test_how_far_work_is_reaches_the_environment_meanwhile(aside, changes):
    aside.do(lambda: aside.tell(lambda model: Done(model, value="half")))
    assert changes.get(timeout=30)(Model()).value == "half"


def test_what_needs_no_answer_is_done_too(aside):
    done = threading.Event()
    aside.do(done.set)
    assert done.wait(30)
