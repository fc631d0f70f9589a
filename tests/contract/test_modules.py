"""One rule, all modules: the docstring is the class is the `.rmod`; a hundred cycles; errors reach the module."""

import ast
import functools
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from kit.worlds.mjcf_arms import ARMS
from onika.files import rmod
from onika.laws import puma560
from onika.laws.robot import published
from onika.model.lifecycle import State
from onika.runtime.modules.sheet import differences, sheet_of
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice
from onika.words.fault import Place

LABS = Path(__file__).parents[2] / "src" / "onika" / "labs"
HERE = Path(__file__).parent
"""Beside the shipped ones, a module that is made of a function."""
_CYCLES = 100
TASKS = [*sorted(LABS.glob("*/module/*.rmod")), *HERE.glob("*/module/*.rmod")]
MODULES = [*sorted(LABS.glob("*/module/*.py")), *HERE.glob("*/module/*.py")]
ALLOWED = sys.stdlib_module_names | {"numpy", "onnxruntime"}
CAMERA = {"H": 24, "W": 32, "FOCAL": 40.0}
KNOWN = published(puma560, 0.0, 0.0, 0.0, 0.0) | CAMERA
"""Constants of a real robot and of a camera for whoever reads them; hardware says its own."""

POSE = "0 0 -1 0 1 0 0.7"
LINES = {
    "ctraj": f"{POSE} 0 -0.2 1",
    "cguard": f"{POSE} 0 -0.2 1 20 5",
    "csense": f"{POSE} 0 -0.2 6",
    "cfollow": f"{POSE} 0 -0.2 6",
    "carc": f"{POSE} 0 -0.2 1 {POSE} 0.2 0.1 1",
    "jdrive": "1 0.5 1",
    "jpath": " ".join(["0"] * 36 + ["1"]),
    "jpoly": "1 0 0 0 0 0 1",
    "jplay": str(HERE / "taught.csv"),
    "teach": "path.csv",
    "open_folder": str(HERE),
    "copy_files": tempfile.gettempdir(),
    "list_files": f"{tempfile.gettempdir()}/never_written.csv",
}
"""Argument lines of modules that random numbers within bounds do not satisfy."""


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    """What a module writes, it writes there."""
    monkeypatch.chdir(tmp_path)


def name(path):
    return f"{path.parts[-3]}-{path.stem}"


@functools.cache
def task_of(path):
    record, faults = rmod.read(path.read_text(), path.stem, str(path))
    assert record is not None, faults
    return record.task


@functools.cache
def code_of(path):
    """The code behind a task file: beside it, else the first that a laboratory has."""
    module = task_of(path).module
    return next(code for code in (path.with_name(f"{module}.py"), *MODULES) if code in MODULES and code.stem == module)


@functools.cache
def boxes():
    """The sheets of the devices of the boxes."""
    return tuple(boxes_world().devices())


def device_of(task):
    """A stand-in for the device that the task names."""
    named = next((line.words[0] for line in task.local if line.key == "DEVICE"), None)
    if named is None:
        return None
    if task.module in CELL:
        return CELL[task.module](task.module)
    if named in ("bench:lamp", "motor:lamp", "motor_pair:lamp"):
        return BenchDevice(("on_pad",), (), {"WHEN": "on_pad"})
    sheet = next(device for device in boxes() if f"boxes:{device.name}" == named.replace("motor_pair:", "boxes:"))
    return BenchDevice(sheet.state[2:], sheet.command, sheet.identity)


def arm_of_cell(task):
    """An arm of seven joints that takes what a task sends."""
    drive = {"arm_tau": "torque", "arm_vel": "velocity"}.get(task, "position")
    numbers = 14 if drive == "position" else 7
    return BenchDevice([f"s{k}" for k in range(21)], [f"c{k}" for k in range(numbers)], ARMS["seven"].identity(drive))


def legs_of_cell(_):
    """Six legs that take positions."""
    identity = {
        name: np.full(6, value) for name, value in (("QMIN", -1.0), ("QMAX", 1.0), ("Q^_MAX", 2.0), ("HOME", 0.0))
    }
    return BenchDevice([f"s{k}" for k in range(18)], [f"c{k}" for k in range(12)], identity | {"DRIVE": "position"})


