import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from kit.plans.plan_builder import PlanBuilder
from onika.desk.environment.run_state.subsystem_views import planned
from onika.model.lifecycle import State
from onika.wire import act, event
from onika.wire.view import SharedVariableView
from onika.words.reason import NOTHING, Reason

SOURCE = '''
"""Adds.

Kind     general, periodic, 1..1000 Hz
"""
from onika.module import InVar, OutConst, OutVar, Module


class Add(Module):
    N = OutConst("int", "-", "how many")
    X = InVar("double", "m", "what comes")
    Y = OutVar("double", "m", "what goes")

    def cycle(self):
        self.Y = self.X
'''


@pytest.fixture
def play(tmp_path):
    play = RunFixture(tmp_path)
    doc = play.open([job("aC"), job("bC"), job("aC")], [job("cC")], parallel=True)
    play.run(doc)
    return play


def inside(env):
    return env.environment.tree.runtime.inside


def test_variables_are_those_behind_the_ports_with_all_that_share_them():  # R-C14, R-C27
    builder = PlanBuilder()
    first = builder.task("first", SOURCE, module="add", aliases={"Y": "Q"})
    second = builder.task("second", SOURCE, module="add", aliases={"X": "Q"})
    view = planned("play", (first, second))
    assert list(view.tasks) == ["first", "second"] and view.tasks["first"].hz == 100.0
    assert view.variables == {
        "N": SharedVariableView(True, ("first", "second"), ()),
        "Q": SharedVariableView(False, ("first",), ("second",)),
        "X": SharedVariableView(False, (), ("first",)),
        "Y": SharedVariableView(False, ("second",), ()),
    }


def test_the_tasks_of_every_flow_of_a_run_are_shown_in_their_states(play):  # R-E11, R-C14
    play.alive()
    assert {home: view.application for home, view in inside(play).items()} == {"flow0": "play", "flow1": "play"}
    assert {name: task.state for name, task in inside(play)["flow0"].tasks.items()} == {"a": "OFF", "b": "OFF"}
    play.turned("a", State.ON)
    assert (inside(play)["flow0"].tasks["a"].state, inside(play)["flow1"].tasks["c"].state) == ("ON", "OFF")
    assert inside(play)["flow1"].variables == {"C": SharedVariableView(False, ("c",), ())}


def test_a_task_that_has_failed_says_why_until_it_is_cleared(play):  # R-E11
    play.alive()
    play.turned("a", State.ON)
    play.tell(event.Failed("flow0", "a", Reason.plain("the arm is gone"), "", 0, "", 1.0))
    play.turned("a", State.ERROR)
    assert str(inside(play)["flow0"].tasks["a"].note) == "the arm is gone"
    play.do(act.Company())
    assert str(inside(play)["flow0"].tasks["a"].note) == "the arm is gone"
    play.turned("a", State.OFF)
    assert inside(play)["flow0"].tasks["a"].note == NOTHING


def test_when_the_run_is_over_nothing_of_it_can_be_looked_into(play):  # R-E11
    play.alive()
    play.runtime.finish("play")
    play.end()
    assert inside(play) == {}


def test_each_task_of_a_run_is_told_with_the_steps_in_which_it_is_on(play):  # R-E11
    steps = play.view.steps_by_task
    assert set(steps) == {"flow0/a", "flow0/b", "flow1/c"}
    assert [len(numbers) for numbers in steps.values()] == [2, 1, 1]


def test_the_run_of_somebody_else_can_be_looked_into_too(tmp_path):  # R-E11, R-C27
    env = FakeRuntimeEnv(tmp_path)
    env.connected()
    builder = PlanBuilder()
    first, second = (builder.task(name, SOURCE, module="add") for name in ("first", "second"))
    env.runtime.perform("theirs", "flow0", (first,), "anna#2")
    env.do(act.Company())
    assert list(inside(env)["flow0"].tasks) == ["first"]
    env.runtime.perform("theirs", "flow0", (first, second), "anna#2")
    env.tell(event.TaskState("flow0", "second", "OFF", 1.0))
    assert list(inside(env)["flow0"].tasks) == ["first", "second"]
    env.tell(event.TaskState("flow0", "second", "KILLED", 1.0))
    assert list(inside(env)["flow0"].tasks) == ["first"]
