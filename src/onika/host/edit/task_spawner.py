"""The cradle: what a task of a live subsystem needs to come to life, its code and the device it is granted."""

from collections.abc import Collection, Mapping

from onika.host.edit.reshape import Reshaping
from onika.host.units.unit_registry import Units
from onika.runtime import command
from onika.runtime.subsystem import Member, RunningSubsystem
from onika.runtime.wiring import WiredTask
from onika.wire.plan import Code


class Cradle:
    """Knows modules by their digests, and who has which device."""

    def __init__(self, units: Units, reshaping: Reshaping, lost: Mapping[str, str]) -> None:
        self.code: dict[str, Code] = {}
        self._costs: dict[str, int] = {}
        self._grants: dict[str, command.DeviceGrant] = {}
        self._units = units
        self._reshaping = reshaping
        self._lost = lost

    def know(self, code: Code, cost_ns: int) -> None:
        """A module that somebody may be born with; loading it takes so long."""
        self.code[code.digest] = code
        self._costs[code.digest] = cost_ns

    def forget(self, tasks: Collection[WiredTask]) -> None:
        """Know no more than the modules of these tasks."""
        used = {one.task.digest for one in tasks}
        self.code = {digest: code for digest, code in self.code.items() if digest in used}
        self._costs = {digest: cost for digest, cost in self._costs.items() if digest in used}

    def bear(self, subsystem: RunningSubsystem, name: str) -> str:
        """Send a task to its unit, with its device; why that cannot be, empty if it is done."""
        member = subsystem.members[name]
        device = member.wired.device
        try:
            if member.rtpu in self._lost:
                raise ValueError(self._lost[member.rtpu])
            if device is not None:
                self._grants[name] = self._units.grant(member.rtpu, device)
            self._units.send(member.rtpu, self.order(subsystem, name))
        except (KeyError, ValueError) as wrong:
            self.release(name, member)
            return f"spawn: {plainly(wrong)}"
        return ""

    def order(self, subsystem: RunningSubsystem, name: str) -> command.Spawn:
        """The command that brings a task to life, or exchanges the code of one that lives.

        Raises KeyError where a constant is missing, ValueError for shapes that cannot be.
        """
        code = self.code[subsystem.members[name].wired.task.digest]
        self._reshaping.ports(subsystem, name)
        grant, cost_ns = self._grants.get(name), self._costs.get(code.digest, 0)
        return subsystem.spawn(name, code.source, code.path, 0, grant, cost_ns)

    def release(self, name: str, member: Member) -> None:
        """Give back the device that a task was granted for itself alone."""
        grant, device = self._grants.pop(name, None), member.wired.device
        if grant is not None and grant.command_offset is not None and device is not None:
            self._units.release(device)


def plainly(wrong: KeyError | ValueError) -> str:
    """What stands in the way of a shape, in words."""
    return f"the constant {wrong.args[0]} has no value" if isinstance(wrong, KeyError) else str(wrong)
