"""What tasks that are ON lack (requirement C09)."""

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import ShowLocus, ShowTask

SPEED = Task("speed", "diff", outvar=("V",), frequency=500.0)
SERVO = Task("servo", "pd", invar=("V",), outvar=("TAU",), frequency=500.0)
ARM = Task("arm", "arm", invar=("TAU",), frequency=500.0)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (SPEED, SERVO, ARM), LiveRuntime())


def lacking(duet, doc):
    problems = duet.environment.tree.documents[doc].problems
    return {key: problem for key, problem in problems.items() if key.startswith(("silent", "rare"))}


def test_a_task_that_reads_what_nobody_writes_now_is_told_with_a_way_to_turn_the_writer_on(duet):  # R-C09
    doc = duet.connected("speed", "servo", "arm")
    assert lacking(duet, doc) == {}  # nothing moves
    duet.do(act.Turn(doc, ("servo", "arm"), True))
    (problem,) = lacking(duet, doc).values()
    assert str(problem.text) == "servo reads V, which speed does not write now: it keeps its last value"
    assert (problem.level, problem.show) == ("warning", ShowLocus("V"))
    duet.do(problem.remedies[0].act)
    assert duet.state(doc, "speed") == "ON"
    assert lacking(duet, doc) == {}
    duet.do(act.Turn(doc, ("speed",), False))
    assert list(lacking(duet, doc)) == ["silent V"]


def test_what_no_task_here_writes_is_no_resting_writer(duet):  # R-C08: that is a hanging input
    doc = duet.connected("servo")
    duet.do(act.Turn(doc, ("servo",), True))
    assert lacking(duet, doc) == {}


@pytest.mark.parametrize(("rate", "is_told"), [(500.0, False), (51.0, False), (50.0, True), (20.0, True)])
def test_a_writer_much_slower_than_its_reader_is_told(duet, rate, is_told):  # R-C09
    doc = duet.connected("speed", "servo", "arm")
    duet.do(act.Turn(doc, ("speed", "servo", "arm"), True))
    duet.do(act.Rate(doc, "servo", rate))
    problems = lacking(duet, doc)
    assert list(problems) == ["rare TAU"] * is_told
    for problem in problems.values():
        assert problem.show == ShowTask("servo")
        assert str(problem.text).startswith(f"servo writes TAU {rate:g} times a second, arm reads it 500 times")
