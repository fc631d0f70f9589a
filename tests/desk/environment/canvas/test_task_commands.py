from dataclasses import replace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from kit.labs.laboratory import Laboratory
from onika.desk.environment.outcome.outcome import Done
from onika.model.task import LocalLine, Task, TaskType
from onika.wire import act, event, live, request
from onika.words.reason import Reason

ITEM = event.Item("x", "double", 1, "m", "where to go", None, (0.0,), (1.0,))
TASKS = (
    Task("a", "a", outvar=("A",), frequency=10.0),
    Task("b", "b", outvar=("B",), frequency=10.0),
    Task("arm", "arm", outvar=("D",), frequency=100.0, local=(LocalLine("DEVICE", ("boxes:arm_left",)),)),
    Task("asks", "asks", outvar=("C",), type=TaskType.APERIODIC),
)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime(asks={"asks": (ITEM,)}))


def fail(duet, task="a"):
    duet.runtime.lives["Untitled-1"][task].state = type(duet.runtime.lives["Untitled-1"][task].state).ERROR
    duet.tell(event.TaskState("Untitled-1", task, "ERROR", 1.0))


def test_a_task_is_toggled_on_and_off(duet):  # R-C11
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    assert duet.state(doc, "a") == "ON" and str(duet.document(doc).history.last.label) == "turning a ON"
    duet.do(act.Toggle(doc, "a"))
    assert duet.state(doc, "a") == "OFF" and str(duet.document(doc).history.last.label) == "turning a OFF"


def test_several_are_turned_at_one_instant(duet):  # R-X10
    doc = duet.connected("a", "b")
    duet.do(act.Turn(doc, ("a", "b"), is_on=True))
    assert {task.task for task in duet.edits()[-1].on} == {"a", "b"}
    duet.do(act.Turn(doc, ("a", "b"), is_on=False))
    assert duet.edits()[-1].off == ("a", "b")


def test_what_is_on_already_is_left_alone(duet):
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    count = len(duet.edits())
    duet.do(act.Turn(doc, ("a",), is_on=True))
    assert len(duet.edits()) == count


def test_an_argument_line_answers_before_anything_is_asked(duet):  # law 25
    doc = duet.connected("asks")
    duet.do(act.Turn(doc, ("asks",), is_on=True, arguments="0.5"))
    assert duet.state(doc, "asks") == "ON" and duet.edits()[-1].on == (live.Turn("asks", "0.5"),)
    duet.do(act.Toggle(doc, "asks"))
    duet.do(act.Toggle(doc, "asks"))
    assert duet.state(doc, "asks") == "ASKING"  # a line is used once


def test_a_question_is_answered_and_one_that_nobody_asks_is_not(duet):  # R-C13
    doc = duet.connected("asks")
    assert "asks for nothing" in str(duet.no(act.Answer(doc, "asks", "0.5")).reason)
    duet.do(act.Toggle(doc, "asks"))
    duet.do(act.Answer(doc, "asks", "0.5"))
    assert duet.state(doc, "asks") == "ON"


def test_an_asking_task_is_toggled_off(duet):  # R-C11
    doc = duet.connected("asks")
    duet.do(act.Toggle(doc, "asks"))
    duet.do(act.Toggle(doc, "asks"))
    assert duet.state(doc, "asks") == "OFF"


def test_a_task_in_error_is_cleared_and_comes_on_again_where_it_was_wanted(duet):  # R-C11
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    fail(duet)
    duet.do(act.Toggle(doc, "a"))
    assert duet.state(doc, "a") == "ON" and duet.document(doc).content.wanted == {"a": True}


def test_a_task_of_a_device_in_error_is_only_cleared(duet):  # R-C11, R-C28
    doc = duet.connected("arm")
    duet.do(act.Toggle(doc, "arm"))
    fail(duet, "arm")
    duet.do(act.Toggle(doc, "arm"))
    assert duet.state(doc, "arm") == "OFF" and duet.document(doc).content.wanted == {"arm": False}
    duet.do(act.Toggle(doc, "arm"))
    assert duet.state(doc, "arm") == "ON"


