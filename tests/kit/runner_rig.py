"""A runner without processes: it runs a plan of four small tasks, and its units only note what they are told."""

from kit.plan_builder import PlanBuilder
from kit.rail_world import YardLoading
from onika.host.loading.plan_preparation import prepare
from onika.host.run.runner import Runner
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.wire.request import Begin

ARM = """
from onika.module import InVar, Module, OutConst, OutVar

class Arm(Module):
    hardware = True
    N = OutConst("int", "-", "number of joints")
    Q_REF = InVar("double", "m", "where to")
    Q_MEZ = OutVar("double", "m", "where it is")
"""
GO = """
from onika.module import InConst, Module, OutVar, finish

class Go(Module):
    trigger = True
    N = InConst("int", "-", "number of joints")
    Q_REF = OutVar("double", "m", "where to")
"""
BELL = "from onika.module import Module\nclass Bell(Module):\n    trigger = True\n"
SHOW = "from onika.module import Module\nclass Show(Module):\n    passive = True\n"


class NotingUnits:
    """RTPUs that only note what they are told."""

    def __init__(self):
        self.sent = []
        self.granted = []
        self.released = []
        self.refuses = ""

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def grant(self, rtpu, device):
        if self.refuses:
            raise ValueError(self.refuses)
        self.granted.append((rtpu, device))
        return command.DeviceGrant("bus:yard", device, ("time", "drive"), ("f",), {}, 1, 0, 64)

    def release(self, device):
        self.released.append(device)

    def take(self, kind):
        taken = [(rtpu, order) for rtpu, order in self.sent if isinstance(order, kind)]
        self.sent = [entry for entry in self.sent if entry not in taken]
        return taken


class RunnerRig:
    """A runner of the plan `flows`, and what came of it."""

    def __init__(self, *flows, begin=None, units=None):
        shop = PlanBuilder()
        shop.task("arm", ARM, local={"DEVICE": "yard:m0"}, rtpu="rt0")
        shop.task("go", GO, rtpu="rt1")
        shop.task("bell", BELL, rtpu="rt0")
        shop.task("show", SHOW, rtpu="rt0")
        prepared = prepare(shop.plan(*flows), (), YardLoading())
        assert prepared.faults == []
        self.tables, subsystems = {}, {}
        for number, flow in enumerate(prepared.plan.flows):
            table = self.tables[flow.subsystem] = Table(Segment.create("table", SIZE))
            rtpus = {task.name: task.rtpu for task in flow.tasks}
            subsystems[number] = RunningSubsystem(flow.subsystem, table, prepared.flows[number], rtpus)
        self.units = units or NotingUnits()
        self.events = []
        self.runner = Runner(prepared, begin or Begin(settle_s=0.5), subsystems, self.units, self.events.append)
        self.now = 1_000

    def start(self):
        self.runner.start(self.now)
        return self

    def hear(self, message, rtpu="rt0"):
        self.runner.hear(rtpu, message, self.now)
        return self

    def spawned(self, *names, subsystem="flow0"):
        for name in names:
            if name == "arm":
                self.tables[subsystem].ring("N").write((2).to_bytes(4, "little"))
            self.hear(news.Initialised(subsystem, name))
        return self

    def turned_on(self, *names, subsystem="flow0"):
        for name in names:
            self.hear(news.Changed(subsystem, name, "ON", self.now))
        return self

    def finish(self, name, subsystem="flow0"):
        return self.hear(news.Finished(subsystem, name, 0, False, self.now))

    def of(self, kind):
        return [message for message in self.events if isinstance(message, kind)]
