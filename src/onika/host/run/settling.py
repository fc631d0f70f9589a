"""How a run settles: a while after its last action, then every unit tells the figures of its tasks (E03, E14)."""

from collections.abc import Mapping

from onika.host.units.unit_registry import Units
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem


class Settling:
    """From the last action to the moment at which everything is known."""

    def __init__(self, lasts_s: float, subsystems: Mapping[int, RunningSubsystem], units: Units) -> None:
        self._lasts_ns = round(lasts_s * 1e9)
        self._subsystems = subsystems
        self._units = units
        self._until: int | None = None
        self._open: set[str] = set()

    def begin(self, now: int) -> None:
        """The last action is done."""
        self._until = now + self._lasts_ns

    def give_up(self) -> None:
        """The run ends otherwise; what is still told says nothing any more."""
        self._until = None
        self._open.clear()

    def wake_at(self) -> int | None:
        """When it is over; None while nothing settles."""
        return self._until

    def is_due(self, now: int) -> bool:
        """Whether it has settled for as long as it was to."""
        return self._until is not None and now >= self._until

    def ask(self) -> bool:
        """Ask every unit for the figures of its tasks; False where a run has no task, so that none will tell any."""
        self._until = None
        self._open = {member.rtpu for subsystem in self._subsystems.values() for member in subsystem.members.values()}
        for rtpu in sorted(self._open):
            self._units.send(rtpu, command.Report())
        return bool(self._open)

    def reported(self, rtpu: str) -> bool:
        """A unit has told them; whether it was the last one that was missing."""
        was_open = rtpu in self._open
        self._open.discard(rtpu)
        return was_open and not self._open

    def lost(self, rtpu: str) -> None:
        """That unit tells nothing any more."""
        self._open.discard(rtpu)
