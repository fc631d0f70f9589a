"""Sources of small modules."""

from kit.labs.module_source import COUNTER, cycle, module
from onika.runtime.modules.code import load


def test_a_source_is_a_module_with_its_flags():
    cls = load(module(trigger=True, crit=2), "one.py", "one")
    assert (cls.__name__, cls.trigger, cls.crit) == ("One", True, 2)


def test_a_cycle_is_one_line():
    assert load(cycle("return 5"), "one.py", "one")().cycle() == 5


def test_a_counter_has_one_output():
    assert list(load(COUNTER, "one.py", "one").declared_ports) == ["N"]
