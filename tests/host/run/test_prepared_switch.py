"""What follows an action lies ready on its unit, and what the user wants waits until it does not."""

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.runtime.executor import executor
from onika.engine import news as said, orders
from onika.engine.engine import Engine
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.run.prepared_switch import PreparedSwitches
from onika.model.lifecycle import State
from onika.ring.segment import Segment
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.wire import steer


class Units:
    def __init__(self):
        self.sent = []

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def take(self, kind):
        orders_sent = [order for _, order in self.sent if isinstance(order, kind)]
        self.sent = [(rtpu, order) for rtpu, order in self.sent if not isinstance(order, kind)]
        return orders_sent


class View:
    """One flow: `go` and `bell`, then `ring` and `bell`; `bell` and `ring` end them."""

    def __init__(self, homes=("rt0", "rt0", "rt0")):
        shop = PlanBuilder()
        trigger = "from onika.module import Module\nclass Bell(Module):\n    trigger = True\n"
        plain = "from onika.module import Module, OutVar\nclass Go(Module):\n    A = OutVar('double')\n"
        shop.task("go", plain)
        shop.task("bell", trigger)
        shop.task("ring", trigger + "    # another\n")
        plan = shop.plan([action("go", "bell"), action("go", "ring"), action("go", "bell")])
        prepared = prepare(plan, (), ModuleFacts())
        rtpus = dict(zip(("go", "bell", "ring"), homes, strict=True))
        self.subsystem = RunningSubsystem("flow0", Table(Segment.create("table", SIZE)), prepared.flows[0], rtpus)
        ranks = {(0, name): rank for name, rank in self.subsystem.ranks.items()}
        self.engine = Engine(plan, prepared.triggers, frozenset(), ranks)
        self.units = Units()
        self.prepared = PreparedSwitches(self.engine, {0: executor(self.subsystem, self.units)})
        self.feed(said.Run(), *(said.Spawned(0, name) for name in rtpus))
        self.on("go", "bell")

    def feed(self, *news):
        commands = [order for news in news for order in self.engine.feed(news)]
        self.prepared.refresh()
        return commands

    def on(self, *names):
        for name in names:
            self.subsystem.members[name].state = State.ON
            self.feed(said.TurnedOn(0, name))


def test_the_next_switch_is_prepared_as_soon_as_everybody_is_on():
    (prepared,) = View().units.take(command.PreparedSwitch)
    assert (prepared.subsystem, prepared.task) == ("flow0", "bell")
    (case,) = prepared.cases
    assert (case.choice, case.loop, case.number) == (None, None, 1)
    assert ([task.task for task in case.switch.on], case.switch.off) == (["ring"], ())


def test_nothing_is_prepared_for_tasks_on_several_units():  # law 3: only one unit keeps the order by itself
    assert View(("rt0", "rt0", "rt1")).units.take(command.PreparedSwitch) == []


def test_what_was_carried_out_is_not_ordered_again():
    view = View()
    view.units.take(command.PreparedSwitch)
    switches = [
        message for message in view.feed(said.Finished(0, "bell", switched=1)) if isinstance(message, orders.Switch)
    ]
    assert [switch.number for switch in switches] == [1]
    assert view.prepared.switched(switches[0]) is None


def test_what_was_missing_in_it_is_still_to_be_done():
    view = View()
    order = orders.Switch(0, ("go",), (orders.Launch("ring"), orders.Launch("bell")), (), 1)
    assert view.prepared.switched(order) == orders.Switch(0, ("go",), (orders.Launch("bell"),))


def test_the_user_waits_until_nothing_is_prepared():  # R-E07
    view = View()
    view.units.take(command.PreparedSwitch)
    done = []
    view.prepared.when_free(0, lambda: done.append("pause"))
    view.prepared.when_free(0, lambda: done.append("again"))
    assert done == []
    assert [prepared.cases for prepared in view.units.take(command.PreparedSwitch)] == [()]  # asked to forget once
    view.prepared.freed(0)
    assert done == ["pause", "again"]
    view.prepared.when_free(0, lambda: done.append("at once"))
    assert done[-1] == "at once"


def test_nothing_is_prepared_while_the_user_waits():
    view = View()
    view.prepared.when_free(0, lambda: None)
    view.units.take(command.PreparedSwitch)
    view.prepared.refresh()
    assert view.units.take(command.PreparedSwitch) == []
    view.prepared.freed(0)
    view.prepared.refresh()
    assert len(view.units.take(command.PreparedSwitch)) == 1


def test_a_flow_that_is_to_pause_has_nothing_prepared():  # R-E07
    view = View()
    view.prepared.freed(0)
    view.units.take(command.PreparedSwitch)
    view.feed(steer.Pause("flow0"))
    assert view.units.take(command.PreparedSwitch) == []


@pytest.mark.parametrize("end", ["free_all", "finished"])
def test_at_the_end_nobody_waits_any_more(end):
    view = View()
    done = []
    view.prepared.when_free(0, lambda: done.append(1))
    if end == "free_all":
        view.prepared.free_all()
    else:
        view.prepared.finished(0)
        view.prepared.freed(0)
    assert done == [1]
