"""A typed function as a module."""

import re

import numpy as np
import pytest

from kit.runtime.executive_rig import ExecutiveRig
from onika.model.lifecycle import State
from onika.module import InBoth, InConst, Input, InVar, Local, Module, OutConst, OutVar, module
from onika.runtime import command, news
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.testing.bench import Bench

MS = 1_000_000
SPRING = '''
"""A spring."""

from onika.module import InConst, InVar, Local, OutVar, module


@module(hz=(20, 1000))
def spring_and_damper(
    NDOF: InConst("int", "-", "number of joints"),
    Q_MEZ: InVar("double[NDOF]", "rad", "measured position"),
    QD_MEZ: InVar("double[NDOF]", "rad/s", "its rate", name="Q^_MEZ"),
    K: Local("double", "N m/rad", "stiffness") = 2.0,
) -> OutVar("double[NDOF]", "N m", "torque", name="TAU"):
    """Torque against the displacement: TAU = -K Q_MEZ - Q^_MEZ."""
    return -K * Q_MEZ - QD_MEZ
'''


def bench_of(tmp_path, source, **given):
    path = tmp_path / "spring.py"
    path.write_text(source)
    return Bench(path, **given)


def test_a_function_is_a_module_like_any_other(tmp_path):  # R-X15
    bench = bench_of(tmp_path, SPRING, constants={"NDOF": 2}, local={"K": 3})
    bench.init().on()
    bench["Q_MEZ"], bench["Q^_MEZ"] = [1.0, 2.0], [0.5, 0.5]
    assert bench.cycle()["TAU"].tolist() == [-3.5, -6.5]
    assert issubclass(bench.cls, Module)


def test_its_sheet_says_what_the_signature_says():  # R-X15
    cls = load(SPRING, "spring.py", "spring")
    sheet = sheet_of(cls)
    assert [(port.kind, port.name, port.shape) for port in sheet.ports] == [
        ("INCONST", "NDOF", "int"),
        ("INVAR", "Q_MEZ", "double[NDOF]"),
        ("INVAR", "Q^_MEZ", "double[NDOF]"),
        ("OUTVAR", "TAU", "double[NDOF]"),
    ]
    assert [(local.name, local.default) for local in sheet.locals] == [("K", 2.0)]
    assert cls.__name__ == "spring_and_damper"


def test_its_docstring_has_the_tables_of_a_modules_docstring():  # R-X15
    doc = load(SPRING, "spring.py", "spring").__doc__
    assert doc.startswith("Torque against the displacement")
    rows = [re.split(r"\s{2,}", line.strip()) for line in doc.splitlines()[2:]]
    assert ["Kind", "general, periodic, 20..1000 Hz"] in rows
    assert ["INVAR", "Q^_MEZ", "double[NDOF]", "rad/s", "its rate"] in rows
    assert ["Local", "K", "double", "N m/rad", "stiffness"] in rows


def test_the_function_stays_there_to_be_tested():  # R-X15
    law = load(SPRING, "spring.py", "spring").law
    assert law(1, np.array([1.0]), np.array([0.0]), 5.0).tolist() == [-5.0]


STATEFUL = """
from dataclasses import dataclass

from onika.module import Input, OutVar, finish, module


@dataclass
class Memory:
    time: float = 0.0
    calls: int = 0


@module(hz=(1, 1000), trigger=True, crit=2)
def ramp(
    self,
    memory: Memory,
    dt,
    goal: Input("double", "m", "where to"),
) -> (OutVar("double", "m", "place", name="X"), OutVar("int", "-", "calls", name="N")):
    memory.time += dt
    memory.calls += 1
    if memory.calls == 2:
        self.warn("half way")
    x = min(memory.time, goal)
    return (x, memory.calls, finish(1)) if x == goal else (x, memory.calls)
"""


def test_a_function_has_memory_time_user_input_and_signals(tmp_path):  # R-X15, R-A08
    bench = bench_of(tmp_path, STATEFUL, frequency=100)
    bench.init().on("0.03").cycle(10)
    assert (bench["X"], bench["N"], bench.warnings) == (0.03, 3, ["half way"])
    assert (bench.finished.flow, bench.state, bench.cls.crit) == (1, State.OFF, 2)
    bench.on("0.5").cycle(1)
    assert bench["N"] == 1  # a memory of its own for each time it comes on


