import pytest
from hypothesis import given, settings, strategies as st

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from kit.examples import examples
from onika.desk.environment.reconcile.reconciliation import accepted, edited
from onika.model.lifecycle import State
from onika.model.task import Task
from onika.wire import act, event, live, request
from onika.words.reason import Reason

TASKS = tuple(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b", "c"))
FAULT = request.FaultText(
    "/base/module/b.py", 7, Reason.plain("expected a port X, found none"), Reason.plain("nothing is changed")
)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def test_what_a_runtime_finds_wrong_is_refused_with_its_sentences_and_taken_back(duet):  # R-X01, R-X10
    doc = duet.connected("a")
    before = duet.document(doc)
    duet.rebuffs = {live.Change: request.Prepared((FAULT,))}
    refused = duet.answer(act.Place(doc, "b", 300, 0)).no
    assert refused is not None and str(refused.reason) == "b.py:7: expected a port X, found none"
    after = duet.document(doc)
    assert after.content == before.content and after.history == before.history
    assert set(after.live.tasks) == {"a"} and not after.live.pending


def test_a_change_that_fails_on_its_way_is_taken_back_and_told(duet):  # R-X10
    doc = duet.connected("a")
    duet.runtime.lives["Untitled-1"].pop("a")  # so that killing it fails
    duet.do(act.Remove(doc, ("a",)))
    assert duet.document(doc).content.names == ("a",) and str(duet.document(doc).history.last.label) == "placing a"
    assert [str(say.text) for say in duet.says if say.level == "error"] == ["nothing is changed: there is no task a"]


def test_what_was_done_meanwhile_stays_when_an_older_change_fails(duet):  # R-X10
    doc = duet.connected("a")
    duet.is_held_back = True
    duet.environment.do(act.Place(doc, "b", 300, 0), "me", lambda given: None)
    duet.environment.do(act.Move(doc, {"a": (70, 70)}), "me", lambda given: None)
    duet.is_held_back, duet.rebuffs = False, {live.Change: request.Refused(Reason.plain("no time for it"))}
    duet.pump()
    now = duet.document(doc)
    assert now.content.names == ("a",) and (now.content.placed("a").x, now.content.placed("a").y) == (70, 70)
    assert [str(entry.label) for entry in now.history.past] == ["placing a", "moving a"]


def test_a_library_that_was_changed_for_it_is_as_it_was(duet):  # reading 9, R-X10
    doc = duet.connected("a")
    duet.rebuffs = {live.Change: request.Refused(Reason.plain("they disagree"))}
    duet.alias("a", "A", "OTHER")
    assert str(duet.says[-1].text) == "they disagree"
    assert duet.environment.model.libraries.edits == {} and duet.state(doc, "a") == "OFF"


def test_an_undo_that_the_runtime_refuses_can_be_tried_again(duet):  # R-X10
    doc = duet.connected("a")
    duet.do(act.Remove(doc, ("a",)))
    duet.rebuffs = {live.Change: request.Refused(Reason.plain("not now"))}
    assert str(duet.answer(act.Undo(doc)).no.reason) == "not now"
    duet.rebuffs = {}
    duet.do(act.Undo(doc))
    assert duet.state(doc, "a") == "OFF"


@pytest.mark.parametrize("cause", ["", "no sensor"])
def test_an_outcome_may_come_before_its_change_is_accepted(duet, cause):
    doc = duet.connected()
    duet.is_held_back = True
    duet.environment.do(act.Place(doc, "a", 0, 0), "me", lambda given: None)
    reason = Reason.plain(cause)
    model = edited(duet.environment.model, doc, 17, reason).model
    assert model.documents[doc].live.early == {17: reason}
    key = next(iter(model.documents[doc].live.pending))
    document = accepted(model, live.Accepted(17), doc, key).model.documents[doc]
    assert not document.live.pending and not document.live.early
    assert document.content.names == (() if cause else ("a",))


def test_somebody_elses_change_is_looked_at(duet):  # R-C12
    doc = duet.connected("a")
    duet.runtime.ask(live.Change("Untitled-1", kill=("a",)))
    duet.hear()
    duet.pump()
    assert duet.state(doc, "a") == "" and duet.document(doc).content.names == ("a",)


def test_a_task_that_is_done_before_its_change_is_told_is_wanted_no_more(duet):
    doc = duet.connected("a")
    duet.do(act.Turn(doc, ("a",), is_on=True))
    duet.tell(event.TaskState("Untitled-1", "a", "OFF", 1.0))
    assert duet.document(doc).content.wanted == {"a": False}


def answers_of(duet, *requests):
    """The answers to acts that nobody waits for, one list each."""
    given = [[] for _ in requests]
    for wish, answers in zip(requests, given, strict=True):
        duet.environment.do(wish, "me", answers.append)
    return given


@pytest.fixture
def busy(duet):
    """A document whose first change is under way."""
    doc = duet.connected("a")
    duet.is_held_back = True
    answers_of(duet, act.Remove(doc, ("a",)))
    return doc


def go(duet):
    duet.is_held_back = False
    duet.pump()


def test_what_is_done_meanwhile_goes_out_as_one_change_and_is_answered_with_it(duet, busy):  # R-X10
    first, second = answers_of(duet, act.Place(busy, "b", 0, 0), act.Place(busy, "c", 300, 0))
    assert not first and not second
    go(duet)
    assert [answer.no for answer in (*first, *second)] == [None, None]
    assert {task.name for task in duet.edits()[-1].spawn} == {"b", "c"}


def test_what_waited_is_refused_with_the_reason_of_the_change_that_carried_it(duet, busy):  # R-X01
    (first,) = answers_of(duet, act.Place(busy, "b", 0, 0))
    duet.is_held_back = False
    order = duet._waiting.popleft()
    duet.environment.replied(order, duet.runtime.ask(order.asked))
    duet.rebuffs = {live.Change: request.Prepared((FAULT,))}
    duet.hear()
    duet.pump()
    assert [str(answer.no.reason) for answer in first] == ["b.py:7: expected a port X, found none"]
    assert duet.document(busy).content.names == ()


def test_what_takes_itself_back_before_it_goes_out_is_done(duet, busy):  # R-X10
    first, second = answers_of(duet, act.Place(busy, "b", 0, 0), act.Undo(busy))
    go(duet)
    assert [answer.no for answer in (*first, *second)] == [None, None] and len(duet.edits()) == 2


def test_what_cannot_be_asked_any_more_is_refused_and_taken_back(duet, busy):  # law 27
    (first,) = answers_of(duet, act.Place(busy, "b", 0, 0))
    duet.environment.receive(event.Stopped(True, Reason.plain("enough")))
    go(duet)
    assert [str(answer.no.reason) for answer in first] == ["everything is stopped: allow motion again first"]
    assert duet.document(busy).content.names == ()


@pytest.mark.parametrize("ending", [act.Close("c1", discards=True), act.Disconnect("c1")])
def test_nobody_waits_for_a_document_that_is_left(duet, busy, ending):  # R-C06
    (first,) = answers_of(duet, act.Place(busy, "b", 0, 0))
    answers_of(duet, ending)
    assert [str(answer.no.reason) for answer in first] == ["Untitled-1 is no longer connected"]
    go(duet)


def test_what_moves_no_task_waits_for_nothing(duet, busy):  # R-X09
    doc = duet.new("b")
    duet.is_held_back = False
    duet.pump()
    duet.do(act.Connect(doc))
    duet.is_held_back = True
    answers_of(duet, act.Place(doc, "c", 300, 0))
    (moved,) = answers_of(duet, act.Move(doc, {"b": (7, 7)}))
    assert [answer.no for answer in moved] == [None]


class Moody(LiveRuntime):
    """Carries changes out, refuses them, or lets them fail on their way, as it was told."""

    def __init__(self, moods):
        super().__init__()
        self.moods = list(moods)

    def ask(self, wish):
        mood = self.moods.pop(0) if self.moods and isinstance(wish, live.Change) else "done"
        if mood == "refused":
            return request.Refused(Reason.plain("not now"))
        if mood == "faults":
            return request.Prepared((FAULT,))
        if mood == "fails":
            self._numbers += 1
            self.tell(event.Edited(wish.subsystem, self._numbers, Reason.plain("no sensor"), 0.0))
            return live.Accepted(self._numbers)
        return super().ask(wish)


names = st.sampled_from("abc")
acts = st.one_of(
    st.builds(act.Place, st.just("c1"), names, st.just(0), st.just(0)),
    st.builds(act.Remove, st.just("c1"), st.tuples(names)),
    st.builds(act.Toggle, st.just("c1"), names),
    st.builds(act.Exchange, st.just("c1"), names, names),
    st.builds(act.Rate, st.just("c1"), names, st.sampled_from((0.0, 5.0, 20.0))),
    st.builds(act.Unit, st.just("c1"), names, st.sampled_from(("rt0", "rt1"))),
    st.builds(lambda name, x: act.Move("c1", {name: (x, 0)}), names, st.integers(0, 9)),
    st.just(act.Undo("c1", confirmed=True)),
    st.just(act.Redo("c1", confirmed=True)),
    st.just("pump"),
    st.builds(lambda name: ("alias", name), names),
    st.builds(lambda name: ("finish", name), names),
)


@settings(deadline=None, max_examples=examples(150))
@given(
    done=st.lists(acts, max_size=20),
    moods=st.lists(st.sampled_from(("done", "done", "refused", "faults", "fails")), max_size=12),
)
def test_whatever_fails_document_and_runtime_agree_in_the_end(tmp_path_factory, done, moods):  # R-X10, law 22
    duet = FakeRuntimeEnv(tmp_path_factory.mktemp("base"), TASKS, Moody(moods))
    doc, answers, count = duet.new(), [], 0
    duet.do(act.Connect(doc))
    duet.is_held_back = True
    for entry in done:
        if entry == "pump":
            duet.is_held_back = False
            duet.pump()
            duet.is_held_back = True
        elif isinstance(entry, tuple) and entry[0] == "alias":
            duet.alias(entry[1], entry[1].upper(), f"Z{len(answers)}")
        elif isinstance(entry, tuple):
            finish(duet, entry[1])
        else:
            duet.environment.do(entry, "me", answers.append)
            count += 1
    duet.is_held_back = False
    duet.pump()
    assert len(answers) == count
    document, lives = duet.document(doc), duet.runtime.lives["Untitled-1"]
    assert not document.live.pending and not document.live.early
    assert {name: life.state.value for name, life in lives.items()} == {
        name: facts.state for name, facts in document.live.tasks.items()
    }
    assert set(document.content.names) == set(lives)
    for placed in document.content.configuration.placed:
        life, task = lives[placed.task], duet.environment.model.libraries.tasks[placed.task]
        assert document.content.wanted[placed.task] is (life.state is State.ON)
        assert life.task.aliases == task.aliases
        assert life.frequency == (placed.frequency or task.frequency)
        assert placed.rtpu in ("unknown", life.rtpu)


def finish(duet, name):
    """A task has done its job, by itself."""
    life = duet.runtime.lives.get("Untitled-1", {}).get(name)
    if life is not None and life.state is State.ON:
        life.state = State.OFF
        duet.runtime.tell(event.TaskState("Untitled-1", name, "OFF", 1.0))
        duet.hear()
