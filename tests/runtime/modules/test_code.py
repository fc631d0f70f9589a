"""Module files executed."""

import sys

import pytest

from onika.runtime.modules.code import compiled, line_in, load, traceback_text, where
from onika.runtime.modules.module import Module
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

GOOD = """
from onika.module import Module

class Still(Module):
    seen = []
"""


def fault(source):
    code = load(source, "lab/m.py", "m")
    assert isinstance(code, Fault), code
    return code


def test_the_one_subclass_of_module_is_found():  # R-A01
    cls = load(GOOD, "lab/m.py", "m")
    assert issubclass(cls, Module)
    assert cls.__name__ == "Still"


def test_a_file_is_executed_anew_each_time_so_that_nothing_is_shared():  # law 14
    first, other = load(GOOD, "lab/m.py", "m"), load(GOOD, "lab/m.py", "m")
    first.seen.append(1)
    assert other.seen == []


def test_a_file_leaves_no_trace_among_the_imported_ones():  # law 14
    load(GOOD, "lab/trace.py", "trace")
    load("1 / 0", "lab/trace.py", "trace")
    assert [name for name in sys.modules if name.startswith("onika_task_")] == []


def test_a_syntax_error_is_a_fault_with_its_line():  # R-A18, R-B07
    error = fault("x = 1\nclass :\n")
    assert error.place == Place("lab/m.py", 2)
    assert str(error.reason) == "expected Python, found invalid syntax: class :"
    assert str(error.instead) == "module m is not loaded"


def test_text_that_python_cannot_read_at_all_is_a_fault():
    assert str(fault("x = '\0'").reason) == "expected Python, found source code string cannot contain null bytes: "


@pytest.mark.parametrize(
    ("source", "line", "sentence"),
    [
        ("import nothing_of_this_name", 1, "ModuleNotFoundError: No module named 'nothing_of_this_name'"),
        ("def f():\n    raise KeyError\n\nf()", 2, "KeyError"),
        ("import sys\nsys.exit(3)", 2, "SystemExit: 3"),
    ],
)
def test_what_raises_while_it_is_imported_is_a_fault_with_its_line(source, line, sentence):  # R-A18
    assert fault(source).place == Place("lab/m.py", line)
    assert str(fault(source).reason) == f"expected a module that can be imported, found {sentence}"


def test_a_file_without_a_module_is_a_fault():
    assert fault("x = 1").reason == Reason.of("runtime.no_module_class")
    assert fault("from onika.module import Module").reason == Reason.of("runtime.no_module_class")


def test_a_file_with_two_modules_is_a_fault_that_names_both():
    source = "from onika.module import Module\nclass A(Module): pass\nclass B(Module): pass"
    assert fault(source).reason == Reason.of(
        "runtime.one_module_class",
        names=(
            "A",
            "B",
        ),
    )


def test_a_declaration_that_contradicts_itself_is_a_fault_with_its_line():
    error = fault("from onika.module import InVar, Module\nclass A(Module):\n    X = InVar('real')\n")
    assert error.place.line == 3
    assert str(error.reason) == (
        "expected a module that can be imported"
        ", found ValueError: expected a type such as double, int or double[NDOF,4], found 'real'"
    )


def test_a_module_may_use_dataclasses_with_annotations_as_text():
    source = """
from __future__ import annotations
from dataclasses import dataclass
from onika.module import Module

@dataclass(slots=True)
class Point:
    x: float = 0.0

class Uses(Module):
    point = Point(1.0)
"""
    assert load(source, "lab/m.py", "m").point.x == 1.0


def test_an_exception_is_told_in_one_line():
    assert traceback_text(ValueError("too far")) == "ValueError: too far"
    assert traceback_text(KeyError()) == "KeyError"


def test_the_line_is_that_of_the_file_and_not_of_what_it_called():
    try:
        exec(compile("import json\n\njson.loads('[')", "lab/m.py", "exec"))
    except ValueError as wrong:
        assert line_in("lab/m.py", wrong) == 3
        assert line_in("lab/other.py", wrong) == 0


def test_the_place_of_an_error_is_in_the_modules_own_file():  # R-A18
    namespace = {}
    exec(compile("def f():\n    raise ValueError('x')\n\ndef g():\n    f()", "m.py", "exec"), namespace)
    try:
        namespace["g"]()
    except ValueError as wrong:
        path, line, trace = where("m.py", wrong)
    assert (path, line) == ("m.py", 2)
    assert trace.count('File "m.py"') == 2
    assert trace.endswith("ValueError: x")
    assert "test_code" not in trace


def test_an_error_from_elsewhere_has_no_line():
    try:
        int("x")
    except ValueError as wrong:
        assert where("m.py", wrong)[:2] == ("m.py", 0)


def test_what_is_compiled_already_is_executed_as_it_is():  # law 21
    code = compiled(GOOD, "lab/m.py", "m")
    assert load("never looked at", "lab/m.py", "m", code).__name__ == "Still"
    wrong = compiled("class :", "lab/m.py", "m")
    assert isinstance(wrong, Fault)
    assert load("class :", "lab/m.py", "m", wrong) is wrong
