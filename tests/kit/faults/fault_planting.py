"""Faults planted in a runtime in virtual time, and what then happens, to be held against what was foreseen (X24).

In subsystem flow0 an application runs: `mass` commands a device from unit rt0, `push` from rt1 says with what force,
`lamp` is passive. In subsystem hand the same stands by hand: `mass2`, `push2`. Every module does something sick when
a test says so.
"""

from collections.abc import Sequence
from math import isfinite

from kit.faults.foreseen_changes import Change, changes_of
from kit.plans.plan_builder import PlanBuilder, action
from kit.runtime.direct_client import OpenGate
from kit.runtime.live_edits import LossyClient, LossyDriver
from kit.worlds.mass_world import MassWorld
from kit.worlds.rail_world import YardLoading
from onika.host.program import RuntimeProgram
from onika.host.sessions.leases import Leases
from onika.host.units.supervisor import SILENT_NS
from onika.host.units.unit_loss import dead_writers
from onika.ring.device import DeviceOrder, DriveState
from onika.runtime import command
from onika.runtime.command import DeviceGrant
from onika.wire import event, live, request
from onika.wire.foresight import Foreseen, Foresight, WhatIf
from onika.words.reason import Reason

SICK = """
    def init(self):
        self._sick = ""
{init}

    def cycle(self):
        if self._sick == "raise":
            raise ModuleError("sick")
        spoilt = float("nan") if self._sick == "nan" else 0.0
{cycle}
"""
MASS = """
from onika.module import InVar, Module, ModuleError, OutVar

class Mass(Module):
    hardware = True

    FORCE = InVar("double", "N", "what pushes it")
    X = OutVar("double", "m", "where it is")
""" + SICK.format(
    init="",
    cycle="""
        self.X = self.device.read()[0] + spoilt
        self.check_drive()
        self.device.write((self.FORCE,))
""",
)
PUSH = """
from onika.module import InVar, Module, ModuleError, OutVar

class Push(Module):
    trigger = True

    X = InVar("double", "m", "where it is")
    FORCE = OutVar("double", "N", "what pushes it")
""" + SICK.format(init="", cycle="        self.FORCE = 0.1 + spoilt\n")
LAMP = """
from onika.module import InVar, Module, ModuleError, OutVar

class Lamp(Module):
    passive = True

    X = InVar("double", "m", "where it is")
    SEEN = OutVar("double", "m", "where it was seen")
""" + SICK.format(init="", cycle="        self.SEEN = self.X + spoilt\n")
MS = 1_000_000
_AFTER_MS = 150.0
_LEASE_NS, _LOOK_NS = 250 * MS, 50 * MS


class SensitiveWorld(MassWorld):
    """A world whose drives trip at a command that is no number, and have a button each."""

    def command(self, device: str, epoch: int, order: int, values: Sequence[float]) -> None:
        """As any world; but what is no number trips the drive."""
        if order == DeviceOrder.DRIVE and not all(map(isfinite, values)):
            self._turn(self._masses[device], DriveState.TRIPPED, "no number")
        else:
            super().command(device, epoch, order, values)

    def release(self, device: str, epoch: int) -> None:
        """As any world; but what has tripped stays so."""
        mass = self._masses[device]
        if mass.drive is not DriveState.TRIPPED:
            super().release(device, epoch)
        elif mass.epoch == epoch:
            mass.epoch = None

    def touch(self, part: str, value: float) -> None:
        """Press the button of one mass."""
        self._turn(self._masses[part], DriveState.PRESSED if value else DriveState.TRIPPED, "pressed")


class TimedGate(OpenGate):
    """A gate that notes when something was said, by the runtime's clock."""

    def __init__(self) -> None:
        super().__init__()
        self.times: list[tuple[int, event.Event]] = []
        self.clock: FaultyDriver | None = None

    def tell(self, message: event.Event, subsystem: str = "", session: str = "") -> None:
        """Say it, and note when."""
        super().tell(message, subsystem, session)
        if self.clock is not None:
            self.times.append((self.clock.now, message))


