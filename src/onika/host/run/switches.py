"""The switching of a run: switches of the engine go out, alone or with those that begin at the same instant (law 9)."""

from collections.abc import Callable, Mapping, Sequence

from onika.engine import orders
from onika.host.run.prepared_switch import Outlook
from onika.host.run.switch_dispatch import Switchboard
from onika.runtime.subsystem import RunningSubsystem

Refuse = Callable[[int, str, str], None]
"""Told the flow, the task and why it does not come on."""


class Switching:
    """Of all flows of one run."""

    def __init__(
        self, subsystems: Mapping[int, RunningSubsystem], outlook: Outlook, switchboard: Switchboard, refuse: Refuse
    ) -> None:
        self._subsystems = subsystems
        self._outlook = outlook
        self._switchboard = switchboard
        self._refuse = refuse
        self._together: list[orders.Switch] = []
        self._left = 0

    def together(self, count: int) -> None:
        """The next switches, so many, are one."""
        self._left = count

    def switch(self, order: orders.Switch) -> None:
        """Send it out as soon as all are there that belong to it; what a unit has done by itself is not done again."""
        if order.number:
            rest = self._outlook.switched(order.flow, order)
            if rest is None:
                return
            order = rest
        self._together.append(order)
        self._left = max(self._left - 1, 0)
        if not self._left:
            together, self._together = self._together, []
            self._put(together)

    def _put(self, switches: Sequence[orders.Switch]) -> None:
        """Unless it would give a variable a second writer."""
        ready = []
        for order in switches:
            subsystem = self._subsystems[order.flow]
            on = [start.task for start in order.on]
            self._outlook.finished(order.flow)
            clashes = subsystem.clashes(order.off, on)
            if clashes:
                self._refuse(order.flow, *clashes[0])
                continue
            forget = subsystem.forgotten(order.off, on)
            subsystem.forget(forget)
            ready.append((order, forget))
        if len(ready) > 1:
            self._switchboard.put_together(ready)
        else:
            for order, forget in ready:
                self._switchboard.put(order, forget)
