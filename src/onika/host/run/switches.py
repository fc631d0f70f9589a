"""The switches of a run go out alone, or with those that begin at the same instant (law 9)."""

from collections.abc import Mapping, Sequence

from onika.engine import orders
from onika.host.execution.subsystem_executor import SubsystemExecutor
from onika.host.run.prepared_switch import PreparedSwitches
from onika.host.units.unit_registry import Units
from onika.runtime import command


class Switches:
    """Serves all flows of one run."""

    def __init__(self, executors: Mapping[int, SubsystemExecutor], prepared: PreparedSwitches, units: Units) -> None:
        self._executors = executors
        self._prepared = prepared
        self._units = units
        self._together: list[orders.Switch] = []
        self._left = 0

    def together(self, count: int) -> None:
        """The next switches, so many, are one."""
        self._left = count

    def switch(self, switch: orders.Switch) -> None:
        """Send it out as soon as all are there that belong to it; what a unit has done by itself is not done again."""
        if switch.number:
            rest = self._prepared.switched(switch)
            if rest is None:
                return
            switch = rest
        self._together.append(switch)
        self._left = max(self._left - 1, 0)
        if not self._left:
            together, self._together = self._together, []
            self._put(together)

    def _put(self, switches: Sequence[orders.Switch]) -> None:
        for switch in switches:
            self._prepared.finished(switch.flow)
        admitted = [switch for switch in switches if self._executors[switch.flow].admits(switch)]
        if len(admitted) > 1:
            self._put_together(admitted)
        else:
            for switch in admitted:
                self._executors[switch.flow].switch(switch)

    def _put_together(self, switches: Sequence[orders.Switch]) -> None:
        """Switches of several flows begin at one instant, as far as each is on one unit and can begin now."""
        by_unit: dict[str, list[command.Switch]] = {}
        for switch in switches:
            group = self._executors[switch.flow].launch_alone(switch)
            if group is not None:
                rtpu, whole = group
                by_unit.setdefault(rtpu, []).append(whole)
        for rtpu, wholes in by_unit.items():
            self._units.send(rtpu, command.Together(tuple(wholes)))
