"""The switchboard: splits a switch by RTPU and keeps its order across them (laws 3 and 6)."""

from collections import deque
from collections.abc import Iterable, Mapping, Sequence

from msgspec import structs

from onika.engine import orders
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem


class Switchboard:
    """Tasks come on in the order they are given; a group on one RTPU goes out when the group before it is ON."""

    def __init__(self, subsystems: Mapping[int, RunningSubsystem], units: Units) -> None:
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

    def put_together(self, switches: Sequence[tuple[orders.Switch, tuple[str, ...]]]) -> None:
        """Switches of several flows that begin at the same instant, as far as each is on one unit and can begin now."""
        whole: dict[str, list[command.Switch]] = {}
        for order, forget in switches:
            groups = list(self._groups(order, forget))
            if len(groups) != 1 or self._awaited.get(order.flow) or self._waiting.get(order.flow):
                self.put(order, forget)
                continue
            rtpu, switch = groups[0]
            self._launch(order.flow, switch)
            whole.setdefault(rtpu, []).append(switch)
        for rtpu, several in whole.items():
            self._units.send(rtpu, command.Together(tuple(several)))

    def prepare(
        self, flow: int, task: str, cases: Sequence[tuple[orders.Case, tuple[str, ...]]]
    ) -> Mapping[int, command.Switch]:
        """Have the switches ready for the finish of a task, each by its number; none where they are not on one unit."""
        subsystem = self._subsystems[flow]
        if len({member.rtpu for member in subsystem.members.values()}) != 1:
            return {}
        ready: list[command.Case] = []
        for case, forget in cases:
            groups = list(self._groups(case.switch, forget))
            nothing = command.Switch(subsystem.name, (), forget, ())
            ready.append(command.Case(case.choice, case.loop, len(ready) + 1, groups[0][1] if groups else nothing))
        rtpu = subsystem.members[task].rtpu
        activation = self._activations.get((flow, task), 0)
        self._units.send(rtpu, command.PreparedSwitch(subsystem.name, task, activation, tuple(ready)))
        return {one.number: one.switch for one in ready}

    def unprepare(self, flow: int, task: str) -> None:
        """Nothing is to follow by itself any more; the unit says when that is so."""
        subsystem = self._subsystems[flow]
        self._units.send(subsystem.members[task].rtpu, command.PreparedSwitch(subsystem.name, task, 0, ()))

    def adopt(self, flow: int, switch: command.Switch) -> None:
        """A prepared switch was carried out by its unit."""
        for launch in switch.on:
            self._activations[flow, launch.task] = launch.activation

    def turn_off(self, flow: int, task: str) -> None:
        """A task goes off outside a switch; where it was still to come on, it does not any more."""
        waiting = self._waiting.get(flow, deque())
        for place, (rtpu, switch) in enumerate(waiting):
            waiting[place] = (rtpu, structs.replace(switch, on=tuple(one for one in switch.on if one.task != task)))
        subsystem = self._subsystems[flow]
        self._units.send(subsystem.members[task].rtpu, command.Switch(subsystem.name, (task,), (), ()))

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
            self._launch(flow, switch)
            self._units.send(rtpu, switch)
            if self._awaited.get(flow):
                return

    def _launch(self, flow: int, switch: command.Switch) -> None:
        members = self._subsystems[flow].members
        self._awaited[flow] = {one.task for one in switch.on if members[one.task].state is not State.KILLED}
        self.adopt(flow, switch)

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
