import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.trouble import error_view
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TaskFacts
from onika.model.configuration import Configuration
from onika.model.task import Task
from onika.wire import act, event
from onika.wire.view import ShowLibraries, ShowLocus, ShowTask
from onika.words.reason import Reason

TASKS = (
    Task("cubic", "traj", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0, object_type="Joint job"),
    Task("trapez", "traj", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("wait", "wait", inconst=("T",), frequency=100.0, object_type="Joint job"),
    Task("memory", "memory", invar=("M",), outvar=("M",), frequency=100.0),
    Task("clock", "clock", outvar=("T",), frequency=100.0),
)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, TASKS)


def opened(sitting, *tasks):
    """A configuration as a file holds it, which no rule has seen."""
    text = "".join(f"RMODFILE {name}\nCOORDS 0 0\n" for name in tasks) + "EOF\n"
    sitting.base.configuration_file("c").parent.mkdir(exist_ok=True)
    sitting.base.configuration_file("c").write_text(text)
    return sitting.do(act.Open(str(sitting.base.configuration_file("c"))))


def problems(sitting, doc):
    return sitting.environment.tree.documents[doc].problems


def test_tasks_of_a_file_that_contradict_each_other_are_a_fault_with_ways_out(sitting):  # R-C26, R-X01
    doc = opened(sitting, "cubic", "trapez")
    problem = problems(sitting, doc)["conflict trapez cubic"]
    assert problem.level == "fault"
    assert "its module `traj` is used already, by `cubic`" in str(problem.text)
    assert "writes Q_REF, which `cubic` already writes" in str(problem.text)
    removing = [remedy.act for remedy in problem.remedies if remedy.act]
    assert removing == [act.Remove(doc, ("trapez",)), act.Remove(doc, ("cubic",))]
    sitting.do(removing[0])
    assert "conflict trapez cubic" not in problems(sitting, doc)


def test_a_constant_that_is_only_given_while_running_is_a_fault(sitting):  # R-C26, Equation (3)
    assert "needs T at initialisation" in str(
        problems(sitting, opened(sitting, "clock", "wait"))["conflict wait clock"].text
    )


def test_a_missing_task_can_be_removed_or_its_library_opened(sitting):  # reading 11
    doc = opened(sitting, "gone")
    problem = problems(sitting, doc)["missing gone"]
    assert (problem.level, problem.show) == ("fault", ShowTask("gone"))
    assert [remedy.show for remedy in problem.remedies] == [ShowLibraries(), None]
    sitting.do(problem.remedies[1].act)
    assert problems(sitting, doc) == {}


def test_hanging_inputs_further_triggers_and_memories_are_told_and_never_forbidden(sitting):  # R-C08, R-C29
    shown = problems(sitting, sitting.new("cubic", "wait", "memory"))
    assert {key: (problem.level, problem.show) for key, problem in shown.items()} == {
        "hanging Q_MEZ": ("warning", ShowLocus("Q_MEZ")),
        "hanging T": ("warning", ShowLocus("T")),
        "trigger wait": ("warning", ShowTask("wait")),
        "fed memory M": ("note", ShowTask("memory")),
    }


def test_warnings_can_be_switched_off_and_faults_cannot(sitting):  # R-C08, R-C20
    doc = opened(sitting, "cubic", "trapez", "memory")
    sitting.do(act.Prefer({"shows_warnings": False}))
    assert list(problems(sitting, doc)) == ["conflict trapez cubic"]
    sitting.do(act.Prefer({"shows_warnings": True}))
    assert set(problems(sitting, doc)) == {"conflict trapez cubic", "hanging Q_MEZ", "fed memory M"}


def test_moving_a_task_leaves_the_problems_as_they_are(sitting):  # R-G07
    doc = sitting.new("cubic")
    before = problems(sitting, doc)
    sitting.do(act.Move(doc, {"cubic": (7, 7)}))
    assert problems(sitting, doc) is before


def test_a_task_in_error_has_its_reason_and_its_ways_out():  # R-C11, R-C28
    document = Document("c1", Content(Configuration("c")))
    assert error_view(document, "pd", TaskFacts("ON")) is None
    view = error_view(document, "pd", TaskFacts("ERROR", note=Reason.plain("overrun")))
    assert view is not None
    assert str(view.text) == "overrun"
    assert [remedy.act for remedy in view.remedies if remedy.act] == [
        act.Clear("c1", "pd", turns_on=True),
        act.Clear("c1", "pd"),
        act.Remove("c1", ("pd",)),
    ]


@pytest.mark.parametrize("why", [Reason.of("runtime.button_pressed"), "ValueError: the sensor is dead"])
def test_an_error_is_told_without_its_entry_which_is_shown_beside_it(why):  # R-C11
    document = Document("d1", Content(Configuration("c")))
    failed = event.Failed("main", "pd", Reason.of("host.entry_failed", entry="cycle", why=why), "", 0, "", 1.0, "cycle")
    view = error_view(document, "pd", TaskFacts("ERROR", failed=failed))
    assert (str(view.text), view.entry) == (str(why), "cycle")
