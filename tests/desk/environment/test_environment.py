from dataclasses import replace

import pytest
from hypothesis import given, settings, strategies as st

from kit.desk.environment_fixture import EnvironmentFixture
from kit.examples import examples
from onika.desk.environment.outcome.outcome import (
    Ask,
    AwaitedNews,
    Done,
    EditEnd,
    InterimModel,
    No,
    SubsystemChange,
    Work,
)
from onika.model.task import Task
from onika.wire import act, live, page, request
from onika.words.reason import Reason

NAMES = ("a", "b", "c", "d")
TASKS = tuple(Task(name, f"m{name}", invar=("Q",), outvar=(f"OUT_{name.upper()}",), frequency=10.0) for name in NAMES)
spots = st.integers(-300, 300)
names = st.sampled_from(NAMES)
acts = st.one_of(
    st.builds(act.Place, st.just("c1"), names, spots, spots),
    st.builds(act.Remove, st.just("c1"), st.tuples(names)),
    st.builds(act.Flip, st.just("c1"), st.tuples(names)),
    st.builds(lambda name, x, y: act.Move("c1", {name: (x, y)}), names, spots, spots),
    st.builds(lambda x, y: act.Move("c1", {}, {"Q": (x, y)}), spots, spots),
    st.builds(act.Show, st.just("c1"), st.just(("Q",)), st.booleans()),
    st.just(act.Undo("c1")),
    st.just(act.Redo("c1")),
)


@settings(deadline=None, max_examples=examples(60))
@given(done=st.lists(acts, max_size=25))
def test_a_page_that_follows_the_patches_has_the_tree(tmp_path_factory, done):  # R-X10
    sitting = EnvironmentFixture(tmp_path_factory.mktemp("base"), TASKS)
    sitting.new()
    for wish in done:
        sitting.answer(wish)  # whose patches are compared with the tree, one by one


@settings(deadline=None, max_examples=examples(60))
@given(done=st.lists(acts.filter(lambda wish: not isinstance(wish, act.Undo | act.Redo)), max_size=15))
def test_undo_goes_back_through_every_state_and_redo_forward(tmp_path_factory, done):  # R-X10
    sitting = EnvironmentFixture(tmp_path_factory.mktemp("base"), TASKS)
    sitting.new()

    def content():
        return sitting.environment.model.documents["c1"].content

    states = [content()]
    for wish in done:
        sitting.answer(wish)
        if content() != states[-1]:
            states.append(content())
    for state in reversed(states[:-1]):
        sitting.do(act.Undo("c1"))
        assert content() == state
    assert sitting.no(act.Undo("c1"))
    for state in states[1:]:
        sitting.do(act.Redo("c1"))
        assert content() == state
    assert sitting.no(act.Redo("c1"))


def test_every_step_is_told_by_its_label(tmp_path):  # R-X10
    sitting = EnvironmentFixture(tmp_path, TASKS)
    doc = sitting.new("a")
    assert str(sitting.environment.tree.documents[doc].undo) == "placing a"
    sitting.do(act.Undo(doc))
    assert str(sitting.environment.tree.documents[doc].redo) == "placing a"


def test_an_observer_is_told_of_every_act_and_its_end(tmp_path):  # R-H01
    sitting, seen = EnvironmentFixture(tmp_path, TASKS), []

    def observe(wish, by):
        return lambda given: seen.append((type(wish), by, given.no is None))

    sitting.environment.observers.append(observe)
    sitting.do(act.New(), by="anna")
    sitting.no(act.Undo("c1"))
    assert seen == [(act.New, "anna", True), (act.Undo, "me", False)]


@pytest.fixture
def begin(tmp_path):
    """Carries out a procedure as an act: the sitting, and the answers that it gets."""

    def begin(procedure):
        sitting, answers = EnvironmentFixture(tmp_path, TASKS), []
        sitting.environment._handlers = {act.Note: procedure, act.Company: lambda model, *_: Done(people(model, 9))}
        sitting.environment.do(act.Note("x"), "me", answers.append)
        return sitting, answers

    return begin


def people(model, count):
    return replace(model, people=count)