def test_clearing_alone_leaves_it_off(duet):  # R-C11
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    fail(duet)
    duet.do(act.Clear(doc, "a"))
    assert duet.state(doc, "a") == "OFF" and duet.document(doc).content.wanted == {"a": False}
    assert str(duet.document(doc).history.last.label) == "turning a ON"  # a way out of an error is no step


class Broken(LiveRuntime):
    """Nobody comes out of an error here."""

    def ask(self, wish):
        if not isinstance(wish, live.Clear):
            return super().ask(wish)
        self.tell(event.Edited(wish.subsystem, 99, Reason.plain("a: clear: the panic button is pressed"), 1.0))
        return live.Accepted(99)


def test_an_error_that_cannot_be_cleared_stays_and_the_task_can_be_replaced(tmp_path):  # R-C28
    duet = FakeRuntimeEnv(tmp_path, TASKS, Broken())
    doc = duet.connected("a")
    fail(duet)
    duet.do(act.Clear(doc, "a"))
    assert duet.state(doc, "a") == "ERROR"
    assert str(duet.says[-1].text) == "nothing is changed: a: clear: the panic button is pressed"
    duet.do(act.Exchange(doc, "a", "b"))
    assert set(duet.runtime.lives["Untitled-1"]) == {"b"}


def test_a_task_in_error_is_not_simply_turned_on(duet):
    doc = duet.connected("a")
    fail(duet)
    assert duet.no(act.Turn(doc, ("a",), is_on=True)).remedies[0].act == act.Clear(doc, "a", turns_on=True)


def test_who_waits_for_a_constant_cannot_come_on_and_says_for_which(duet):  # law 10, R-X01
    doc = duet.connected("a")
    document = duet.document(doc)
    task = replace(document.live.tasks["a"], state="WAITING", note=Reason.plain("waits for NDOF"))
    waiting = document.live.with_task("a", task)
    duet.environment.become(lambda model: Done(model.with_document(replace(document, live=waiting))))
    refused = duet.no(act.Toggle(doc, "a"))
    assert str(refused.reason) == "a waits for NDOF: it cannot come on before a task supplies it"


def test_what_is_not_in_error_is_not_cleared(duet):
    doc = duet.connected("a")
    assert str(duet.no(act.Clear(doc, "a")).reason) == "a is OFF, not in ERROR"


def test_a_task_is_initialised_anew(duet):  # R-C04
    doc = duet.connected("a")
    duet.do(act.Reinit(doc, "a"))
    assert live.Reinit("Untitled-1", "a") in duet.carried_out and not duet.document(doc).live.pending


def test_a_placed_task_that_was_killed_elsewhere_is_born_again_when_it_is_turned_on(duet):
    doc = duet.connected("a")
    duet.runtime.lives["Untitled-1"].clear()
    duet.tell(event.TaskState("Untitled-1", "a", "KILLED", 1.0))
    duet.do(act.Toggle(doc, "a"))
    assert duet.state(doc, "a") == "ON"


def test_who_is_about_to_be_born_comes_on_as_soon_as_it_lives(duet):  # R-C11
    doc = duet.connected()
    duet.is_held_back = True
    duet.environment.do(act.Place(doc, "a", 0, 0), "me", lambda given: None)
    given = []
    duet.environment.do(act.Toggle(doc, "a"), "me", given.append)
    assert (duet.state(doc, "a"), given) == ("SPAWNING", [])
    duet.is_held_back = False
    duet.pump()
    assert duet.state(doc, "a") == "ON"
    assert [answer.no for answer in given] == [None]


