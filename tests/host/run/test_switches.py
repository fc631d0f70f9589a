"""Switches go out alone or as one, and none that would give a variable a second writer."""

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.runtime.executor import executor
from onika.engine import orders
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.run.switches import Switches
from onika.model.lifecycle import State
from onika.ring.segment import Segment
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table

WRITER = "from onika.module import Module, OutVar\nclass {}(Module):\n    trigger = True\n    A = OutVar('double')\n"


class PreparedSwitches:
    """Nothing is prepared, but what a test says was done already."""

    def __init__(self):
        self.rest = None

    def switched(self, switch):
        return self.rest

    def finished(self, flow):
        pass


class Switcher:
    """Two flows of the tasks `one` and `two`, which write the same variable."""

    def __init__(self):
        shop = PlanBuilder()
        for name in ("one", "two"):
            shop.task(name, WRITER.format(name.title()))
        plan = shop.plan([action("one"), action("two")], [action("one"), action("two")])
        prepared = prepare(plan, (), ModuleFacts())
        homes = {"one": "rt0", "two": "rt0"}
        self.subsystems = {
            n: RunningSubsystem(f"flow{n}", Table(Segment.create("table", SIZE)), flow, homes)
            for n, flow in enumerate(prepared.flows)
        }
        self.sent, self.refused, self.prepared = [], [], PreparedSwitches()
        executors = {
            flow: executor(home, self, lambda message, _before: self.refused.append(message))
            for flow, home in self.subsystems.items()
        }
        self.switches = Switches(executors, self.prepared, self)

    def send(self, rtpu, order):
        self.sent.append(order)


@pytest.fixture
def switcher():
    return Switcher()


def start(flow, task, *off, number=0):
    return orders.Switch(flow, off, (orders.Launch(task, "", None),), number=number)


def test_a_switch_goes_out_at_once(switcher):  # R-A07
    switcher.switches.switch(start(0, "one"))
    (sent,) = switcher.sent
    assert isinstance(sent, command.Switch)
    assert [task.task for task in sent.on] == ["one"]


def test_switches_that_belong_together_go_out_as_one_command(switcher):  # R-E04
    switcher.switches.together(2)
    switcher.switches.switch(start(0, "one"))
    assert switcher.sent == []
    switcher.switches.switch(start(1, "two"))
    (sent,) = switcher.sent
    assert isinstance(sent, command.Together)
    assert [switch.subsystem for switch in sent.switches] == ["flow0", "flow1"]


def test_a_second_writer_does_not_come_on_and_the_others_do(switcher):  # law 9
    switcher.subsystems[0].members["one"].state = State.ON
    switcher.switches.together(2)
    switcher.switches.switch(start(0, "two"))
    switcher.switches.switch(start(1, "two"))
    (refused,) = switcher.refused
    assert (refused.subsystem, refused.task, refused.command) == ("flow0", "two", "on")
    assert str(refused.reason) == "A is written by task one, which is ON"
    assert [order.subsystem for order in switcher.sent] == ["flow1"]


def test_what_a_unit_has_done_by_itself_is_not_done_again(switcher):  # decision 19
    switcher.switches.switch(start(0, "one", number=1))
    assert switcher.sent == []
    switcher.prepared.rest = orders.Switch(0, ("one",), ())
    switcher.switches.switch(start(0, "one", "one", number=1))
    assert [order.off for order in switcher.sent] == [("one",)]
