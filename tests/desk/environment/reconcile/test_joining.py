import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.reconcile.joining import connected
from onika.model.task import Task
from onika.wire import live

TASKS = tuple(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b"))


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def change(duet, me, on=frozenset()):
    """What is asked of a runtime with nothing in it."""
    doc = duet.new("a", "b")
    standing = duet.runtime.ask(live.Survey())
    done = connected(duet.environment.model, doc, standing, me, on)
    changes = [order.asked for order in done.orders if isinstance(order.asked, live.Change)]
    return changes[0] if changes else None


def test_what_does_not_run_is_spawned_off(duet):  # R-C12, Equation (1)
    order = change(duet, "you")
    assert [task.name for task in order.spawn] == ["a", "b"] and order.on == ()


def test_those_that_are_wanted_come_on_with_the_same_change(duet):  # R-C18
    order = change(duet, "you", frozenset({"b"}))
    assert [task.name for task in order.spawn] == ["a", "b"]
    assert [turn.task for turn in order.on] == ["b"]
