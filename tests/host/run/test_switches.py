"""Switches go out alone or as one, and none that would give a variable a second writer."""

import pytest

from kit.plan_builder import PlanBuilder, action
from onika.engine import orders
from onika.host.loading.module_facts import DirectLoading
from onika.host.loading.plan_preparation import prepare
from onika.host.run.switch_dispatch import Switchboard
from onika.host.run.switches import Switching
from onika.model.lifecycle import State
from onika.ring.segment import Segment
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table

WRITER = "from onika.module import Module, OutVar\nclass {}(Module):\n    trigger = True\n    A = OutVar('double')\n"


class Outlook:
    """Nothing is prepared, but what a test says was done already."""

    def __init__(self):
        self.rest = None

    def switched(self, flow, order):
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
        prepared = prepare(plan, (), DirectLoading())
        homes = {"one": "rt0", "two": "rt0"}
        self.subsystems = {
            n: RunningSubsystem(f"flow{n}", Table(Segment.create("table", SIZE)), flow, homes)
            for n, flow in enumerate(prepared.flows)
        }
        self.sent, self.refused, self.outlook = [], [], Outlook()
        board = Switchboard(self.subsystems, self)
        self.switching = Switching(self.subsystems, self.outlook, board, lambda *why: self.refused.append(why))

    def send(self, rtpu, order):
        self.sent.append(order)


@pytest.fixture
def switcher():
    return Switcher()


def start(flow, task, *off, number=0):
    return orders.Switch(flow, off, (orders.Start(task, "", None),), number=number)


def test_a_switch_goes_out_at_once(switcher):  # R-A07
    switcher.switching.switch(start(0, "one"))
    (sent,) = switcher.sent
    assert isinstance(sent, command.Switch)
    assert [one.task for one in sent.on] == ["one"]


def test_switches_that_belong_together_go_out_as_one_command(switcher):  # R-E04
    switcher.switching.together(2)
    switcher.switching.switch(start(0, "one"))
    assert switcher.sent == []
    switcher.switching.switch(start(1, "two"))
    (sent,) = switcher.sent
    assert isinstance(sent, command.Together)
    assert [one.subsystem for one in sent.switches] == ["flow0", "flow1"]


def test_a_second_writer_does_not_come_on_and_the_others_do(switcher):  # law 9
    switcher.subsystems[0].members["one"].state = State.ON
    switcher.switching.together(2)
    switcher.switching.switch(start(0, "two"))
    switcher.switching.switch(start(1, "two"))
    ((flow, task, reason),) = switcher.refused
    assert (flow, task) == (0, "two")
    assert reason == "A is written by task one, which is ON"
    assert [one.subsystem for one in switcher.sent] == ["flow1"]


def test_what_a_unit_has_done_by_itself_is_not_done_again(switcher):  # decision 19
    switcher.switching.switch(start(0, "one", number=1))
    assert switcher.sent == []
    switcher.outlook.rest = orders.Switch(0, ("one",), ())
    switcher.switching.switch(start(0, "one", "one", number=1))
    assert [one.off for one in switcher.sent] == [("one",)]