def sim_of_cell(_):
    """An arm of seven joints without forces."""
    names = [f"q{k}" for k in range(7)]
    return BenchDevice(names, names, ARMS["seven"].identity("position"))


def base_of_cell(_):
    """A base on wheels."""
    identity = {"DRIVE": "twist", "V_MAX": (0.5, 0.0, 2.0)}
    return BenchDevice(["x", "y", "turn", "vx", "vy", "w"], ["vx", "vy", "w"], identity)


def camera_of_cell(_):
    """A camera."""
    identity = {name: (float(value),) for name, value in CAMERA.items()}
    return BenchDevice(["number", "age"], [], identity, picture=(CAMERA["H"], CAMERA["W"]))


def numbers_of_cell(count):
    """Something that publishes so many numbers and takes none."""
    return lambda _: BenchDevice([f"s{k}" for k in range(count)], [])


CELL = dict.fromkeys(("arm_pos", "arm_tau", "arm_vel", "axes"), arm_of_cell) | {
    "grip": lambda _: BenchDevice(["opening", "speed", "force"], ["opening", "force"]),
    "arm_sim": sim_of_cell,
    "gauge": numbers_of_cell(1),
    "base": base_of_cell,
    "camera": camera_of_cell,
    "legs": legs_of_cell,
    "whereis": numbers_of_cell(7),
    "wrench": numbers_of_cell(6),
}
"""Stand-ins for modules that serve any device; the world that their tasks name has an arm of other numbers."""


def bench_of(path, code=None):
    task = task_of(path)
    device = device_of(task)
    local = {line.key: line.words for line in task.local if line.key != "DEVICE"}
    return Bench(
        code or code_of(path),
        frequency=task.frequency,
        local=local,
        constants={} if task.outconst else KNOWN,
        device=device,
    ), device


def jumping(bench):
    """What it is given jumps from now on as nothing may that drives a robot (law 33)."""
    if bench.task.input_guard is not None:
        bench.task.input_guard.transfer.channels = ()


def argument_line(bench, module, rng):
    """Random values within the bounds of all inputs."""
    items = bench.task.input.items if bench.task.input else ()
    words = [
        rng.uniform(-1.0 if item.low is None else item.low[k], 1.0 if item.high is None else item.high[k])
        for item in items
        for k in range(item.count)
    ]
    kinds = [item.type for item in items for _ in range(item.count)]
    return LINES.get(
        module, " ".join(str(int(x) if kind == "int" else x) for kind, x in zip(kinds, words, strict=True))
    )


def feed(bench, device, rng):
    """Random finite values for everything that the module reads at a cycle."""
    for attribute, declared in bench.cls.declared_ports.items():
        port = declared.port(attribute)
        shape = bench.table.entries[port.name].shape
        if port.kind.is_input and port.kind.at_cycle and not shape.type.is_text:
            bench[port.name] = rng.uniform(-3.0, 3.0, shape.dims)
    if device is not None:
        device.state[:] = rng.uniform(-1.0, 1.0, device.state.size)


def rows_of(doc, section):
    """The rows of one table of a docstring, cut at two blanks or more."""
    rows, here = [], ""
    for line in doc.splitlines():
        match = re.match(r"    (\S+)?\s*(.*)$", line)
        if not match or not line.startswith("    "):
            here = ""
            continue
        here = match[1] if match[1] and line[4] != " " else here
        if here == section:
            rows.append(re.split(r"\s{2,}", line[13:].strip()))
    return rows


@pytest.fixture(params=MODULES, ids=name)
def module_class(request):
    return bench_of(next(path for path in TASKS if code_of(path) == request.param))[0].cls


def test_the_ports_of_the_docstring_are_those_of_the_class(module_class):
    written = [
        tuple(" ".join(row).split(None, 2)[:2]) + tuple(row[-3:]) for row in rows_of(module_class.__doc__, "Ports")
    ]
    declared = [
        (port.kind.value, port.name, str(port.shape), port.unit, port.meaning)
        for port in (declared_port.port(attribute) for attribute, declared_port in module_class.declared_ports.items())
    ]
    assert written == declared


