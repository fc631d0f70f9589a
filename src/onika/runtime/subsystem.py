"""A running subsystem: the tasks that share one table, who is ON, who may be spawned next (law 3)."""

from collections.abc import Collection, Iterable, Mapping

from onika.model.lifecycle import State
from onika.model.rules.order import rank
from onika.model.rules.starvation import starved
from onika.runtime.command import BoundPort, DeviceGrant, Spawn
from onika.runtime.table import Table
from onika.runtime.wiring import WiredTask, upstream
from onika.words.reason import Reason

_BIRTH_NS = 800_000
"""What it takes to make an instance and bind its ports, generously."""
_INIT_NS = 400_000
"""What an ordinary `init` takes; law 21 lets nothing come in that does not fit between two cycles."""


_WRITING = (State.ON, State.ASKING)


class Member:
    """A task of a subsystem as its runner knows it."""

    __slots__ = ("is_sent", "rtpu", "state", "wired")

    def __init__(self, wired: WiredTask, rtpu: str) -> None:
        self.wired = wired
        self.rtpu = rtpu
        self.state = State.WAITING
        self.is_sent = False


class RunningSubsystem:
    """Owned by the runner; tasks themselves live on RTPUs.

    `constants` are what robot modules state before they live: a supplier's own shapes may depend on them.
    """

    def __init__(
        self,
        name: str,
        table: Table,
        tasks: Iterable[WiredTask],
        rtpus: Mapping[str, str],
        constants: Mapping[str, int] | None = None,
    ) -> None:
        self.name = name
        self._constants = dict(constants or {})
        self.table = table
        self.members = {wired.name: Member(wired, rtpus[wired.name]) for wired in tasks}
        wired_tasks = [member.wired for member in self.members.values()]
        self._readers = _by_variable((member, member.wired.invar) for member in self.members.values())
        self._writers = _by_variable((member, member.wired.outvar) for member in self.members.values())
        self._suppliers = {svar: member for member in self.members.values() for svar in member.wired.outconst}
        self._written_before = {svar for svar in self._suppliers if self._is_written(svar)}
        hardware = [wired.name for wired in wired_tasks if wired.sheet.hardware]
        self._fed = {wired.name: upstream(wired_tasks, wired.invar) for wired in wired_tasks if wired.sheet.hardware}
        self.ranks = rank([wired.meeting for wired in wired_tasks], hardware)

    def lacking(self, task: str) -> list[str]:
        """The constants that a task waits for: those it reads at initialisation, and those its shapes depend on."""
        wired = self.members[task].wired
        return [svar for svar in wired.placed.ports.inconst if self._is_lacking(svar, wired)]

    def _is_lacking(self, svar: str, wired: WiredTask) -> bool:
        """Whether nobody supplies it, or its supplier has not written it since it is here."""
        is_dimension = svar not in wired.inconst
        if is_dimension and svar in self._constants:
            return False
        supplier = self._suppliers.get(svar)
        if supplier is None:
            return svar not in wired.first_values
        if supplier.wired is wired:
            return False
        is_outdated = supplier.state is State.WAITING and svar in self._written_before
        return is_outdated or not self._is_written(svar)

    def spawn(
        self, task: str, source: str, path: str, seed: int, device: DeviceGrant | None, load_ns: int = 0
    ) -> Spawn:
        """The command that brings a task to life; its entries are made in the table.

        Raises ValueError where a variable's shape does not agree with the table, KeyError for a missing constant.
        """
        wired = self.members[task].wired
        planned = wired.task
        names = {name for port in wired.ports for name in port.shape.names}
        constants = {name: self.dimension(name) for name in sorted(names)}
        ports = []
        for port in wired.ports:
            entry = self.table.entry(port.svar, port.shape.resolve(constants))
            ports.append(BoundPort(port.port, port.svar, str(entry.shape), entry.offset))
        return Spawn(
            subsystem=self.name,
            task=task,
            module=planned.module,
            path=path,
            source=source,
            task_type=planned.type,
            frequency=planned.frequency,
            local=planned.local,
            ports=tuple(ports),
            rank=self.ranks[task],
            seed=seed,
            device=device,
            cost_ns=load_ns + _BIRTH_NS + _INIT_NS,
            init_ns=_INIT_NS,
        )

    def forgotten(self, off: Collection[str], on: Collection[str], finished: str = "") -> tuple[str, ...]:
        """What steers nothing at this switch: variables whose last reader goes, those whose first reader comes, for
        nobody has followed them, and whatever a hardware task that comes on is fed from, because it has been holding
        meanwhile. Who has `finished` is off by then."""
        gone_off = {finished, *off}
        turned = {svar for name in (*off, *on) for svar in self.members[name].wired.invar}
        gone = {svar for svar in turned if not self._is_still_read(svar, gone_off)}
        fed = [self._fed[name] for name in on if name in self._fed]
        return tuple(sorted(gone.union(*fed)))

    def _is_still_read(self, svar: str, gone_off: Collection[str]) -> bool:
        """Whether somebody who is ON, and stays it, reads a variable."""
        for member in self._readers.get(svar, ()):  # asked at every switch: no generator
            if member.state is State.ON and member.wired.name not in gone_off:
                return True
        return False

    def starved(self, task: str) -> dict[str, str]:
        """The hardware that this task fed, through tasks that are ON, and the variable of the task (law 4)."""
        return self.fed(task, [name for name, member in self.members.items() if member.state is State.ON])

    def fed(self, task: str, through: Collection[str]) -> dict[str, str]:
        """The hardware among these tasks that a task feeds through them, and the variable of the task (law 4)."""
        hardware = [name for name in through if self.is_hardware(name)]
        working = [self.members[name].wired.meeting for name in through]
        return starved(self.members[task].wired.meeting, working, hardware)

    def is_hardware(self, task: str) -> bool:
        """Whether a task commands a device."""
        return self.members[task].wired.sheet.hardware

    def forget(self, names: Iterable[str]) -> None:
        """These steer nothing any more; an RTPU does the same once its tasks are off, as they may write till then."""
        for name in names:
            if name in self.table.entries:
                self.table.ring(name).forget()

    def clashes(self, off: Collection[str], on: Collection[str]) -> list[tuple[str, Reason]]:
        """Who would come on as a second writer of a variable, and why that is refused (law 9)."""
        clashes = []
        coming: dict[str, str] = {}
        for name in dict.fromkeys(on):
            for svar in self.members[name].wired.outvar:
                writer = self._writer(svar, off, on)
                other = coming.setdefault(svar, name) if writer is None else writer.wired.name
                if other != name:
                    clashes.append((name, _second_writer(svar, other, "" if writer is None else writer.state.value)))
        return clashes

    def _writer(self, svar: str, off: Collection[str], on: Collection[str]) -> Member | None:
        """Who writes a variable and is not touched by a switch; of several the last."""
        for member in reversed(self._writers[svar]):
            if member.state in _WRITING and member.wired.name not in off and member.wired.name not in on:
                return member
        return None

    def dimension(self, name: str) -> int:
        """A constant that shapes depend on: as its supplier states it before it lives, else as written."""
        if name in self._constants:
            return int(self._constants[name])
        if not self._is_written(name):
            raise KeyError(name)
        return int(self.table.value(name))

    def _is_written(self, svar: str) -> bool:
        return svar in self.table.entries and self.table.ring(svar).count > 0


def _by_variable(flows: Iterable[tuple[Member, Iterable[str]]]) -> dict[str, list[Member]]:
    """Who has to do with each variable, in the order of the tasks."""
    members: dict[str, list[Member]] = {}
    for member, names in flows:
        for svar in names:
            members.setdefault(svar, []).append(member)
    return members


def _second_writer(svar: str, other: str, state: str) -> Reason:
    """Why a task may not come on; `state` is that of the task which writes already, empty: it comes on too."""
    if state:
        return Reason.of("runtime.written_by", svar=svar, task=other, state=state)
    return Reason.of("runtime.written_too", svar=svar, task=other)
