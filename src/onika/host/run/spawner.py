"""Births: the tasks of a run come to life in the order of their constants, with the devices they claim (law 10)."""

from collections.abc import Callable, Mapping

from onika.host.units.unit_registry import Units
from onika.runtime import command
from onika.runtime.subsystem import Member, RunningSubsystem
from onika.wire.plan import Code


class Births:
    """`refuse` is told of a task that cannot be born: flow, task and why."""

    def __init__(
        self,
        subsystems: Mapping[int, RunningSubsystem],
        code: Mapping[str, Code],
        units: Units,
        seed: int,
        refuse: Callable[[int, str, str], None],
    ) -> None:
        self._subsystems = subsystems
        self._code = code
        self._units = units
        self._seed = seed
        self._refuse = refuse
        self._waiting: list[tuple[int, str]] = []
        self._claims: list[str] = []

    def expect(self, flow: int, task: str) -> None:
        """This one is to be born as soon as it can be."""
        self._waiting.append((flow, task))

    def forget(self, flow: int, task: str) -> None:
        """This one is not to be born any more."""
        if (flow, task) in self._waiting:
            self._waiting.remove((flow, task))

    def go_on(self) -> None:
        """Spawn, in order, every task whose constants are there; the others wait for their suppliers."""
        for flow, task in list(self._waiting):
            subsystem = self._subsystems[flow]
            if (flow, task) in self._waiting and subsystem.is_ready(task):
                self._waiting.remove((flow, task))
                self._spawn(flow, task)

    def release(self, member: Member) -> None:
        """A task is gone: give its device back."""
        device = member.wired.device
        if device in self._claims:
            self._claims.remove(device)
            self._units.release(device)

    def _spawn(self, flow: int, task: str) -> None:
        subsystem = self._subsystems[flow]
        member = subsystem.members[task]
        code = self._code[member.wired.task.digest]
        try:
            device = self._claim(member)
            order = subsystem.spawn(task, code.source, code.path, self._seed, device)
            self._units.send(member.rtpu, order)
        except (KeyError, ValueError) as wrong:
            self._refuse(flow, task, str(wrong))
            return
        member.is_sent = True

    def _claim(self, member: Member) -> command.DeviceGrant | None:
        device = member.wired.device
        if device is None:
            return None
        grant = self._units.grant(member.rtpu, device)
        if grant.command_offset is not None:
            self._claims.append(device)
        return grant
