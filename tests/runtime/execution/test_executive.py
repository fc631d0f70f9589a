"""Figures of the tasks on one processing unit, what its owner sees, and cycles that are no Python method.

That it runs what is due in the right order is proved beside the reference, in `test_reference.py`.
"""

import shutil
import subprocess

import numpy as np
import pytest

from kit.labs.module_source import COUNTER, cycle, module
from kit.runtime.executive_rig import HOME, ExecutiveRig, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news

MS = 1_000_000


# Figures


def test_counters_count_since_the_last_status():  # R-A11, R-A17
    source = cycle("self.warn('x')", crit=2)
    rig = ExecutiveRig(costs={"one": 25 * MS}).spawn("one", source).switch(on=["one"]).run(99 * MS)
    figures = rig.do(command.Report()).last(news.Statuses).tasks[0]
    assert (figures.cycle, figures.miss, figures.warn, figures.crit) == (4, 4, 4, 2)
    assert (figures.state, figures.type, figures.module, figures.reference_hz) == ("ON", "periodic", "one", 100.0)
    assert figures.measured_hz == pytest.approx(40.0)
    assert 0.0 < figures.least_us <= figures.mean_us <= figures.most_us <= figures.total_us
    again = rig.do(command.Report()).last(news.Statuses)
    assert (again.tasks[0].cycle, again.tasks[0].miss, again.tasks[0].warn, again.load) == (0, 0, 0, 0.0)


def test_the_load_is_the_share_of_time_that_tasks_took():  # R-A11
    rig = rig_of(cycle("sum(range(1000))")).switch(on=["one"]).run(100 * MS)
    statuses = rig.do(command.Report()).last(news.Statuses)
    assert statuses.rtpu == "unit"
    assert statuses.load == pytest.approx(statuses.tasks[0].total_us * 1e-6 / 0.1)


def test_a_task_without_a_rate_has_no_reference_rate():  # R-A11
    rig = rig_of(COUNTER, kind="aperiodic", frequency=None).do(command.Report())
    assert rig.last(news.Statuses).tasks[0].reference_hz == 0.0


# What its owner sees


def test_the_watch_is_told_whose_code_runs():
    calls = []
    rig = ExecutiveRig()
    rig.executive._entry_points.watch = calls.append
    rig.spawn("one", COUNTER).switch(on=["one"]).run(0)
    assert {name for name in calls if name} == {f"{HOME}/one"}
    assert calls[-1] == ""


def test_a_release_is_known_beforehand():
    rig = rig_of(COUNTER)
    assert rig.executive.next_release() is None
    assert rig.executive.run_next(0) is None
    assert rig.switch(on=["one"]).executive.next_release() == 0
    assert rig.run(0).executive.next_release() == 10 * MS


def test_a_task_that_is_killed_and_spawned_again_within_a_period_lives():
    rig = rig_of(COUNTER)
    for _ in range(4):
        rig.switch(on=["one"]).run(rig.now).do(command.Kill(HOME, "one")).spawn("one", COUNTER)
    rig.switch(on=["one"]).run(30 * MS)
    assert rig["N"] == 4 + 4


# Cycles that are no Python method


CALLABLES = {
    "partial on the class": "    cycle = functools.partial(STORE.append, None)",
    "partial by init": "    def init(self):\n        self.cycle = functools.partial(self.work, 2)",
    "object with __call__": "    def init(self):\n        self.cycle = Work(self)",
    "lambda": "    def init(self):\n        self.cycle = lambda: self.work(2)",
    "builtin": "    def init(self):\n        self.cycle = self.N_.__iter__",
}


@pytest.mark.parametrize("kind", CALLABLES)
def test_a_cycle_is_anything_that_can_be_called(kind):  # R-A01
    head = (
        "import functools\nSTORE = []\nclass Work:\n    def __init__(self, m):\n        self.m = m\n"
        "    def __call__(self):\n        self.m.work(2)\n"
    )
    body = "    N = OutVar('int')\n    N_ = ()\n    def work(self, n):\n        self.N += n\n" + CALLABLES[kind]
    if kind == "builtin":
        body = body.replace("self.N_.__iter__", "[].clear")
    rig = rig_of(head + module(body)).switch(on=["one"]).run(20 * MS)
    assert (rig.task("one").state, rig.task("one").counters.cycles) == (State.ON, 3)
    expected = {"partial on the class": 0, "builtin": 0}.get(kind, 6)
    assert rig["N"] == expected


C_SOURCE = """
void spring(const double *place, const double *gain, double *force) {
    for (int i = 0; i < 6; i++) force[i] = -gain[0] * place[i];
}
int counted(int *n) { return 0 * (*n += 1); }
int broken(void) { return 7; }
"""
C_MODULE = """
import ctypes
import functools
from onika.module import InVar, Module, OutVar

LIBRARY = ctypes.CDLL({library!r})

class Spring(Module):
    Q_MEZ = InVar("double[6]", "rad", "place")
    GAIN = InVar("double", "N", "gain")
    TAU = OutVar("double[6]", "N m", "torque")
    N = OutVar("int")

    def init(self):
        LIBRARY.spring.restype = None
        pointers = [ctypes.c_void_p(self.buffer(name).ctypes.data) for name in ("Q_MEZ", "GAIN", "TAU")]
        count = ctypes.c_void_p(self.buffer("N").ctypes.data)
        self.cycle = {cycle}
"""


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("there is no C compiler (cc) here to make a C function with")
    folder = tmp_path_factory.mktemp("c")
    (folder / "spring.c").write_text(C_SOURCE)
    subprocess.run([compiler, "-shared", "-fPIC", "-o", folder / "spring.so", folder / "spring.c"], check=True)
    return str(folder / "spring.so")


def test_a_c_function_cycles_on_the_memory_of_the_ports(library):  # R-A01
    source = C_MODULE.format(library=library, cycle="functools.partial(LIBRARY.spring, *pointers)")
    rig = rig_of(source)
    rig.table.ring("Q_MEZ").write(np.arange(6.0).tobytes())
    rig.table.ring("GAIN").write(np.array([2.0]).tobytes())
    rig.switch(on=["one"]).run(20 * MS)
    assert rig["TAU"].tolist() == [0.0, -2.0, -4.0, -6.0, -8.0, -10.0]
    rig.table.ring("GAIN").write(np.array([1.0]).tobytes())
    assert rig.run(30 * MS)["TAU"].tolist() == [0.0, -1.0, -2.0, -3.0, -4.0, -5.0]


def test_the_zero_of_a_c_function_is_no_signal_and_another_number_is_an_error(library):  # R-A01
    source = C_MODULE.format(library=library, cycle="functools.partial(LIBRARY.counted, count)")
    assert rig_of(source).switch(on=["one"]).run(20 * MS)["N"] == 3
    rig = rig_of(C_MODULE.format(library=library, cycle="LIBRARY.broken")).switch(on=["one"]).run(0)
    assert rig.last(news.Failed).text == "TypeError: expected a signal or None from cycle, found 7"


def test_a_function_compiled_by_numba_cycles():  # R-A01
    pytest.importorskip("numba", reason="numba is not installed here; nothing of Onika needs it")
    source = (
        "import functools\nimport numba\nfrom onika.module import Module, OutVar\n"
        "@numba.njit\ndef add(n):\n    n[0] += 1\n"
        "class One(Module):\n    N = OutVar('int')\n    def init(self):\n"
        "        self.cycle = functools.partial(add, self.buffer('N'))"
    )
    assert rig_of(source).switch(on=["one"]).run(20 * MS)["N"] == 3
