"""A runner without processes: it runs a plan of four small tasks, and its units only note what they are told."""

from collections.abc import Sequence
from typing import Self, TypeVar

from kit.plans.plan_builder import Action, PlanBuilder
from kit.worlds.rail_world import YardLoading
from onika.host.loading.plan_preparation import prepare
from onika.host.run.runner import Runner
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.wire import event
from onika.wire.request import Begin

_O = TypeVar("_O")
_E = TypeVar("_E")

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

    def __init__(self) -> None:
        self.sent: list[tuple[str, command.Command]] = []
        self.granted: list[tuple[str, str]] = []
        self.released: list[str] = []
        self.refuses = ""

    def send(self, rtpu: str, order: command.Command) -> None:
        """Note an order."""
        self.sent.append((rtpu, order))

    def grant(self, rtpu: str, device: str) -> command.DeviceGrant:
        """Grant a device, or raise ValueError where `refuses` says why not."""
        if self.refuses:
            raise ValueError(self.refuses)
        self.granted.append((rtpu, device))
        return command.DeviceGrant("bus:yard", device, ("time", "drive"), ("f",), {}, 1, 0, 64)

    def release(self, device: str) -> None:
        """Note that a device is free again."""
        self.released.append(device)

    def take(self, kind: type[_O]) -> list[tuple[str, _O]]:
        """The orders of this kind that were noted since they were last taken."""
        taken: list[tuple[str, _O]] = [(rtpu, order) for rtpu, order in self.sent if isinstance(order, kind)]
        self.sent = [entry for entry in self.sent if entry not in taken]
        return taken


class RunnerRig:
    """A runner of the plan `flows`, and what came of it."""

    def __init__(self, *flows: Sequence[Action], begin: Begin | None = None, units: NotingUnits | None = None) -> None:
        shop = PlanBuilder()
        shop.task("arm", ARM, local={"DEVICE": "yard:m0"}, rtpu="rt0")
        shop.task("go", GO, rtpu="rt1")
        shop.task("bell", BELL, rtpu="rt0")
        shop.task("show", SHOW, rtpu="rt0")
        prepared = prepare(shop.plan(*flows), (), YardLoading())
        assert prepared.faults == []
        self.tables: dict[str, Table] = {}
        subsystems: dict[int, RunningSubsystem] = {}
        for number, flow in enumerate(prepared.plan.flows):
            table = self.tables[flow.subsystem] = Table(Segment.create("table", SIZE))
            rtpus = {task.name: task.rtpu for task in flow.tasks}
            subsystems[number] = RunningSubsystem(flow.subsystem, table, prepared.flows[number], rtpus)
        self.units = units or NotingUnits()
        self.events: list[event.Event] = []
        self.runner = Runner(prepared, begin or Begin(settle_s=0.5), subsystems, self.units, self.events.append)
        self.now = 1_000

    def start(self) -> Self:
        """Begin the run."""
        self.runner.start(self.now)
        return self

    def hear(self, message: news.News, rtpu: str = "rt0") -> Self:
        """News of a unit."""
        self.runner.hear(rtpu, message, self.now)
        return self

    def spawned(self, *names: str, subsystem: str = "flow0") -> Self:
        """News that tasks live; the arm has written its constant."""
        for name in names:
            if name == "arm":
                self.tables[subsystem].ring("N").write((2).to_bytes(4, "little"))
            self.hear(news.Initialised(subsystem, name))
        return self

    def turned_on(self, *names: str, subsystem: str = "flow0") -> Self:
        """News that tasks are ON."""
        for name in names:
            self.hear(news.Changed(subsystem, name, "ON", self.now))
        return self

    def finish(self, name: str, subsystem: str = "flow0") -> Self:
        """News that a trigger has finished."""
        return self.hear(news.Finished(subsystem, name, 0, False, self.now))

    def of(self, kind: type[_E]) -> list[_E]:
        """The events of this kind that were told."""
        return [message for message in self.events if isinstance(message, kind)]
