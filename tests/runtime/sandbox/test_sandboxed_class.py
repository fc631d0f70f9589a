import pytest
from msgspec import structs

from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.runtime.local_sandbox import LocalSandbox, sandboxed
from onika.runtime import news
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.sandbox.sandbox_messages import Declared, encode
from onika.runtime.sandbox.sandboxed_class import load_sandboxed

SOURCE = """
from onika.module import InConst, Input, Local, Module, OutVar

class Scale(Module):
    passive = True
    crit = 3
    NDOF = InConst("int", "-", "how many")
    Y = OutVar("double[NDOF]", "rad", "scaled", name="Y^")
    GAIN = Local("double", "-", "by how much", default=2.0, low=0.0)
    count = Input("int", "-", "how many cycles", low=0, high="NDOF")
"""


def tried(answers):
    """A task whose sandbox answers this when its module is loaded."""
    rig = ExecutiveRig()
    spawn = sandboxed(rig.spawn_of("scale", SOURCE, constants={"NDOF": 3}))
    sandbox = LocalSandbox(spawn, answers)
    rig.executive.give_sandbox((HOME, "scale"), sandbox)
    return rig.do(spawn), sandbox


def test_the_class_declares_what_the_module_declares():  # R-X16
    spawn = sandboxed(ExecutiveRig().spawn_of("scale", SOURCE, constants={"NDOF": 3}))
    cls = load_sandboxed(spawn, LocalSandbox(spawn))
    assert (cls.passive, cls.trigger, cls.crit) == (True, False, 3)
    assert sheet_of(cls).ports == spawn.sandboxed_as.ports
    assert sheet_of(cls).inputs == spawn.sandboxed_as.inputs


def _declared(attribute="Y", step=None, **changed):
    """What the module above declares, with something else at its port."""
    sheet = sandboxed(ExecutiveRig().spawn_of("scale", SOURCE, constants={"NDOF": 3})).sandboxed_as
    ports = (sheet.ports[0], structs.replace(sheet.ports[1], **changed))
    return encode(Declared(structs.replace(sheet, ports=ports), ("NDOF", attribute), (None, step)))


@pytest.mark.parametrize(
    "answer",
    [_declared(name="Q"), _declared(shape="int"), _declared(kind="OUTBOTH"), _declared(kind="NONE")],
)
def test_one_that_declares_something_else_than_when_it_was_looked_at_is_not_run(answer):  # R-X16
    rig, sandbox = tried([answer])
    assert "declares something else" in rig.last(news.Refused).reason
    assert sandbox.is_closed


@pytest.mark.parametrize(
    ("answer", "why"),
    [(_declared(attribute="cycle"), "stand for nothing else"), (_declared(step="NOBODY"), "step")],
)
def test_names_in_python_and_steps_of_its_ports_are_checked_too(answer, why):  # R-X16
    rig, sandbox = tried([answer])
    assert why in rig.last(news.Refused).reason
    assert sandbox.is_closed


def test_a_task_whose_sandbox_was_not_begun_is_refused():
    rig = ExecutiveRig()
    rig.do(sandboxed(rig.spawn_of("scale", SOURCE, constants={"NDOF": 3})))
    assert "was not begun" in rig.last(news.Refused).reason
