"""A module instance bound to its task."""

import numpy as np
import pytest

from onika.module import InBoth, InConst, InVar, Local, Module, OutBoth, OutConst, OutVar
from onika.ring.segment import Segment
from onika.runtime.command import BoundPort, Spawn
from onika.runtime.modules.binding import Binding, attach, instantiate, locals_of, undeclared
from onika.runtime.table import Table
from onika.testing.bench_device import SEGMENT, BenchDevice
from onika.words.shape import Shape


class Six(Module):
    """A port of each kind."""

    C = InConst("int")
    B = InBoth("double")
    V = InVar("double[2]")
    D = OutConst("int")
    E = OutBoth("double")
    W = OutVar("double[2]")


@pytest.fixture
def table():
    segment = Segment.create("test", 1 << 18)
    yield Table(segment)
    segment.close()


def spawn(table, cls, *, aliases=(), local=(), seed=0, task="t", frequency=100.0, device=None):
    ports = []
    for attribute, declared in cls.declared_ports.items():
        port = declared.port(attribute)
        svar = dict(aliases).get(port.name, port.name)
        ports.append(BoundPort(port.name, svar, str(port.shape), table.entry(svar, port.shape).offset))
    return Spawn("s", task, "m", "m.py", "", "periodic", frequency, tuple(local), tuple(ports), 0, seed, device)


def bound(table, cls, **given):
    order = spawn(table, cls, **given)
    views = {"table:s": table.segment.view}
    instance = instantiate(cls, order, views)
    return instance, Binding(instance, order, views)


def write(table, name, *values):
    table.ring(name).write(np.array(values, dtype=table.entries[name].shape.type.code).tobytes())


def run(copies):
    for copy in copies:
        copy()


def test_constants_are_copied_at_init_variables_at_cycles_and_first_values_at_both(table):  # R-A02
    module, binding = bound(table, Six)
    write(table, "C", 1)
    write(table, "B", 2.0)
    write(table, "V", 3.0, 4.0)
    run(binding.copies("init_in"))
    assert (module.C, module.B, module.V.tolist()) == (1, 2.0, [0.0, 0.0])
    write(table, "C", 10)
    write(table, "B", 20.0)
    run(binding.copies("in"))
    assert (module.C, module.B, module.V.tolist()) == (1, 20.0, [3.0, 4.0])


def test_outputs_are_published_in_the_same_way(table):  # R-A02
    module, binding = bound(table, Six)
    module.D, module.E, module.W = 1, 2.0, (3.0, 4.0)
    run(binding.copies("init_out"))
    assert (table.value("D"), table.value("E"), table.ring("W").count) == (1, 2.0, 0)
    run(binding.copies("out"))
    assert (table.ring("D").count, table.ring("E").count, table.value("W").tolist()) == (1, 2, [3.0, 4.0])


def test_own_outputs_are_preloaded_from_the_table(table):  # law 3
    module, binding = bound(table, Six)
    write(table, "D", 9)
    write(table, "E", 5.0)
    write(table, "W", 6.0, 7.0)
    run(binding.preloads)
    assert (module.D, module.E, module.W.tolist()) == (0, 5.0, [6.0, 7.0])


def test_two_tasks_meet_in_a_variable_by_their_aliases(table):  # R-C04
    writer, out = bound(table, Six, aliases=[("W", "Q^_REF")])
    reader, into = bound(table, Six, aliases=[("V", "Q^_REF"), ("W", "OTHER")])
    writer.W = (1.0, 2.0)
    run(out.copies("out"))
    run(into.copies("in"))
    assert reader.V.tolist() == [1.0, 2.0]


def test_an_input_vector_cannot_be_written_element_by_element_either(table):  # R-A02
    module, _ = bound(table, Six)
    with pytest.raises(ValueError, match="read-only"):
        module.V[0] = 1.0


def test_a_copied_input_does_not_change_until_the_next_copy(table):  # R-A02
    module, binding = bound(table, Six)
    run(binding.copies("in"))
    write(table, "V", 1.0, 1.0)
    assert module.V.tolist() == [0.0, 0.0]


def test_what_is_not_finite_is_named(table):  # law 5
    _, binding = bound(table, Six)
    assert binding.not_finite() == []
    write(table, "V", 1.0, float("inf"))
    write(table, "B", float("nan"))
    run(binding.copies("in"))
    assert binding.not_finite() == ["B", "V"]


