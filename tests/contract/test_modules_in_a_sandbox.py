"""One rule, all modules: whoever is in a sandbox does what it does without one."""

import numpy as np
import pytest

from contract.test_modules import TASKS, argument_line, bench_of, feed, jumping, name, task_of
from kit.runtime.local_sandbox import LocalSandbox, sandboxed
from onika.model.lifecycle import State
from onika.model.task import TaskType
from onika.runtime import news
from onika.runtime.execution import task_lifecycle
from onika.runtime.sandbox.sandboxed_class import load_sandboxed
from onika.runtime.sandbox.sandboxed_module import SandboxedModule

_CYCLES = 20
_OF_THE_WALL = (news.Statuses, news.Loads, news.Stepped)


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    """What a module writes, it writes there."""
    monkeypatch.chdir(tmp_path)


def story(path):
    """What a task writes and what is told of it, cycle by cycle, with the same random inputs each time."""
    rng = np.random.default_rng(3)
    bench, device = bench_of(path)
    jumping(bench.init())
    ports = [declared.port(attribute) for attribute, declared in bench.cls.declared_ports.items()]
    outputs = [port.name for port in ports if not port.kind.is_input]
    told = []
    for _ in range(_CYCLES):
        if bench.state is State.ERROR:
            bench.clear()
        feed(bench, device, rng)
        if bench.state is State.OFF:
            bench.on(argument_line(bench, task_of(path).module, rng))
        bench.cycle()
        told.append([np.array(bench[output]).tolist() for output in outputs])
        if device is not None:
            told.append([device.order, list(device.commands)])
    says = [
        (type(item).__name__, getattr(item, "text", "")) for item in bench.news if not isinstance(item, _OF_THE_WALL)
    ]
    return told, says, bench.state, isinstance(bench.task.module, SandboxedModule)


@pytest.mark.parametrize("path", [path for path in TASKS if task_of(path).type is not TaskType.SYNCHRONOUS], ids=name)
def test_a_module_does_in_a_sandbox_what_it_does_without(path, monkeypatch):  # R-X16
    free = story(path)

    def loaded(order, _code):
        order = sandboxed(order)
        return load_sandboxed(order, LocalSandbox(order))

    monkeypatch.setattr(task_lifecycle, "_loaded", loaded)
    confined = story(path)
    assert confined[:3] == free[:3]
    assert (free[3], confined[3]) == (False, True)
