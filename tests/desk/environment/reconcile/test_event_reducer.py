import pytest

from kit.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, event, live, view
from onika.wire.view import ShowTask

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
    duet.tell(event.Asked("Untitled-1", "a", "too far", (ITEM,), 1.0))
    ask = shown(duet, doc).ask
    assert str(ask.reason) == "too far" and ask.items[0].high == (1.0,)
    state(duet, "ON")
    assert shown(duet, doc).ask is None


def test_an_error_is_shown_with_what_its_code_said_until_it_is_cleared(duet, doc):  # R-C25, R-C28
    failed = event.Failed("Untitled-1", "a", "cycle: no sensor", "/m/a.py", 12, "Traceback…", 3.0, "cycle", {"A": 1.0})
    duet.do(act.Toggle(doc, "a"))
    duet.tell(failed)
    state(duet, "ERROR")
    error = shown(duet, doc).error
    assert (str(error.text), error.entry, error.line, error.values) == ("no sensor", "cycle", 12, {"A": 1.0})
    assert duet.says[-1].level == "error" and duet.says[-1].where == ShowTask("a")
    assert duet.document(doc).content.wanted == {"a": True}  # it is wanted back
    state(duet, "OFF")
    assert shown(duet, doc).error is None and duet.document(doc).content.wanted == {"a": False}


def test_a_step_that_was_too_far_is_said_at_the_task_that_was_given_it(duet, doc):  # R-X04, R-C25
    said = list(duet.says)
    duet.tell(event.Stepped("Untitled-1", "a", "A", "N m", 1, 3.0, 3.0, 9.76, 0, 1.0))
    duet.tell(event.Stepped("elsewhere", "a", "A", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0))
    assert duet.says == said
    duet.tell(event.Stepped("Untitled-1", "a", "A", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0))
    assert (duet.says[-1].level, duet.says[-1].where) == ("warning", ShowTask("a"))
    assert str(duet.says[-1].text).endswith("more than 9.76 N m a cycle: blended over 6 cycles")


def test_a_task_that_has_done_its_job_is_said_and_is_off(duet, doc):  # R-C25
    duet.do(act.Toggle(doc, "a"))
    duet.tell(event.Signalled("Untitled-1", "a", "FINISH", 0, "", 2.0))
    state(duet, "OFF")
    assert str(duet.says[-1].text) == "a has finished" and duet.says[-1].level == "end"
    assert shown(duet, doc).state == "OFF" and duet.document(doc).content.wanted == {"a": False}


@pytest.mark.parametrize(("kind", "level"), [("LEGAL", "info"), ("ILLEGAL", "warning"), ("USER", "warning")])
def test_other_signals_are_said_too(duet, doc, kind, level):  # Table 9
    duet.tell(event.Signalled("Untitled-1", "a", kind, 3, "the table is full", 2.0))
    assert str(duet.says[-1].text) == f"a signals {kind}: the table is full" and duet.says[-1].level == level


def test_warnings_are_said_and_counted(duet, doc):  # R-A11
    duet.tell(event.Warned("Untitled-1", "a", "late", 1.0))
    duet.tell(event.Warned("Untitled-1", "", "nobody writes X", 1.0))
    assert shown(duet, doc).warnings == 1
    assert [str(one.text) for one in duet.says[-2:]] == ["a: late", "nobody writes X"]


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
    asked = len(duet.carried_out)
    state(duet, "ON", "stranger")
    assert isinstance(duet.carried_out[asked], live.Survey)


def test_a_stop_is_shown_to_everybody_with_its_cause(duet, doc):  # law 27
    duet.tell(event.Stopped(True, "the panic button"))
    runtime = duet.environment.tree.runtime
    assert runtime.is_stopped and str(runtime.stop_text) == "the panic button" and duet.says[-1].level == "error"
    duet.tell(event.Stopped(False, ""))
    assert not duet.environment.tree.runtime.is_stopped and str(duet.environment.tree.runtime.stop_text) == ""


def test_a_unit_that_is_lost_is_shown_so(duet, doc):  # R-E10
    duet.tell(event.Lost("rt1", "it was killed", 1.0))
    assert duet.environment.tree.runtime.units["rt1"] == view.UnitView(0.0, True)
    assert str(duet.says[-1].text) == "rt1 is lost: it was killed"


def test_who_holds_what_is_known_of_other_subsystems_too(duet, doc):  # R-X12
    duet.tell(event.Held("elsewhere", "anna#2"))
    duet.tell(event.Held("Untitled-1", "bob#3"))
    tree = duet.environment.tree
    assert tree.runtime.subsystems == {"Untitled-1": "bob#3", "elsewhere": "anna#2"}
    assert tree.documents[doc].holder == "bob#3" and not tree.documents[doc].is_held_here


def test_what_happens_in_a_subsystem_that_no_document_shows_is_nobodys_fact(duet, doc):
    before = duet.environment.tree.documents
    duet.tell(event.TaskState("far", "a", "ON", 1.0))
    duet.tell(event.Edited("far", 3, "", 1.0))
    assert duet.environment.tree.documents == before
    assert duet.carried_out[-1] == live.Survey()  # what is new there is looked for


@pytest.mark.parametrize(("name", "is_said"), [("TRIPPED", True), ("PRESSED", True), ("DRIVEN", False)])
def test_a_drive_that_gives_up_is_said(duet, doc, name, is_said):  # law 17
    count = len(duet.says)
    duet.tell(event.Drive("boxes:arm", name, 0, 0, 0, "no commands"))
    assert [str(one.text) for one in duet.says[count:]] == [f"drive boxes:arm is {name}: no commands"] * is_said