def test_what_was_written_since_it_was_forgotten_is_in_force(table):  # law 3
    _, binding = bound(table, Six)
    assert binding.in_force() == frozenset()
    write(table, "W", 1.0, 1.0)
    write(table, "V", 1.0, 1.0)
    assert binding.in_force() == {"V", "W"}
    table.ring("W").forget()
    assert binding.in_force() == {"V"}


def test_an_instance_gets_its_period_and_its_chance(table):  # laws 13, 14
    module, _ = bound(table, Six, frequency=250.0)
    assert module.dt == 0.004
    assert bound(table, Six, frequency=None)[0].dt == 0.0


def test_chance_is_seeded_by_run_and_path(table):  # law 14
    def draws(**given):
        return [bound(table, Six, **given)[0].random.random() for _ in range(2)]

    assert draws(seed=1)[0] == draws(seed=1)[1]
    assert len({*draws(seed=1), *draws(seed=2), *draws(seed=1, task="other")}) == 3


def test_a_class_with_an_init_of_its_own_need_not_call_ours(table):
    class Own(Module):
        def __init__(self):
            self.mine = 1

    module, _ = bound(table, Own)
    module.warn("still works")
    assert ([str(warning) for warning in module.warnings], module.mine) == (["still works"], 1)


def test_a_granted_device_is_attached(table):  # law 16
    far = BenchDevice(("x",), ("force",))
    order = spawn(table, Six, device=far.grant())
    module = instantiate(Six, order, {"table:s": table.segment.view, SEGMENT: far.view})
    module.device.write([2.0])
    assert far.commands.tolist() == [2.0]
    assert attach(far.grant(), {SEGMENT: far.view}).sheet == far.sheet


class Parameters(Module):
    """Reads its LOCAL block."""

    GAIN = Local("double", "-", "gain")
    COUNT = Local("int", "-", "count", default=3)
    POSE = Local("double[3]", "m", "where", default=(0.0, 0.0, 0.0))
    LABEL = Local("line", "-", "label", default="none")
    NAMES = Local("string[N]", "-", "names", default=())


def test_parameters_are_read_from_local_lines(table):  # R-A01
    lines = [("GAIN", ("2.5",)), ("POSE", ("1", "2", "3")), ("LABEL", ("two", "words")), ("NAMES", ("a", "b"))]
    module, _ = bound(table, Parameters, local=lines)
    assert (module.GAIN, module.COUNT, module.POSE, module.LABEL, module.NAMES) == (
        2.5,
        3,
        [1.0, 2.0, 3.0],
        "two words",
        ["a", "b"],
    )


@pytest.mark.parametrize(
    ("lines", "refusal"),
    [
        ({}, r"expected a LOCAL line GAIN double \(gain\), found none"),
        ({"GAIN": ("fast",)}, "LOCAL GAIN: expected a number .*'fast'"),
        ({"GAIN": ("1", "2")}, "LOCAL GAIN: expected one double, found 2 words"),
        ({"GAIN": ("1",), "POSE": ("1", "2")}, "LOCAL POSE: expected 3 values, found 2"),
        ({"GAIN": ("1",), "POSE": ("1", "2", "x")}, "LOCAL POSE: expected a number .*'x'"),
    ],
)
def test_a_local_line_that_cannot_be_used_is_refused_by_its_name(lines, refusal):  # R-B07
    with pytest.raises(ValueError, match=refusal):
        locals_of(Parameters, lines)


def test_attributes_that_look_like_variables_and_are_none_are_found(table):
    module, _ = bound(table, Parameters, local=[("GAIN", ("1",))])
    module.speed, module.N, module.Kp = 1, 2, 3
    assert undeclared(module) == []
    module.Q_REFF = 1.0
    module.X_MEZ = 2.0
    assert undeclared(module) == ["Q_REFF", "X_MEZ"]


def test_a_port_that_the_spawn_lacks_is_a_mistake(table):
    order = spawn(table, Module)
    with pytest.raises(ValueError, match="expected an entry for port C, found none"):
        Binding(Six(), order, {"table:s": table.segment.view})


def test_shapes_are_those_of_the_spawn_resolved(table):  # R-A03
    class Follows(Module):
        Q = OutVar("double[NDOF,2]")

    entry = table.entry("Q", Shape.parse("double[3,2]"))
    port = BoundPort("Q", "Q", "double[3,2]", entry.offset)
    order = Spawn("s", "t", "m", "m.py", "", "periodic", 1.0, (), (port,), 0, 0, None)
    follower = Follows()
    Binding(follower, order, {"table:s": table.segment.view})
    assert follower.Q.shape == (3, 2)
