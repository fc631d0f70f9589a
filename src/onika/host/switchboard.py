"""The switchboard: splits a switch by RTPU and keeps its order across them (laws 3 and 6)."""

from collections import deque
from collections.abc import Iterable, Mapping

from onika.engine import orders
from onika.host.units import Units
from onika.model.lifecycle import State
from onika.runtime import command
from onika.runtime.subsystem import Subsystem


class Switchboard:
    """Tasks come on in the order they are given; a group on one RTPU goes out when the group before it is ON."""

    def __init__(self, subsystems: Mapping[int, Subsystem], units: Units) -> None:
        self._subsystems = subsystems
        self._units = units
        self._waiting: dict[int, deque[tuple[str, command.Switch]]] = {}
        self._awaited: dict[int, set[str]] = {}
        self._activations: dict[tuple[int, str], int] = {}
        self._launched = 0

    def put(self, order: orders.Switch, forget: tuple[str, ...]) -> None:
        """A switch of a flow; it begins at once, or when the one before it is through."""
        self._waiting.setdefault(order.flow, deque()).extend(self._groups(order, forget))
        if not self._awaited.get(order.flow):
            self._next(order.flow)

    def settled(self, flow: int, task: str) -> None:
        """A task that was to come on is ON, asks, has failed or was refused."""
        awaited = self._awaited.get(flow)
        if awaited and task in awaited:
            awaited.discard(task)
            if not awaited:
                self._next(flow)

    def is_late(self, flow: int, task: str, activation: int) -> bool:
        """Whether a word is about an earlier activation than the last one that was sent out."""
        return 0 < activation < self._activations.get((flow, task), 0)

    def drop(self, flow: int) -> None:
        """Nothing more comes on in this flow."""
        self._waiting.pop(flow, None)
        self._awaited.pop(flow, None)

    def _next(self, flow: int) -> None:
        groups = self._waiting.get(flow)
        while groups:
            rtpu, switch = groups.popleft()
            members = self._subsystems[flow].members
            self._awaited[flow] = {one.task for one in switch.on if members[one.task].state is not State.KILLED}
            for launch in switch.on:
                self._activations[flow, launch.task] = launch.activation
            self._units.send(rtpu, switch)
            if self._awaited.get(flow):
                return

    def _groups(self, order: orders.Switch, forget: tuple[str, ...]) -> Iterable[tuple[str, command.Switch]]:
        subsystem = self._subsystems[order.flow]
        home = {name: member.rtpu for name, member in subsystem.members.items()}
        groups: list[tuple[str, command.Switch]] = []
        for rtpu in sorted({home[name] for name in (*order.off, *(name for name, _ in order.kept_rates))}):
            off = tuple(name for name in order.off if home[name] == rtpu)
            rates = tuple((name, hz) for name, hz in order.kept_rates if home[name] == rtpu)
            groups.append((rtpu, command.Switch(subsystem.name, off, forget, (), rates)))
        for start in order.on:
            self._launched += 1
            launch = command.Launch(start.task, start.arguments, start.frequency, self._launched)
            rtpu = home[start.task]
            if groups and groups[-1][0] == rtpu:
                groups[-1] = (rtpu, _with(groups[-1][1], launch))
            else:
                groups.append((rtpu, command.Switch(subsystem.name, (), () if groups else forget, (launch,))))
        return groups


def _with(switch: command.Switch, launch: command.Launch) -> command.Switch:
    return command.Switch(switch.subsystem, switch.off, switch.forget, (*switch.on, launch), switch.rates)
