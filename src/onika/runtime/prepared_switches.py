"""Switches prepared for the finish of a trigger, so that the next job begins without a round trip (law 6)."""

from collections.abc import Iterable

from onika.model.signal import Signal
from onika.runtime.command import Case, PreparedSwitch


class PreparedSwitches:
    """At most one for each subsystem; what was dropped never counts again."""

    def __init__(self) -> None:
        self._held: dict[str, PreparedSwitch] = {}

    def __len__(self) -> int:
        return len(self._held)

    def keep(self, order: PreparedSwitch) -> None:
        """In the place of the one before it; one without cases only forgets that."""
        self._held.pop(order.subsystem, None)
        if order.cases:
            self._held[order.subsystem] = order

    def take(self, subsystem: str, task: str, activation: int, signal: Signal) -> Case | None:
        """What was prepared for this finish, once; None if nothing was, or for other values only."""
        held = self._held.get(subsystem)
        if held is None or (held.task, held.activation) != (task, activation):
            return None
        del self._held[subsystem]
        return next((case for case in held.cases if _fits(case, signal)), None)

    def drop(self, subsystem: str) -> None:
        """Forget what was prepared for a subsystem."""
        self._held.pop(subsystem, None)

    def drop_all(self) -> None:
        """Forget everything."""
        self._held.clear()


def lines(cases: Iterable[Case]) -> dict[str, list[str]]:
    """The argument lines with which tasks may come on by these cases."""
    epochs: dict[str, list[str]] = {}
    for case in cases:
        for launch in case.switch.on:
            epochs.setdefault(launch.task, []).append(launch.arguments)
    return epochs


def _fits(case: Case, signal: Signal) -> bool:
    return case.choice in (None, signal.flow) and case.loop in (None, signal.loop)