def test_the_parameters_of_the_docstring_are_those_of_the_class(module_class):
    written = [tuple(row) for row in rows_of(module_class.__doc__, "Local")]
    declared = [
        (key, str(declared_local.shape), declared_local.unit, declared_local.meaning)
        for key, declared_local in module_class.declared_locals.items()
    ]
    assert written == declared


def test_the_inputs_of_the_docstring_are_those_of_the_class(module_class):
    written = [tuple(row[:3]) for row in rows_of(module_class.__doc__, "Input")]
    declared = [
        (key, str(declared_input.shape), declared_input.unit)
        for key, declared_input in module_class.declared_inputs.items()
    ]
    assert written == declared


def test_the_kind_of_the_docstring_is_that_of_the_class(module_class):
    kinds = [kind for kind in ("hardware", "trigger", "passive") if getattr(module_class, kind)] or ["general"]
    assert rows_of(module_class.__doc__, "Kind")[0][0].split(", ")[0] == kinds[0]
    assert len(kinds) == 1
    assert bool(rows_of(module_class.__doc__, "Finish")) == module_class.trigger


@pytest.mark.parametrize("path", TASKS, ids=name)
def test_a_task_file_fits_its_module(path):
    task = task_of(path)
    cls = bench_of(path)[0].cls
    assert differences(task, sheet_of(cls), Place(str(path))) == []
    rates = re.search(r"(\d+)\.\.(\d+) Hz", rows_of(cls.__doc__, "Kind")[0][0])
    assert int(rates[1]) <= task.frequency <= int(rates[2])


def test_every_module_has_a_task_and_every_task_a_module():
    assert {code_of(path) for path in TASKS} == set(MODULES)


@pytest.mark.parametrize("path", MODULES, ids=name)
def test_a_module_imports_the_front_door_and_the_laws_only(path):  # style: §3, habit 19
    imported = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "a module sees no sibling"
            packages = {"onika", "onika.laws"}
            imported |= {f"{node.module}.{a.name}" for a in node.names} if node.module in packages else {node.module}
    strange = {
        imported_name
        for imported_name in imported
        if imported_name != "onika.module"
        and not imported_name.startswith("onika.laws.")
        and imported_name.partition(".")[0] not in ALLOWED
    }
    assert strange == set()


@pytest.mark.parametrize("path", TASKS, ids=name)
def test_a_hundred_cycles_with_any_finite_input_end_well_and_write_finite_numbers(path):  # R-A02
    rng = np.random.default_rng(1)
    bench, device = bench_of(path)
    jumping(bench.init())
    outputs = [
        port.name
        for port in (declared_port.port(a) for a, declared_port in bench.cls.declared_ports.items())
        if not port.kind.is_input
    ]
    for _ in range(_CYCLES):
        if bench.state is State.ERROR:
            assert bench.failed.text.startswith("ModuleError: "), bench.failed.traceback
            bench.clear()
        feed(bench, device, rng)
        if bench.state is State.OFF:
            bench.on(argument_line(bench, task_of(path).module, rng))
        assert bench.state is State.ON, bench.why
        feed(bench, device, rng)
        bench.cycle()
        assert all(np.isfinite(bench[output]).all() for output in outputs if not isinstance(bench[output], str))
    assert bench.cycles == _CYCLES


PLANTED = """

def _fail(self, sound={name}.cycle):
    if hasattr(self, "_planted"):
        raise RuntimeError("planted")
    return sound(self)


def _hear(self, fault):
    self._heard = fault
    return False


{name}.cycle, {name}.error = _fail, _hear
"""


@pytest.mark.parametrize("path", TASKS, ids=name)
def test_an_exception_in_a_cycle_reaches_the_error_entry(path, tmp_path):  # R-A09
    rng = np.random.default_rng(2)
    sound, _ = bench_of(path)
    copy = tmp_path / sound.path.name
    copy.write_text(sound.path.read_text() + PLANTED.format(name=sound.cls.__name__))
    bench, device = bench_of(path, copy)
    jumping(bench.init())
    feed(bench, device, rng)
    bench.on(argument_line(bench, task_of(path).module, rng))
    bench.task.module._planted = True
    feed(bench, device, rng)
    bench.cycle()
    assert bench.state is State.ERROR
    assert bench.failed.text == "RuntimeError: planted"
    assert str(bench.task.module._heard) == "planted"
