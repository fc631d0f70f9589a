"""A pending wait of a script: it ends when its condition has come, or is given up (requirement E07)."""

from typing import Protocol

from onika.desk.run.flow_tracker import FlowTracker
from onika.desk.run.steering import SteeringWait
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

_EPSILON_S = 1e-9


class AwaitedRun(Protocol):
    """The run that is waited for."""

    flow_tracker: FlowTracker

    @property
    def now_s(self) -> float:
        """Its time."""
        ...

    @property
    def is_over(self) -> bool:
        """Whether it has ended."""
        ...

    def is_stuck(self) -> bool:
        """Whether nothing goes on by itself."""
        ...


class PendingWait:
    """A wait under way: whether its condition has come, or is given up."""

    def __init__(self, running: AwaitedRun, act: SteeringWait) -> None:
        self._running = running
        self._act = act
        self._is_time = act.condition.kind == "seconds"
        self.until_s = running.now_s + (act.condition.seconds if self._is_time else act.within_s)
        self._has_come = False
        self._why = NOTHING

    @property
    def is_over(self) -> bool:
        """Whether there is nothing more to wait for."""
        if self._has_come or self._why:
            return True
        running = self._running
        is_late = running.now_s >= self.until_s - _EPSILON_S
        self._has_come = is_late if self._is_time else running.flow_tracker.has_come(self._act.condition)
        if self._has_come:
            return True
        if running.is_over:
            self._why = Reason.of("desk.end_before")
        elif is_late:
            self._why = Reason.of("desk.not_so_within", seconds=self._act.within_s)
        elif not self._is_time and running.is_stuck():
            self._why = Reason.of("desk.nothing_goes_on", flows=running.flow_tracker.standing())
        return bool(self._why)

    def faults(self, place: Place) -> tuple[Fault, ...]:
        """Why it was in vain; empty where the condition has come."""
        if not self._why:
            return ()
        reason = Reason.of("desk.moment_missed", moment=self._act.condition.sentence, why=self._why)
        return (Fault(place, reason, Reason.of("desk.waited_no_longer")),)
