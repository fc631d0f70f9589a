"""Mistakes planted in the engine: the exploration or the comparison with the model finds every single one."""

import importlib.util
import inspect
import textwrap
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, settings
from hypothesis.stateful import run_state_machine_as_test

from onika.engine import walk
from onika.engine.engine import Engine
from onika.engine.flow_control import FlowControl
from onika.engine.flow_router import FlowRouter
from onika.engine.flow_tasks import FlowTasks
from onika.engine.meeting import Meetings
from onika.engine.progress import Progress
from onika.engine.recovery import ErrorRecovery

MISTAKES = {
    "any task ends an action": (Progress, "finished", "and task in step.triggers", ""),
    "a trigger that is ON is not begun anew": (FlowTasks, "change", "if task in step.triggers", "if False"),
    "what is not wanted stays ON": (FlowTasks, "change", "again + change.off", "again"),
    "a failed task is believed to be ON": (FlowTasks, "has_failed", "self._on.pop(task, None)", "pass"),
    "a failed flow leaves its trigger ON": (
        ErrorRecovery,
        "_stop",
        "orders += flow.flow_tasks.rest",
        "flow.flow_tasks.rest",
    ),
    "a stopped flow has come to its tag": (
        ErrorRecovery,
        "_stop",
        "self._router.withdraw(flow)",
        "[]",
    ),
    "the step is not repeated": (
        ErrorRecovery,
        "_when_cleared",
        "return flow.repeat()",
        "return self._router.go_on([flow.flow])",
    ),
    "nobody is cleared": (ErrorRecovery, "recover", "for task in sorted(flow.flow_tasks.in_error)", "for task in ()"),
    "it goes on before all is cleared": (ErrorRecovery, "_when_cleared", "if flow.flow_tasks.in_error:", "if False:"),
    "a paused flow has come to its tag": (
        FlowControl,
        "_pause",
        "self._router.withdraw(flow)",
        "[]",
    ),
    "a step does not end": (FlowControl, "_step", "flow.is_pausing = True\n    return", "return"),
    "a pause that is taken back comes": (FlowControl, "_resume", "flow.is_pausing = False", "pass"),
    "a skip leaves the trigger ON": (
        FlowControl,
        "_skip",
        "flow.flow_tasks.rest(step.triggers)",
        "flow.flow_tasks.rest(step.triggers)[1:]",
    ),
    "a skip brings the old value along": (Progress, "go_to", "self._value = None", "pass"),
    "who was let pass has not been there": (Meetings, "let_pass", "del self._waiting[flow]", "self.withdraw(flow)"),
    "two of three are enough to meet": (
        Meetings,
        "absent",
        "if self._visits[other][tag] < visit]",
        "if self._visits[other][tag] < visit][1:]",
    ),
    "a meeting is not counted": (Meetings, "arrive", "self._visits[flow][tag] += 1", "self._visits[flow][tag] = 1"),
    "a nested application keeps its old meetings": (Meetings, "begin_anew", "visits.pop(tag, None)", "pass"),
    "a nested application is not awaited": (FlowRouter, "_not_done", "is not FlowState.DONE", "is FlowState.ENDED"),
    "a pause outlives the flow": (FlowRouter, "_complete", "flow.is_pausing = False", "pass"),
    "a rest does not use the pause up": (FlowRouter, "rest", "flow.is_pausing = False", "pass"),
    "it begins before everybody is alive": (Engine, "_begin_when_spawned", "and flow.flow_tasks.is_spawned", ""),
    "nobody is killed at the end": (Engine, "_kill_all", "orders += flow.flow_tasks.kill()", "flow.flow_tasks.kill()"),
    "the end is said at once": (Engine, "_end_if_over", "if not all(", "if not any("),
    "a breakpoint is overlooked": (Progress, "rests_after", "return condition is not None and", "return False and"),
    "a loop goes on without a value": (
        walk,
        "_goes_on",
        "value is not None and value.loop",
        "value is None or value.loop",
    ),
    "a loop that was left is left again": (
        walk._Walker,
        "_test",
        "self._leaving -= {test.loop}",
        "pass",
    ),
    "a value beyond the flows takes the last one": (
        walk,
        "_choice",
        'return 0, Reason.of("engine.no_such_flow_of"',
        'return len(choose.to) - 1, Reason.of("engine.no_such_flow_of"',
    ),
    "conditions are taken the wrong way round": (walk, "_choice", "if judge(condition)", "if not judge(condition)"),
}


def beside(name):
    """Another file of tests."""
    spec = importlib.util.spec_from_file_location(name, Path(__file__).with_name(f"{name}.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def plant(monkeypatch, owner, name, old, new):
    """The function with `old` replaced by `new`."""
    function = inspect.getattr_static(owner, name)
    source = textwrap.dedent(inspect.getsource(function))
    assert source.count(old) == 1, f"expected {old!r} once in {name}"
    names = {}
    exec(source.replace(old, new), function.__globals__, names)  # the mistake is ours
    monkeypatch.setattr(owner, name, names[name])


STATES = 20_000
"""More than any of these programs has under a sound engine."""


def is_found(explored, compared):
    try:
        for name in compared.STORIES:
            compared.tell(name)
        run_state_machine_as_test(
            compared.Comparison,
            settings=settings(
                max_examples=1_500,
                stateful_step_count=30,
                deadline=None,
                derandomize=True,
                database=None,
                phases=[Phase.generate],
                suppress_health_check=list(HealthCheck),
            ),
        )
        explore(explored)
    except Exception:
        return True
    return False


def explore(explored):
    for name in explored.SPAWNED:
        explored.Explorer(explored.PROGRAMS[name], explored.Budget(faults=1), spawns_apart=True).explore(STATES)
    for name in explored.SMALL:
        for budget in (explored.Budget(), explored.Budget(user=1), explored.Budget(faults=1)):
            explored.Explorer(explored.PROGRAMS[name], budget).explore(STATES)


@pytest.mark.slow
def test_a_sound_engine_passes_for_sound():
    assert not is_found(beside("test_explored"), beside("test_against_model"))


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_planted_mistake_is_found(monkeypatch, mistake):
    plant(monkeypatch, *MISTAKES[mistake])
    assert is_found(beside("test_explored"), beside("test_against_model"))


@pytest.mark.parametrize("mistake", MISTAKES)
def test_every_mistake_can_be_planted(monkeypatch, mistake):
    plant(monkeypatch, *MISTAKES[mistake])
