"""The module class."""

from types import SimpleNamespace

import pytest

from onika.module import Input, InVar, Local, Module, ModuleError, OutVar
from onika.testing.rig import Rig
from onika.testing.source import module


class Plain(Module):
    X = InVar("double", "m", "place")
    goal = Input("double", "m", "where")
    GAIN = Local("double", "-", "gain", default=2.0)


def test_declarations_are_collected_by_kind_in_order():  # R-A01
    assert list(Plain.declared_ports) == ["X"]
    assert list(Plain.declared_inputs) == ["goal"]
    assert list(Plain.declared_locals) == ["GAIN"]


def test_a_subclass_adds_to_its_own_declarations_only():  # R-A01
    class More(Plain):
        Y = OutVar("double")

    assert list(More.declared_ports) == ["X", "Y"]
    assert list(Plain.declared_ports) == ["X"]
    assert Module.declared_ports == {}


def test_user_input_is_handed_to_on_and_is_no_attribute():  # R-A10
    assert not hasattr(Plain, "goal")


def test_every_entry_point_may_be_left_out():  # R-A01
    one = Plain()
    one.init()
    one.reinit()
    one.on(SimpleNamespace())
    assert one.cycle() is one.sync() is None
    one.off()
    one.kill()
    one.clear()


def test_reinit_is_init_unless_said_otherwise():  # R-A13
    calls = []
    cls = type("Counts", (Module,), {"init": lambda self: calls.append("init")})
    cls().reinit()
    assert calls == ["init"]


def test_hold_is_a_cycle_unless_said_otherwise():  # law 4
    calls = []
    cls = type("Counts", (Module,), {"cycle": lambda self: calls.append("cycle")})
    cls().hold()
    assert calls == ["cycle"]


def test_an_error_is_not_mended_unless_said_otherwise():  # R-A09
    assert Plain().error(ValueError()) is False


@pytest.mark.parametrize("ask", [lambda one: one.get("speed"), lambda one: one.set("speed", "1")])
def test_what_there_is_nothing_of_to_get_or_set_is_refused_by_name(ask):  # R-A05
    with pytest.raises(ModuleError, match="'speed'"):
        ask(Plain())


def test_warnings_are_texts():  # R-A07
    one = Plain()
    one.warn("slow")
    one.warn(ValueError("hot"))
    assert one.warnings == ["slow", "hot"]


def test_a_reference_continues_while_it_is_in_force():  # law 3
    one = Plain()
    assert not one.continues("Q_REF")
    one.in_force = frozenset({"Q_REF"})
    assert one.continues("Q_REF")


def test_a_module_is_general_and_no_hardware_unless_it_says_so():  # R-A08, law 24
    assert (Module.trigger, Module.passive, Module.hardware, Module.crit) == (False, False, False, 0)


def test_a_robot_says_nothing_of_itself_and_reaches_everything_unless_it_knows_better():  # law 26
    assert Module.constants(SimpleNamespace()) == {}
    assert Module.resolve({}, [("joint object", [1.0]), ("force object", [2.0])]) == [None, None]


def test_compiled_code_gets_the_memory_of_a_port():  # R-A01
    rig = Rig().spawn("one", module("    X = InVar('double')\n    Y = OutVar('int[2]')"))
    one = rig.task("one").module
    one.buffer("Y")[:] = (3, 4)
    assert one.Y.tolist() == [3, 4]
    assert (one.buffer("X").shape, one.buffer("X").flags.writeable) == ((1,), False)
    with pytest.raises(AttributeError, match=r"expected a port \(X, Y\), found Z"):
        one.buffer("Z")
