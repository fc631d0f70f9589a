import numpy as np
import pytest

from kit.runtime.executive_rig import ExecutiveRig
from onika.runtime.sandbox.confined_instance import ConfinedInstance
from onika.runtime.sandbox.sandbox_messages import Bind, Call, Declared, Load, PortPlace, Refused, Returned

SOURCE = """
from onika.module import InVar, Module, OutVar

class Double(Module):
    X = InVar("double", "-", "a number")
    Y = OutVar("double", "-", "twice as much")

    def cycle(self):
        self.Y = 2 * self.X
        return {returned}

    def get(self, name):
        return {given}
"""


def instance(returned="None", given="1"):
    """One whose number lies at 0, and twice as much at 64."""
    memory = memoryview(bytearray(4096))
    confined = ConfinedInstance(memory)
    spawn = ExecutiveRig().spawn_of("double", SOURCE.format(returned=returned, given=given))
    assert isinstance(confined.answer(Load(spawn)), Declared)
    places = PortPlace("X", "double", 64, 8), PortPlace("Y", "double", 128, 8)
    assert confined.answer(Bind(places, {})) == Returned()
    return confined, np.frombuffer(memory)


def test_a_cycle_takes_what_lies_there_and_leaves_what_comes_of_it():
    confined, numbers = instance()
    numbers[8] = 3.5
    assert confined.cycle(0.0, 0) is None
    assert numbers[16] == 7.0


@pytest.mark.parametrize("returned", ["'nonsense'", "finish", "3"])
def test_what_is_no_signal_is_said(returned):
    confined, _ = instance(returned)
    raised = confined.cycle(0.0, 0).raised
    assert raised.line or raised.why


def test_an_entry_that_is_none_is_said():
    confined, _ = instance()
    assert "found '__init__'" in str(confined.answer(Call("__init__", 0.0, 0.01)).raised.why)


def test_before_it_is_bound_it_does_nothing():
    confined = ConfinedInstance(memoryview(bytearray(64)))
    assert "bound" in str(confined.answer(Call("on", 0.0, 0.01, 0, ({},))).raised.why)
    assert "loaded" in str(confined.answer(Bind((), {})).raised.why)
    assert "bound" in str(confined.cycle(0.0, 0).raised.why)


def test_what_cannot_be_loaded_is_said():
    confined = ConfinedInstance(memoryview(bytearray(64)))
    answer = confined.answer(Load(ExecutiveRig().spawn_of("bad", "1 +")))
    assert isinstance(answer, Refused)
    assert "bad.py" in answer.reason.text or answer.reason.text


def test_what_is_not_permitted_says_that_it_may_only_compute():  # R-X16
    confined, _ = instance(given="open('/dev/null') if False else (_ for _ in ()).throw(PermissionError(1, 'no'))")
    said = str(confined.answer(Call("get", 0.0, 0.01, 0, ("x",))).raised.why)
    assert "may only compute" in said
