import builtins
import sys
from functools import partial
from types import ModuleType

import pytest

from onika.host.guards.code_guard import CodeGuard, Replaced, own_code
from onika.runtime.execution.executive import Executive

OURS = """
LIMIT = 3

def step(): ...

class Drive:
    def hold(self): ...
    @property
    def mode(self): ...
    @staticmethod
    def of(): ...
"""


@pytest.fixture
def ours():
    module = ModuleType("onika.pretended")
    exec(OURS, vars(module))
    return module


def of_a_task(source):
    """What the code of a task's module makes."""
    namespace = {"__name__": "onika_task_sick"}
    exec(source, namespace)
    return namespace["it"]


def test_nothing_was_replaced(ours):  # law 14
    guard = CodeGuard([ours])
    ours.LIMIT, ours.more = 4, print
    ours.Drive.count = 7
    assert guard.replaced() is None


@pytest.mark.parametrize("source", ["it = lambda self: None", "class it: ..."])
def test_a_replaced_method_is_named_and_the_module_whose_code_stands_there(ours, source):  # law 14
    guard = CodeGuard([ours])
    ours.Drive.hold = of_a_task(source)
    assert guard.replaced() == Replaced("onika.pretended.Drive.hold", "sick")


@pytest.mark.parametrize("name", ["mode", "of"])
def test_properties_and_static_methods_count_too(ours, name):  # law 14
    guard = CodeGuard([ours])
    setattr(ours.Drive, name, 5)
    assert guard.replaced() == Replaced(f"onika.pretended.Drive.{name}", "")


@pytest.mark.parametrize("name", ["step", "Drive"])
def test_a_replaced_function_or_class_of_a_module_is_named(ours, name):  # law 14
    guard = CodeGuard([ours])
    setattr(ours, name, partial(print))
    assert guard.replaced() == Replaced(f"onika.pretended.{name}", "")


def test_what_was_deleted_is_named(ours):  # law 14
    guard = CodeGuard([ours])
    del ours.Drive.hold
    assert guard.replaced() == Replaced("onika.pretended.Drive.hold", "")


def test_our_own_code_holds_what_a_cycle_consists_of(monkeypatch):  # law 14
    assert {builtins, sys.modules[Executive.__module__]} <= set(own_code())
    guard = CodeGuard(own_code())
    assert guard.replaced() is None
    monkeypatch.setattr(Executive, "handle", of_a_task("it = lambda *given: []"))
    assert guard.replaced() == Replaced("onika.runtime.execution.executive.Executive.handle", "sick")
