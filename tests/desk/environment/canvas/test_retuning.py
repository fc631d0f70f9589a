import math

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task, TaskType
from onika.wire import act

TASKS = (Task("a", "a", outvar=("A",), frequency=10.0), Task("once", "once", type=TaskType.APERIODIC))


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def test_a_rate_is_the_configurations_and_reaches_the_living_task(duet):  # reading 10, R-C11
    doc = duet.connected("a")
    duet.do(act.Rate(doc, "a", 25.0))
    assert duet.document(doc).content.placed("a").frequency == 25.0
    assert duet.runtime.lives["Untitled-1"]["a"].frequency == 25.0 and duet.document(doc).live.tasks["a"].hz == 25.0
    duet.do(act.Undo(doc))
    assert duet.runtime.lives["Untitled-1"]["a"].frequency == 10.0


@pytest.mark.parametrize("hz", [-1.0, math.nan, math.inf])
def test_what_is_no_rate_is_refused_beside_its_field(duet, hz):  # R-X01
    assert "hz" in duet.no(act.Rate(duet.new("a"), "a", hz)).fields


def test_who_runs_once_has_no_rate(duet):
    assert "runs once" in str(duet.no(act.Rate(duet.new("once"), "once", 5.0)).fields["hz"])


def test_a_task_that_is_off_is_exchanged_for_itself_on_another_unit(duet):  # R-C11
    doc = duet.connected("a")
    duet.do(act.Unit(doc, "a", "rt1"))
    assert duet.runtime.lives["Untitled-1"]["a"].rtpu == "rt1"
    assert duet.environment.tree.documents[doc].tasks["a"].rtpu == "rt1"
    assert duet.edits()[-1].kill == ("a",)


def test_a_task_that_is_on_is_switched_off_before_it_moves(duet):  # law 22
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    assert duet.no(act.Unit(doc, "a", "rt1")).remedies[0].act == act.Turn(doc, ("a",), is_on=False)


def test_a_unit_that_the_runtime_lacks_is_refused_where_that_is_known(duet):  # reading 12
    doc = duet.new("a")
    duet.do(act.Unit(doc, "a", "rt7"))
    duet.do(act.Unit(doc, "a", ""))
    assert duet.document(doc).content.placed("a").rtpu == "unknown"
    duet.do(act.Connect(doc))
    assert str(duet.no(act.Unit(doc, "a", "rt7")).fields["rtpu"]) == "expected one of rt0, rt1"
    assert "no name" in str(duet.no(act.Unit(doc, "a", "1 2")).reason)


@pytest.mark.parametrize(
    "kind", [lambda doc, task: act.Rate(doc, task, 1.0), lambda doc, task: act.Unit(doc, task, "")]
)
def test_what_is_not_there_is_not_tuned(duet, kind):
    doc = duet.new("a")
    assert str(duet.no(kind(doc, "b")).reason) == "there is no b on the canvas"
    assert str(duet.no(kind("c9", "a")).reason) == "this configuration is no longer open"
