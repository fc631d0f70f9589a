"""The spawner sends tasks to their units, each with its code and the device it claims (laws 10, 16)."""

from collections.abc import Collection, Mapping

from msgspec import structs

from onika.host.execution.reshape import Reshaping
from onika.host.units.unit_registry import Units
from onika.runtime import command
from onika.runtime.subsystem import Member, RunningSubsystem
from onika.runtime.wiring import WiredTask
from onika.wire.plan import Code
from onika.words.reason import NOTHING, Reason, reason_of

_SANDBOXED_NS = 500_000
"""What it takes a unit to make the class of a task whose module is loaded in a sandbox: half of it for twelve ports."""


class Spawner:
    """Serves one subsystem: it has the code of modules by digest, and the device that each task was granted.

    `lost` are the units that are gone, each with the reason. With `reshaping`, variables whose shapes have changed
    get new entries before a task is bound to them.
    """

    def __init__(
        self, units: Units, lost: Mapping[str, Reason], seed: int = 0, reshaping: Reshaping | None = None
    ) -> None:
        self._units = units
        self._lost = lost
        self._seed = seed
        self._reshaping = reshaping
        self._code: dict[str, Code] = {}
        self._load_ns: dict[str, int] = {}
        self._grants: dict[str, command.DeviceGrant] = {}
        self._claims: dict[str, str] = {}
        self._hurried: set[str] = set()

    @property
    def claims(self) -> dict[str, str]:
        """The devices that tasks have for themselves alone, as `WORLD:NAME`, by task."""
        return dict(self._claims)

    # Code

    def add_code(self, code: Code, load_ns: int = 0) -> None:
        """Keep the code of a module with which tasks may be spawned; loading it takes so long."""
        self._code[code.digest] = code
        self._load_ns[code.digest] = load_ns

    def code(self, digest: str) -> Code:
        """The code with this digest; raises KeyError where there is none."""
        return self._code[digest]

    def drop_unused_code(self, tasks: Collection[WiredTask]) -> None:
        """Keep the code of these tasks' modules only."""
        used = {wired.task.digest for wired in tasks}
        for digest in self._code.keys() - used:
            del self._code[digest], self._load_ns[digest]

    # Tasks

    def spawn(self, subsystem: RunningSubsystem, task: str) -> Reason:
        """Send a task to its unit with its device; why that cannot be, empty if it is done."""
        member = subsystem.members[task]
        device = member.wired.device
        try:
            if member.rtpu in self._lost:
                raise ValueError(self._lost[member.rtpu])
            if device is not None:
                grant = self._grants[task] = self._units.grant(member.rtpu, device)
                if grant.command_offset is not None:
                    self._claims[task] = device
            self._units.send(member.rtpu, self.order(subsystem, task))
        except (KeyError, ValueError) as error:
            self.release(task, member)
            return shape_fault(error)
        return NOTHING

    def hurry(self, task: str) -> None:
        """The next time this task is sent, it waits for no gap between cycles."""
        self._hurried.add(task)

    def order(self, subsystem: RunningSubsystem, task: str) -> command.Spawn:
        """The command that brings a task to life, or exchanges the code of one that lives.

        Raises KeyError where a constant is missing, ValueError for shapes that cannot be.
        """
        code = self._code[subsystem.members[task].wired.task.digest]
        if self._reshaping is not None:
            self._reshaping.ports(subsystem, task)
        grant = self._grants.get(task)
        load_ns = _SANDBOXED_NS if code.is_sandboxed else self._load_ns[code.digest]
        order = subsystem.spawn(task, code.source, code.path, self._seed, grant, load_ns)
        if code.is_sandboxed:
            order = structs.replace(order, sandboxed_as=subsystem.members[task].wired.sheet)
        if task not in self._hurried:
            return order
        self._hurried.discard(task)
        return structs.replace(order, cost_ns=0)

    def release(self, task: str, member: Member) -> None:
        """Give back the device that a task was granted for itself alone, or a camera; harmless where it has none."""
        grant, device = self._grants.pop(task, None), member.wired.device
        self._claims.pop(task, None)
        is_counted = grant is not None and (grant.command_offset is not None or bool(grant.picture))
        if is_counted and device is not None:
            self._units.release(device)


def shape_fault(error: KeyError | ValueError) -> Reason:
    """What stands in the way of a task's shapes, in words."""
    if isinstance(error, KeyError):
        return Reason.of("host.constant_without_value", constant=str(error.args[0]))
    return reason_of(error)
