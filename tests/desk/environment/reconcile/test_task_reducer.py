import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, event, live
from onika.wire.view import ShowTask
from onika.words.reason import NOTHING, Reason

TASKS = tuple(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b"))
ITEM = event.Item("x", "double", 1, "m", "where to go", None, (0.0,), (1.0,))


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


@pytest.fixture
def doc(duet):
    return duet.connected("a")


def shown(duet, doc, task="a"):
    return duet.environment.tree.documents[doc].tasks[task]


def state(duet, name, task="a"):
    duet.tell(event.TaskState("Untitled-1", task, name, 1.0))


def test_a_question_pops_up_and_goes_with_its_answer(duet, doc):  # R-C13
    duet.do(act.Toggle(doc, "a"))
    state(duet, "ASKING")
    duet.tell(event.Asked("Untitled-1", "a", Reason.plain("too far"), (ITEM,), 1.0))
    ask = shown(duet, doc).ask
    assert str(ask.reason) == "too far" and ask.items[0].high == (1.0,)
    state(duet, "ON")
    assert shown(duet, doc).ask is None


def test_an_error_is_shown_with_what_its_code_said_until_it_is_cleared(duet, doc):  # R-C25, R-C28
    why = Reason.of("host.entry_failed", entry="cycle", why="no sensor")
    failed = event.Failed("Untitled-1", "a", why, "/m/a.py", 12, "Traceback…", 3.0, "cycle", {"A": 1.0})
    duet.do(act.Toggle(doc, "a"))
    duet.tell(failed)
    state(duet, "ERROR")
    error = shown(duet, doc).error
    assert (str(error.text), error.entry, error.line, error.values) == ("no sensor", "cycle", 12, {"A": 1.0})
    assert duet.says[-1].level == "error" and duet.says[-1].where == ShowTask("a")
    assert duet.document(doc).content.wanted == {"a": True}  # it is wanted back
    state(duet, "OFF")
    assert shown(duet, doc).error is None and duet.document(doc).content.wanted == {"a": False}


def test_a_task_that_has_done_its_job_is_said_and_is_off(duet, doc):  # R-C25
    duet.do(act.Toggle(doc, "a"))
    duet.tell(event.Signalled("Untitled-1", "a", "FINISH", 0, NOTHING, 2.0))
    state(duet, "OFF")
    assert str(duet.says[-1].text) == "a has finished" and duet.says[-1].level == "end"
    assert shown(duet, doc).state == "OFF" and duet.document(doc).content.wanted == {"a": False}


@pytest.mark.parametrize(("kind", "level"), [("LEGAL", "info"), ("ILLEGAL", "warning"), ("USER", "warning")])
def test_other_signals_are_said_too(duet, doc, kind, level):  # Table 9
    duet.tell(event.Signalled("Untitled-1", "a", kind, 3, Reason.plain("the table is full"), 2.0))
    assert str(duet.says[-1].text) == f"a signals {kind}: the table is full" and duet.says[-1].level == level


def test_warnings_are_said_and_counted(duet, doc):  # R-A11
    duet.tell(event.Warned("Untitled-1", "a", Reason.plain("late"), 1.0))
    duet.tell(event.Warned("Untitled-1", "", Reason.plain("nobody writes X"), 1.0))
    assert shown(duet, doc).warnings == 1
    assert [str(say.text) for say in duet.says[-2:]] == ["a: late", "nobody writes X"]


def test_a_task_that_dies_lives_no_more_and_stays_on_the_canvas(duet, doc):  # R-C25
    state(duet, "KILLED")
    assert shown(duet, doc).state == "" and duet.document(doc).live.tasks == {}


def test_the_death_of_the_old_one_in_an_exchange_hides_nobody(duet, doc):
    duet.is_held_back = True
    duet.environment.do(act.Unit(doc, "a", "rt1"), "me", lambda given: None)
    assert shown(duet, doc).state == "SPAWNING"
    state(duet, "KILLED")
    assert shown(duet, doc).state == "SPAWNING"
    duet.is_held_back = False
    duet.pump()
    assert shown(duet, doc).state == "OFF" and shown(duet, doc).rtpu == "rt1"


def test_a_stranger_that_stirs_is_looked_at(duet, doc):  # R-C12
    count = len(duet.carried_out)
    state(duet, "ON", "stranger")
    assert isinstance(duet.carried_out[count], live.Survey)