def test_an_act_that_waits_for_the_runtime_is_answered_when_that_has_replied(begin):
    def procedure(model, _act, _outside):
        model, response = yield Ask(model, live.Survey())
        return Done(model, value=response.reason)

    sitting, answers = begin(procedure)
    assert answers == []
    (order,) = sitting.orders
    sitting.environment.replied(order, request.Refused(Reason.plain("not now")))
    assert [str(answer.value) for answer in answers] == ["not now"]


def test_an_act_goes_on_with_the_model_of_then(begin):
    def procedure(model, _act, _outside):
        model, _ = yield Ask(people(model, 2), live.Survey())
        return Done(model, value=model.people)

    sitting, answers = begin(procedure)
    sitting.environment.do(act.Company(), "other", lambda answer: None)
    sitting.environment.replied(sitting.orders[0], request.Done())
    assert [answer.value for answer in answers] == [9]


def test_two_acts_that_ask_the_same_get_each_its_own_reply(begin):
    def procedure(model, _act, _outside):
        model, response = yield Ask(model, live.Survey())
        return Done(model, value=response.reason)

    sitting, answers = begin(procedure)
    sitting.environment.do(act.Note("y"), "other", answers.append)
    first, second = sitting.orders
    sitting.environment.replied(second, request.Refused(Reason.plain("second")))
    sitting.environment.replied(first, request.Refused(Reason.plain("first")))
    assert [str(answer.value) for answer in answers] == ["second", "first"]


def test_the_reply_to_an_order_that_was_sent_with_more_in_it_is_that_of_the_act(begin):  # R-X19
    def procedure(model, _act, _outside):
        model, response = yield Ask(model, live.Change("main", kill=("pd",)))
        return Done(model, value=response.number)

    sitting, answers = begin(procedure)
    sent = replace(sitting.orders[0], asked=live.Change("main", kill=("pd",), spawn=()))
    sitting.environment.replied(sent, live.Accepted(3))
    assert [answer.value for answer in answers] == [3]


def test_what_an_act_has_done_is_shown_while_it_waits_and_stays_where_it_is_refused_then(begin):  # R-X10
    def procedure(model, _act, _outside):
        model, _ = yield Ask(people(model, 2), live.Survey())
        model, _ = yield InterimModel(people(model, model.people + 1))
        return No(Reason.plain("not so many"))

    sitting, answers = begin(procedure)
    assert sitting.environment.model.people == 2
    sitting.environment.replied(sitting.orders[0], request.Done())
    assert sitting.environment.model.people == 3 and answers[0].no == No(Reason.plain("not so many"))


def test_an_act_may_wait_for_work_that_is_done_aside(begin):
    def procedure(model, _act, outside):
        model, result = yield Work(model, outside.reading, lambda: 6 * 7)
        return Done(model, value=result)

    sitting, answers = begin(procedure)
    sitting.become()
    assert [answer.value for answer in answers] == [42]


def test_an_act_may_wait_until_something_comes_by_itself_and_so_may_several(begin):
    def procedure(model, _act, _outside):
        model, news = yield AwaitedNews(model, EditEnd(7))
        return Done(model, value=news)

    sitting, answers = begin(procedure)
    sitting.environment.do(act.Note("y"), "other", answers.append)
    sitting.environment.become(lambda model: Done(model, news=((EditEnd(8), "another"),)))
    assert answers == []
    sitting.environment.become(lambda model: Done(model, news=((EditEnd(7), "it"),)))
    assert [answer.value for answer in answers] == ["it", "it"]


def test_a_refused_change_that_no_act_waits_for_is_worth_a_line(tmp_path):  # law 22
    sitting = EnvironmentFixture(tmp_path, TASKS)
    sitting.environment.become(
        lambda model: Done(model, news=((SubsystemChange("c1", 1), No(Reason.plain("they disagree"))),))
    )
    assert [(str(line.text), line.doc) for line in sitting.says] == [("they disagree", "c1")]


def test_a_change_from_outside_reaches_every_page(tmp_path):
    sitting = EnvironmentFixture(tmp_path, TASKS)
    say = page.Say("info", Reason.plain("a word"))
    sitting.environment.become(lambda model: Done(model, says=(say,)))
    assert sitting.says == [say]