class FaultyDriver(LossyDriver):
    """Units freeze and die as processes do: they cycle no more, and drives are fenced when they are given up."""

    def __init__(self, rtpus: tuple[str, ...], server: OpenGate) -> None:
        super().__init__(rtpus, server)
        self._buses._open = lambda _name: SensitiveWorld()
        self._writers: dict[str, str] = {}
        self._stand = False

    def grant(self, rtpu: str, device: str) -> DeviceGrant:
        """Claim a device for a task of a unit."""
        self._writers[device] = rtpu
        return super().grant(rtpu, device)

    def release(self, device: str) -> None:
        """Give a device back, if its writer is not dead."""
        self._writers.pop(device, None)
        super().release(device)

    def freeze(self, rtpu: str) -> None:
        """The unit does nothing from now on."""
        self.gone.add(rtpu)
        for (subsystem, task), home in self._units.homes.items():
            running = self.living().get((subsystem, task))
            if home == rtpu and running is not None:
                self._executive._unit.leave(running, self.now)

    def lose(self, rtpu: str) -> None:
        """The unit is given up, as the supervisor of processes does: what it claimed is fenced, then it is told."""
        self.freeze(rtpu)
        for device in dead_writers(rtpu, self._writers):
            for world in self._buses.worlds:
                world.fence(self._buses._claims[device])
        reason = Reason.of("host.process_killed", name=rtpu, signal=9, during=Reason.plain(""))
        self.lost(rtpu, reason, self.now)

    def freeze_worlds(self) -> None:
        """Worlds step no more, and publish nothing."""
        self._stand = True

    def lose_worlds(self) -> None:
        """The device server is given up."""
        self.freeze_worlds()
        for unit in sorted(self._units.names - self.gone):
            self.send(unit, command.Fail(Reason.of("host.the_device_server")))
        self.lost("", Reason.of("host.the_device_server"), self.now)

    def _step_worlds(self, now: int) -> bool:
        if self._stand:
            self._now, self.turn = now, 0
            return False
        return super()._step_worlds(now)

    def is_at_rest(self) -> bool:
        """As the clock says; worlds that stand make no step."""
        return self._stand or super().is_at_rest()

    def oversleep(self, by_ns: int) -> None:
        """Nobody cycles for so long; then everything that is overdue does."""
        self._step_worlds(self.now + by_ns)

    def trip(self, device: str) -> None:
        """A command that is no number reaches a drive all the same."""
        name = device.partition(":")[2]
        for world in self._buses.worlds:
            world.command(name, self._buses._claims[device], int(DeviceOrder.DRIVE), (float("nan"),))

    def lost(self, rtpu: str, reason: Reason, now: int) -> None:
        """Pass it on, and carry out what follows."""
        super().lost(rtpu, reason, now)
        self._deliver()


