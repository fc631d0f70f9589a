import threading
from queue import Queue

import pytest

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.worker import Aside
from onika.desk.environment.state.model import Model
from onika.wire import request


@pytest.fixture
def changes():
    return Queue()


@pytest.fixture
def aside(changes):
    one = Aside(changes.put)
    yield one
    one.close()


def outcome(changes, model):
    """What comes of the next work, as an environment learns of it."""
    ((order, response),) = changes.get(timeout=30)(model).replies
    return order, order.then(model, response), response


def test_what_comes_of_work_is_the_reply_to_its_order(aside, changes):
    model = Model()
    order = aside.order(lambda: lambda model: Done(model, value=threading.get_ident()))
    replied, done, response = outcome(changes, model)
    assert replied is order and order.is_kept and isinstance(response, request.Done)
    assert done.value == threading.get_ident()  # it is made of the model of here


def test_work_is_done_elsewhere_in_the_order_in_which_it_was_asked_for(aside, changes):
    def work():
        places.append(threading.get_ident())
        number = len(places)
        return lambda model: Done(model, value=number)

    places = []
    for _ in range(3):
        aside.order(work)
    found = [outcome(changes, Model())[1].value for _ in range(3)]
    assert found == [1, 2, 3]
    assert len(set(places)) == 1 and places[0] != threading.get_ident()


def test_a_no_is_an_outcome_like_any_other(aside, changes):
    aside.order(lambda: lambda _: No("no such file"))
    assert outcome(changes, Model())[1] == No("no such file")


def test_a_fault_of_the_program_is_raised_where_acts_are_carried_out(aside, changes):
    def work():
        raise RuntimeError("a bug")

    aside.order(work)
    change = changes.get(timeout=30)
    ((order, response),) = change(Model()).replies
    with pytest.raises(RuntimeError, match="a bug"):
        order.then(Model(), response)


def test_one_that_fails_does_not_keep_the_next_from_being_done(aside, changes):
    def work():
        raise RuntimeError("a bug")

    aside.do(work)
    aside.order(lambda: Done)
    with pytest.raises(RuntimeError, match="a bug"):
        changes.get(timeout=30)(Model())
    assert isinstance(outcome(changes, Model())[1], Done)


def test_nothing_is_told_once_it_is_closed(aside, changes):
    begun, go_on = threading.Event(), threading.Event()

    def work():
        begun.set()
        go_on.wait(30)
        return Done

    last = threading.Event()
    aside.order(work)
    aside.order(last.set)
    begun.wait(30)
    aside.close()
    go_on.set()
    aside._thread.join(30)
    assert changes.empty() and not last.is_set()


def test_what_needs_no_answer_is_done_too(aside):
    done = threading.Event()
    aside.do(done.set)
    assert done.wait(30)