@pytest.mark.parametrize(
    ("line", "n"), [("return None", 0), ("return user_signal(40)", 0), ("return 5", 5), ("return 5, legal()", 5)]
)
def test_what_it_returns_are_outputs_a_signal_or_both(tmp_path, line, n):  # R-X15
    source = f"from onika.module import *\n@module(hz=(1, 100))\ndef f() -> OutVar('int', name='N'):\n    {line}\n"
    bench = bench_of(tmp_path, source).init().on().cycle()
    assert (bench.state, bench["N"]) == (State.ON, n)
    kinds = [event.kind for event in bench.news if isinstance(event, news.Signalled)]
    assert bool(kinds) == ("signal" in line or "legal" in line)


@pytest.mark.parametrize("returned", ["5", "5, 6, 7", "5, legal()"])
def test_a_result_that_does_not_fit_is_an_error_of_the_cycle(tmp_path, returned):  # R-A09
    outputs = "(OutVar('int', name='A'), OutVar('int', name='B'))"
    source = f"from onika.module import *\n@module(hz=(1, 100))\ndef f() -> {outputs}:\n    return {returned}\n"
    bench = bench_of(tmp_path, source).init().on().cycle()
    assert bench.failed.text.startswith("ModuleError: expected A, B as result, found ")


def f_bare(x): ...
def f_default(x: InVar("int") = 3): ...
def f_const(x: OutConst("int")): ...
def f_unnamed() -> OutVar("int"): ...
def f_result() -> 5: ...
def f_twice(X: InVar("int")) -> OutVar("int", name="X"): ...


@pytest.mark.parametrize(
    ("law", "sentence"),
    [
        (f_bare, "x: expected InVar"),
        (f_default, "x: expected a default for a Local only, found 3"),
        (f_const, "x: expected InVar"),
        (f_unnamed, "result: expected an OutVar with a name"),
        (f_result, "result: expected an OutVar with a name"),
        (f_twice, "expected an output that is no parameter, found X"),
    ],
)
def test_a_function_that_says_too_little_is_refused_with_the_parameter(law, sentence):  # R-X15
    with pytest.raises(TypeError, match=sentence):
        module(hz=(1, 10))(law)


def test_annotations_may_be_put_off():  # R-X15
    source = "from __future__ import annotations\n" + SPRING.lstrip().partition("\n")[2]
    assert list(load(source, "spring.py", "spring").declared_ports) == ["NDOF", "Q_MEZ", "QD_MEZ", "TAU"]


def test_an_edited_function_takes_over_memory_and_input_while_others_cycle(tmp_path):  # R-X15
    other = "@module(hz=(1, 100))\ndef f(N: InVar('int')) -> OutVar('int', name='M'):\n    return N\n"
    other = f"from onika.module import *\n{other}"
    rig = ExecutiveRig().spawn("ramp", STATEFUL).spawn("other", other, rank=1)
    rig.switch(on=[command.Launch("ramp", "0.05"), "other"]).run(20 * MS)
    edited = STATEFUL.replace("memory.calls += 1", "memory.calls += 10").replace(
        "calls: int = 0", "calls: int = 0\n    more: int = 7"
    )
    rig.do(command.Swap(rig.spawn_of("ramp", edited))).run(30 * MS)
    assert (rig["N"], rig["M"]) == (13, 13)
    assert rig["X"] == pytest.approx(0.04)
    assert rig.task("ramp").module._memories["memory"].more == 7
    rig.run(200 * MS)
    assert rig.news_of(news.Finished)[0].now_ns == 40 * MS
    assert (rig.task("other").slot.missed, rig.task("other").counters.cycles) == (0, 21)


def test_a_new_input_cannot_be_taken_over():  # law 21
    rig = ExecutiveRig().spawn("ramp", STATEFUL).switch(on=[command.Launch("ramp", "0.05")]).run(0)
    more = STATEFUL.replace("    dt,\n", "    dt,\n    other: Input('int'),\n")
    rig.do(command.Swap(rig.spawn_of("ramp", more)))
    assert "other was not asked for yet: turn the task off and on" in rig.news_of(news.Refused)[-1].reason
    assert rig.task("ramp").state is State.ON


def test_an_input_of_both_kinds_is_a_parameter_too(tmp_path):  # R-A02
    @module(hz=(1, 10))
    def follow(X: InBoth("double"), C: InConst("int"), goal: Input("int"), GAIN: Local("int")) -> None:
        """Reads."""

    assert [port.kind for port in sheet_of(follow).ports] == ["INBOTH", "INCONST"]