class FaultyRuntime(LossyClient):
    """The runtime with the application and the subsystem by hand."""

    def __init__(self, **begin: object) -> None:
        rtpus = ("rt0", "rt1", "rt2")
        super().__init__(rtpus)
        self.server: TimedGate = TimedGate()
        self.driver: FaultyDriver = FaultyDriver(rtpus, self.server)
        self.server.clock = self.driver
        self.program = RuntimeProgram(self.server, self.driver, YardLoading(), rtpus)  # type: ignore[arg-type]
        self.driver.watch(self.program)
        self.program.leases = Leases(self.program.authority, self.server.hearing, _LEASE_NS, lambda: self.driver.now)
        self.server.silent = {"me": 0, "other": 0}
        self.shop = PlanBuilder()
        self.shop.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"}, rtpu="rt0")
        self.shop.task("push", PUSH, rtpu="rt1")
        self.shop.task("lamp", LAMP, frequency=50.0, rtpu="rt2")
        self.shop.task("mass2", MASS, module="mass", frequency=500.0, local={"DEVICE": "yard:m1"}, rtpu="rt0")
        self.shop.task("push2", PUSH, module="push", rtpu="rt1")
        self._begin = begin
        self.began_ns = 0

    def prepare(self) -> None:
        """Prepare the application."""
        answer = self.ask(request.Prepare(self.shop.plan([action("mass", "push", "lamp")]), ()))
        if not isinstance(answer, request.Prepared) or answer.faults:
            raise ValueError(str(answer))

    def start(self, by_hand: bool = True) -> "FaultyRuntime":
        """Begin it, have the others turned on by hand, and let both work for a while."""
        self.prepare()
        if self.ask(request.Begin(**self._begin)) != request.Done():  # type: ignore[arg-type]
            raise ValueError("it does not begin")
        if by_hand:
            names = ("mass2", "push2")
            tasks = tuple(self.shop.planned(name) for name in names)
            code = tuple(self.shop.code(name) for name in names)
            turns = tuple(live.Turn(name) for name in names)
            self.ask(live.Change("hand", spawn=tasks, code=code, on=turns), "other")
        self.let_pass(30.0)
        return self

    def let_pass(self, ms: float) -> None:
        """Let virtual time pass, one instant after the other."""
        until = self.driver.now + round(ms * MS)
        self.program.subsystems.when(until, lambda: None)
        while self.driver.now < until and self.program.advance(0):
            pass

    # What is foreseen

    def questions(self) -> list[tuple[str, str]]:
        """Everything that can be asked."""
        return [(one.fault, one.subject) for one in self.foresee()]

    def foresee(self, fault: str = "", subject: str = "", **more: object) -> tuple[Foresight, ...]:
        """What can be asked, or what follows from a fault."""
        answer = self.ask(WhatIf(fault, subject, **more))  # type: ignore[arg-type]
        if not isinstance(answer, Foreseen):
            raise TypeError(str(answer))
        return answer.foresights

    # What happens

    def plant(self, fault: str, subject: str) -> None:
        """Let the fault come, and time pass until everything has followed."""
        self.server.times.clear()
        self.began_ns = self.driver.now
        getattr(self, "_" + fault.replace("-", "_"))(subject)
        self.let_pass(_AFTER_MS)

    def changes(self) -> list[Change]:
        """What has changed since the fault came, as sessions were told."""
        times = [(self._at_ns(at, message), message) for at, message in self.server.times]
        return [change for at, message in times for change in changes_of(message, (at - self.began_ns) / MS)]

    def _at_ns(self, at_ns: int, message: event.Event) -> int:
        """A drive says itself when it changed."""
        return message.at_ns if isinstance(message, event.Drive) else at_ns

    # Plants

    def _sicken(self, task: str, how: str) -> None:
        subsystem, _, name = task.rpartition("/")
        setattr(self.driver.living()[subsystem, name].module, "_sick", how)  # noqa: B010  of the modules above alone

    def _task(self, task: str) -> None:
        self._sicken(task, "raise")

    def _nan(self, variable: str) -> None:
        subsystem, _, name = variable.rpartition("/")
        writers = {"X": "mass", "FORCE": "push", "SEEN": "lamp"}
        self._sicken(f"{subsystem}/{writers[name]}{'2' if subsystem == 'hand' else ''}", "nan")

    def _late(self, _task: str) -> None:
        self.driver.oversleep(25 * MS)

    def _hangs(self, task: str) -> None:
        subsystem, _, name = task.rpartition("/")
        self._unit_frozen(self.driver._units.homes[subsystem, name])

    def _unit_killed(self, unit: str) -> None:
        self.driver.lose(unit)

    def _unit_frozen(self, unit: str) -> None:
        self.driver.freeze(unit)
        self.let_pass(SILENT_NS / MS)
        self.driver.lose(unit)

    def _devices_killed(self, _subject: str) -> None:
        self.driver.lose_worlds()

    def _devices_frozen(self, _subject: str) -> None:
        self.driver.freeze_worlds()
        self.let_pass(SILENT_NS / MS)
        self.driver.lose_worlds()

    def _stop(self, _subject: str) -> None:
        self.ask(request.Stop(Reason.plain("enough")), "anybody")

    def _button(self, device: str) -> None:
        world, part = device.split(":")
        self.ask(live.Touch(world, part, 1.0), "anybody")

    def _drive(self, device: str) -> None:
        self.driver.trip(device)

    def _link(self, session: str) -> None:
        for silent_ns in range(0, _LEASE_NS + _LOOK_NS, _LOOK_NS):
            self.server.silent[session] = silent_ns
            self.program.serve()
            self.let_pass(_LOOK_NS / MS)

    _holder = _environment = _link

    def _browser(self, _subject: str) -> None:
        """A browser says nothing to a runtime, neither while it is there nor when it goes."""

    def _disk(self, _subject: str) -> None:
        writer = self.program.recordings.recorder._writer
        if writer is None:
            raise TypeError("expected a recording, found none")
        writer.reason = Reason.plain("No space left on device")  # type: ignore[misc]
