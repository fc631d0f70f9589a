import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import event, live, view
from onika.wire.view import ShowRecording, ShowTask
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


def test_a_step_that_was_too_far_is_said_at_the_task_that_was_given_it(duet, doc):  # R-X04, R-C25
    says = list(duet.says)
    duet.tell(event.Stepped("Untitled-1", "a", "A", "N m", 1, 3.0, 3.0, 9.76, 0, 1.0))
    duet.tell(event.Stepped("elsewhere", "a", "A", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0))
    assert duet.says == says
    duet.tell(event.Stepped("Untitled-1", "a", "A", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0))
    assert (duet.says[-1].level, duet.says[-1].where) == ("warning", ShowTask("a"))
    assert str(duet.says[-1].text).endswith("more than 9.76 N m a cycle: blended over 6 cycles")


def test_a_stop_is_shown_to_everybody_with_its_cause(duet, doc):  # law 27
    duet.tell(event.Stopped(True, Reason.plain("the panic button")))
    runtime = duet.environment.tree.runtime
    assert runtime.is_stopped and str(runtime.stop_text) == "the panic button" and duet.says[-1].level == "error"
    duet.tell(event.Stopped(False, NOTHING))
    assert not duet.environment.tree.runtime.is_stopped and str(duet.environment.tree.runtime.stop_text) == ""


def test_a_unit_that_is_lost_is_shown_so(duet, doc):  # R-E10
    duet.tell(event.Lost("rt1", Reason.plain("it was killed"), 1.0))
    assert duet.environment.tree.runtime.units["rt1"] == view.UnitView(0.0, True)
    assert str(duet.says[-1].text) == "rt1 is lost: it was killed"


def test_a_unit_that_is_up_is_shown_to_everybody_whether_it_is_new_or_was_lost(duet, doc):  # R-A06, R-E10
    duet.tell(event.Lost("rt1", Reason.plain("it was killed"), 1.0))
    duet.tell(event.UnitUp("rt1", 2.0))
    duet.tell(event.UnitUp("rt2", 3.0))
    units = duet.environment.tree.runtime.units
    assert units["rt1"] == units["rt2"] == view.UnitView(0.0, False)
    assert (duet.says[-1].level, str(duet.says[-1].text)) == ("info", "processing unit rt2 is up; it is empty")


def test_a_world_whose_files_were_changed_is_told_of_until_they_are_put_back(duet, doc):  # law 21
    changed, same = Reason.plain("cell.py was changed"), Reason.plain("it is as it was")
    duet.tell(event.Outdated("cell", True, changed, 1.0))
    assert duet.environment.tree.runtime.outdated == {"cell": changed}
    assert (duet.says[-1].level, duet.says[-1].text) == ("warning", changed)
    duet.tell(event.Outdated("cell", False, same, 2.0))
    assert duet.environment.tree.runtime.outdated == {}
    assert (duet.says[-1].level, duet.says[-1].text) == ("info", same)


def test_who_holds_what_is_known_of_other_subsystems_too(duet, doc):  # R-X12
    duet.tell(event.Held("elsewhere", "anna#2"))
    duet.tell(event.Held("Untitled-1", "bob#3"))
    tree = duet.environment.tree
    assert tree.runtime.subsystems == {"Untitled-1": "bob#3", "elsewhere": "anna#2"}
    assert tree.documents[doc].holder == "bob#3" and not tree.documents[doc].is_held_here


def test_what_happens_in_a_subsystem_that_no_document_shows_is_nobodys_fact(duet, doc):
    before = duet.environment.tree.documents
    duet.tell(event.TaskState("far", "a", "ON", 1.0))
    duet.tell(event.Edited("far", 3, NOTHING, 1.0))
    assert duet.environment.tree.documents == before
    assert duet.carried_out[-1] == live.Survey()  # what is new there is looked for


@pytest.mark.parametrize(("name", "is_said"), [("TRIPPED", True), ("PRESSED", True), ("DRIVEN", False)])
def test_a_drive_that_gives_up_is_said(duet, doc, name, is_said):  # law 17
    count = len(duet.says)
    duet.tell(event.Drive("boxes:arm", name, 0, 0, 0, Reason.plain("no commands")))
    assert [str(say.text) for say in duet.says[count:]] == [f"drive boxes:arm is {name}: no commands"] * is_said


def test_the_last_seconds_of_a_configuration_are_shown_at_it_and_a_line_leads_there(duet, doc):  # R-X05
    duet.tell(event.LastSecondsKept("Untitled-1", 3.0, "/state/black-boxes/a-1.1.mcap"))
    assert duet.environment.tree.documents[doc].black_box == "/state/black-boxes/a-1.1.mcap"
    assert (duet.says[-1].doc, duet.says[-1].where) == (doc, ShowRecording("/state/black-boxes/a-1.1.mcap"))
    assert "/state/black-boxes/a-1.1.mcap" in str(duet.says[-1].text)
    assert duet.says[-1].at_s == 0.0  # the time of day is put in where it is sent: 3.0 is the runtime's own clock


def test_the_last_seconds_of_what_nobody_here_has_open_have_a_line_and_those_of_a_run_have_none(duet, doc):  # R-X05
    duet.tell(event.LastSecondsKept("elsewhere", 3.0, "/b.mcap"))
    assert (duet.says[-1].doc, duet.says[-1].where) == ("", ShowRecording("/b.mcap"))
    says = list(duet.says)
    duet.tell(event.LastSecondsKept("flow0", 3.0, "/c.mcap", "flow0"))
    assert duet.says == says
    assert duet.environment.tree.documents[doc].black_box == ""
