"""Switch dispatch: a switch is split by unit, and its order is kept across units (laws 3 and 6)."""

from collections import deque
from collections.abc import Iterator, Mapping, Sequence

from msgspec import structs

from onika.engine import orders
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem

Group = tuple[str, command.Switch]
"""A unit, and the part of a switch that it carries out at one instant."""


class SwitchDispatch:
    """Serves one subsystem. Tasks come on in the order they are given; a group waits until the one before it is ON.

    `activations` numbers every launch, so that old news can be told from new (decision 4).
    """

    def __init__(self, subsystem: RunningSubsystem, units: Units, activations: Iterator[int]) -> None:
        self._subsystem = subsystem
        self._only_unit = _only_unit(subsystem)
        self._units = units
        self._activations = activations
        self._waiting: deque[Group] = deque()
        self._awaited: set[str] = set()
        self._launched: dict[str, int] = {}

    # Switches

    def put(self, switch: orders.Switch, forget: tuple[str, ...]) -> None:
        """Send a switch out at once, or when the one before it is through."""
        self._waiting.extend(self._groups(switch, forget))
        if not self._awaited:
            self._send_next()

    def launch_alone(self, switch: orders.Switch, forget: tuple[str, ...]) -> Group | None:
        """The switch as one command that the caller sends; None where it takes several or has to wait: it is put."""
        groups = self._groups(switch, forget)
        if len(groups) != 1 or self._awaited or self._waiting:
            self.put(switch, forget)
            return None
        self._launch(groups[0][1])
        return groups[0]

    def appoint(self, switch: orders.Switch, forget: tuple[str, ...]) -> Group | None:
        """The switch as one command that a unit carries out later; None where it takes several or has to wait."""
        groups = self._groups(switch, forget)
        is_free = not (self._awaited or self._waiting)
        return groups[0] if is_free and len(groups) == 1 else None

    def turn_off(self, task: str) -> None:
        """Turn a task off outside a switch; where it was still to come on, it does not any more."""
        for place, (rtpu, switch) in enumerate(self._waiting):
            others = tuple(launch for launch in switch.on if launch.task != task)
            self._waiting[place] = (rtpu, structs.replace(switch, on=others))
        rtpu = self._subsystem.members[task].rtpu
        self._units.send(rtpu, command.Switch(self._subsystem.name, (task,), (), ()))

    def drop(self) -> None:
        """Nothing more comes on."""
        self._waiting.clear()
        self._awaited.clear()

    def replace(self, subsystem: RunningSubsystem) -> None:
        """From now on these are the tasks; what was still to come on does not."""
        self._subsystem = subsystem
        self._only_unit = _only_unit(subsystem)
        self.drop()

    # Prepared switches

    def prepare(self, task: str, cases: Sequence[tuple[orders.Case, tuple[str, ...]]]) -> Mapping[int, command.Switch]:
        """Have the switches ready for the finish of a task, each by its number; none where they are not on one unit."""
        members = self._subsystem.members
        if not self._only_unit:
            return {}
        ready: list[command.Case] = []
        for case, forget in cases:
            groups = self._groups(case.switch, forget)
            switch = groups[0][1] if groups else command.Switch(self._subsystem.name, (), forget, ())
            ready.append(command.Case(case.choice, case.loop, len(ready) + 1, switch))
        activation = self._launched.get(task, 0)
        self._units.send(
            members[task].rtpu, command.PreparedSwitch(self._subsystem.name, task, activation, tuple(ready))
        )
        return {case.number: case.switch for case in ready}

    def unprepare(self, task: str) -> None:
        """Nothing is to follow by itself any more; the unit says when that is so."""
        rtpu = self._subsystem.members[task].rtpu
        self._units.send(rtpu, command.PreparedSwitch(self._subsystem.name, task, 0, ()))

    def adopt(self, switch: command.Switch) -> None:
        """Note the activations of a switch that a unit carries out."""
        for launch in switch.on:
            self._launched[launch.task] = launch.activation

    # News

    def is_late(self, message: news.TaskNews) -> bool:
        """Whether news is about an earlier activation than the last one; an error and an end are never late."""
        if not 0 < getattr(message, "activation", 0) < self._launched.get(message.task, 0):
            return False
        return not (isinstance(message, news.Failed) or _is_end(message))

    def settled(self, task: str) -> None:
        """A task that was to come on is ON, asks, has failed, was refused or is gone."""
        if task in self._awaited:
            self._awaited.discard(task)
            if not self._awaited:
                self._send_next()

    def _send_next(self) -> None:
        while self._waiting:
            rtpu, switch = self._waiting.popleft()
            self._launch(switch)
            self._units.send(rtpu, switch)
            if self._awaited:
                return

    def _launch(self, switch: command.Switch) -> None:
        members = self._subsystem.members
        self._awaited = {launch.task for launch in switch.on if members[launch.task].state is not State.KILLED}
        self.adopt(switch)

    def _groups(self, switch: orders.Switch, forget: tuple[str, ...]) -> list[Group]:
        """Everything that goes off or changes its rate, unit by unit, then neighbours that come on, as one group."""
        launches = [
            command.Launch(start.task, start.arguments, start.frequency, next(self._activations)) for start in switch.on
        ]
        if not self._only_unit:
            return self._by_unit(switch, forget, launches)
        if switch.off or launches or switch.kept_rates:
            name = self._subsystem.name
            return [(self._only_unit, command.Switch(name, switch.off, forget, tuple(launches), switch.kept_rates))]
        return []

    def _by_unit(
        self, switch: orders.Switch, forget: tuple[str, ...], launches: Sequence[command.Launch]
    ) -> list[Group]:
        name, members = self._subsystem.name, self._subsystem.members
        changed = [*switch.off, *(task for task, _ in switch.kept_rates)]
        groups: list[Group] = []
        for rtpu in sorted({members[task].rtpu for task in changed}):
            off = tuple(task for task in switch.off if members[task].rtpu == rtpu)
            rates = tuple((task, hz) for task, hz in switch.kept_rates if members[task].rtpu == rtpu)
            groups.append((rtpu, command.Switch(name, off, forget, (), rates)))
        for launch in launches:
            rtpu = members[launch.task].rtpu
            if groups and groups[-1][0] == rtpu:
                last = groups[-1][1]
                groups[-1] = (rtpu, structs.replace(last, on=(*last.on, launch)))
            else:
                groups.append((rtpu, command.Switch(name, (), () if groups else forget, (launch,))))
        return groups


def _only_unit(subsystem: RunningSubsystem) -> str:
    """The unit on which all its tasks are; empty where there are several, or none."""
    units = {member.rtpu for member in subsystem.members.values()}
    return units.pop() if len(units) == 1 else ""


def _is_end(message: news.TaskNews) -> bool:
    return isinstance(message, news.Changed) and message.state == State.KILLED.value
