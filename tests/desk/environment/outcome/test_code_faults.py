import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.outcome.code_faults import at_line, compiled, looked_through
from onika.desk.environment.refresh import refreshed
from onika.model.task import Task
from onika.wire import act, live
from onika.wire.view import ShowSource
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

A = Task("a", "ours", outvar=("A",), frequency=10.0)
B = Task("b", "ours", outvar=("B",), frequency=10.0)
RIGHT = "X = 1\n"
WRONG = "X = 1\ndef cycle(self)\n    pass\n"


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (A, B))


def written(sitting, text):
    """Another editor writes the code."""
    path = sitting.base.code_file("ours")
    path.write_text(text)
    sitting.environment.become(lambda model: refreshed(model, {path}))
    return path


def problems(sitting, doc):
    of_document = sitting.environment.tree.documents[doc].problems
    return {key: problem for key, problem in of_document.items() if key.startswith("code ")}


def test_code_that_another_editor_broke_is_a_problem_with_its_line_and_its_source(sitting):  # R-C05, R-C31
    doc = sitting.new("a")
    written(sitting, RIGHT)
    assert problems(sitting, doc) == {}
    path = written(sitting, WRONG)
    (problem,) = problems(sitting, doc).values()
    assert (problem.level, problem.show) == ("fault", ShowSource("a", 2))
    assert str(problem.text) == f"the code of a has an error: {path}, line 2: expected ':'"
    written(sitting, RIGHT)
    assert problems(sitting, doc) == {}


def test_on_every_canvas_the_tasks_of_the_module_have_their_problem(sitting):  # R-C05
    written(sitting, WRONG)
    doc, other = sitting.new("a"), sitting.new("b")
    assert [*problems(sitting, doc)] == ["code a"] and [*problems(sitting, other)] == ["code b"]
    assert problems(sitting, sitting.new()) == {}


def test_code_that_was_broken_and_saved_here_is_a_problem_at_once(sitting):  # R-C05
    written(sitting, RIGHT)
    doc = sitting.new("a")
    text = sitting.do(act.ReadText("a", "code"))
    sitting.do(act.WriteText("a", "code", WRONG, text.stamp))
    assert [*problems(sitting, doc)] == ["code a"]
    assert "line 2" in str(sitting.do(act.Check(doc))[0])


def test_what_a_runtime_says_of_a_module_is_a_problem_too(tmp_path):  # R-C05
    class Reader(LiveRuntime):
        def ask(self, wish):
            if not isinstance(wish, live.Describe):
                return super().ask(wish)
            fault = Fault(Place("ours.py", 7), Reason.plain("no module named sea"), Reason.plain("it stays away"))
            return live.Described({}, {wish.code[0].digest: fault.sentence})

    duet = FakeRuntimeEnv(tmp_path, (A, B), Reader())
    written(duet, RIGHT)
    doc = duet.connected("a")
    (problem,) = problems(duet, doc).values()
    assert problem.show == ShowSource("a", 7) and "line 7: no module named sea" in str(problem.text)


def test_code_is_looked_through_once_and_again_when_it_is_written(sitting):
    path = written(sitting, RIGHT)
    sitting.new("a")
    model = sitting.environment.model
    assert model.code_faults == {str(path): None} and looked_through(model) is model


@pytest.mark.parametrize(
    ("text", "line", "why"),
    [
        ("def f(:\n", 1, "invalid syntax"),
        ("return 1\n", 1, "'return' outside function"),
        ("X = '\\0'\nY = \0\n", 0, "source code string cannot contain null bytes"),
        ("(" * 500 + ")" * 500, 1, "too many nested parentheses"),
    ],
)
def test_the_compiler_says_where_and_why(text, line, why):
    fault, remarks = compiled(text, "ours.py")
    assert fault is not None and (fault[0], str(fault[1])) == (line, why) and remarks == ()


def test_what_it_warns_of_keeps_nothing_from_being_code():
    fault, ((line, why),) = compiled("X = 1\nY = X is 1\n", "ours.py")
    assert fault is None and line == 2 and "is" in str(why)


def test_a_sentence_without_a_line_is_of_the_whole():
    assert at_line(Reason.plain("it raises")) == (0, Reason.plain("it raises"))