@pytest.mark.parametrize(
    "wish", [act.Toggle("c1", "a"), act.Turn("c1", ("a",), True), act.Clear("c1", "a"), act.Reinit("c1", "a"),
              act.Answer("c1", "a", "1")]
)  # fmt: skip
def test_what_does_not_live_is_not_operated(duet, wish):  # R-C25
    doc = duet.new("a")
    refused = duet.no(wish)
    assert "is not connected" in str(refused.reason) and refused.remedies[0].act == act.Connect(doc)
    duet.do(act.Connect(doc))
    duet.tell(event.Held("Untitled-1", "anna#2"))
    assert "held by anna#2" in str(duet.no(wish).reason)
    duet.do(act.Close(doc, discards=True))
    assert str(duet.no(wish).reason) == "this configuration is no longer open"


@pytest.mark.parametrize("wish", [act.Clear("c1", "b"), act.Reinit("c1", "b"), act.Answer("c1", "b", "1")])
def test_a_task_that_is_not_there_is_not_operated(duet, wish):
    duet.connected("a")
    assert str(duet.no(wish).reason) == "b does not live"


def test_a_task_that_no_library_knows_cannot_be_turned_on(duet, tmp_path):  # reading 11
    Laboratory(tmp_path).configuration("old", "lost 10")
    doc = duet.do(act.Open("old"))
    duet.do(act.Connect(doc))
    assert str(duet.no(act.Toggle(doc, "lost")).reason) == "no open library has a task lost"


def test_what_the_runtime_refuses_is_said_in_its_words(duet):  # R-X01
    doc = duet.connected("asks")
    duet.do(act.Toggle(doc, "asks"))
    duet.rebuffs = {request.Reply: request.Refused(Reason.plain("it is gone"))}
    assert str(duet.answer(act.Answer(doc, "asks", "0.5")).no.reason) == "it is gone"


def test_a_living_task_goes_on_with_the_code_that_its_file_has_now(duet):  # R-C05, law 21
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    path = duet.base.code_file("a")
    path.write_text(path.read_text() + "\n# another\n")
    duet.do(act.Renew(doc, "a"))
    (swap,) = [message for message in duet.carried_out if isinstance(message, live.Swap)]
    assert (swap.task, swap.code.source) == ("a", path.read_text())
    assert duet.state(doc, "a") == "ON"


def test_code_that_cannot_be_had_changes_nothing(duet):  # R-C05
    doc = duet.connected("a")
    duet.base.code_file("a").unlink()
    assert "keeps its code" in str(duet.no(act.Renew(doc, "a")).reason)
    assert "does not live" in str(duet.no(act.Renew(doc, "b")).reason)


class Starved(LiveRuntime):
    """Task a waits until those that feed it are cleared."""

    def ask(self, wish):
        fed = self.lives.get("Untitled-1", {})
        writers = tuple(name for name in ("b", "asks") if name in fed and fed[name].state.value == "ERROR")
        if isinstance(wish, live.Clear) and wish.task == "a" and writers:
            self.asked.append(wish)
            return request.Refused(Reason.of("host.clear_writers_first", task="a", writers=writers))
        return super().ask(wish)


def test_what_feeds_a_device_and_has_failed_is_cleared_first_by_the_refusals_remedies(tmp_path):  # R-X01, R-C28
    duet = FakeRuntimeEnv(tmp_path, TASKS, Starved())
    doc = duet.connected("a", "b", "asks")
    for task in ("a", "b", "asks"):
        fail(duet, task)
    remedies = duet.answer(act.Clear(doc, "a")).no.remedies
    assert [remedy.act for remedy in remedies] == [act.Clear(doc, "b"), act.Clear(doc, "asks")]
    assert [str(remedy.label) for remedy in remedies] == ["Clear b", "Clear asks"]
    for remedy in remedies:
        duet.do(remedy.act)
    duet.do(act.Clear(doc, "a"))
    assert [duet.state(doc, task) for task in ("a", "b", "asks")] == ["OFF"] * 3
