from hypothesis import given, settings, strategies as st

from kit.sitting import Sitting
from onika.desk.environment.outcome.outcome import Done, Order
from onika.model.task import Task
from onika.wire import act, live, page, request

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


@settings(deadline=None, max_examples=60)
@given(done=st.lists(acts, max_size=25))
def test_a_page_that_follows_the_patches_has_the_tree(tmp_path_factory, done):  # R-X10
    sitting = Sitting(tmp_path_factory.mktemp("base"), TASKS)
    sitting.new()
    for one in done:
        sitting.answer(one)  # whose patches are compared with the tree, one by one


@settings(deadline=None, max_examples=60)
@given(done=st.lists(acts.filter(lambda one: not isinstance(one, act.Undo | act.Redo)), max_size=15))
def test_undo_goes_back_through_every_state_and_redo_forward(tmp_path_factory, done):  # R-X10
    sitting = Sitting(tmp_path_factory.mktemp("base"), TASKS)
    sitting.new()

    def content():
        return sitting.environment.model.documents["c1"].content

    states = [content()]
    for one in done:
        sitting.answer(one)
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
    sitting = Sitting(tmp_path, TASKS)
    doc = sitting.new("a")
    assert sitting.environment.tree.documents[doc].undo == "placing a"
    sitting.do(act.Undo(doc))
    assert sitting.environment.tree.documents[doc].redo == "placing a"


def test_an_observer_is_told_of_every_act_and_its_end(tmp_path):  # R-H01
    sitting, seen = Sitting(tmp_path, TASKS), []
    sitting.environment.observers.append(lambda asked, by, given: seen.append((type(asked), by, given.no is None)))
    sitting.do(act.New(), by="anna")
    sitting.no(act.Undo("c1"))
    assert seen == [(act.New, "anna", True), (act.Undo, "me", False)]


def test_an_act_that_waits_for_the_runtime_is_answered_when_that_has_replied(tmp_path):
    sitting, given = Sitting(tmp_path, TASKS), []
    order = Order(live.Survey(), lambda model, response: Done(model, value=response.reason))

    def ask(model, _asked, _outside):
        return Done(model, orders=(order,), is_answered_later=True)

    sitting.environment._handlers = {act.Note: ask}
    sitting.environment.do(act.Note("x"), "me", given.append)
    assert given == []
    assert sitting.orders == [order]
    sitting.environment.replied(order, request.Refused("not now"))
    assert [one.value for one in given] == ["not now"]


def test_a_change_from_outside_reaches_every_page(tmp_path):
    sitting = Sitting(tmp_path, TASKS)
    said = page.Say("info", "a word")
    sitting.environment.become(lambda model: Done(model, says=(said,)))
    assert sitting.says == [said]
