"""Whether anything may move: the stop of all that a runtime drives, what ends it, why no run may begin (law 27)."""

from collections.abc import Iterable
from typing import Protocol

from onika.host.subsystems.subsystem_registry import Subsystems, Tell
from onika.wire import event
from onika.words.reason import NOTHING, Reason


class StoppedDriver(Protocol):
    """What is stopped: the drives and units of a runtime."""

    @property
    def now(self) -> int:
        """The runtime's time in ns."""
        ...

    def stop(self) -> None:
        """Every drive in hold, latched."""
        ...

    def reset(self) -> None:
        """Motion is allowed again; nothing moves by itself."""
        ...


class Motion:
    """The motion of everything in a runtime: allowed, or stopped until it is deliberately allowed again."""

    def __init__(self, subsystems: Subsystems, driver: StoppedDriver, tell: Tell) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._tell = tell
        self.is_stopped = False

    def stop(self, session: str, cause: Reason) -> None:
        """Straight to the devices and every unit; then runs end, and nothing held by hand is wanted ON any more."""
        self._driver.stop()
        for run in self._subsystems.runs:
            run.runner.abort(cause, self._driver.now)
        for live in self._subsystems.live.values():
            live.desired.turn_everything_off()
        self._turn(session, True, cause)

    def allow(self, session: str) -> None:
        """A deliberate reset: what comes on from now on may move; nothing does by itself."""
        self._driver.reset()
        self._turn(session, False, NOTHING)

    def refusal(self, units: Iterable[str]) -> Reason:
        """Why no run may begin now whose tasks want these units; empty: it may."""
        if self.is_stopped:
            return Reason.of("host.is_stopped")
        for unit in units:
            gone = self._subsystems.gone(unit)
            if gone:
                return Reason.of("host.start_anew", gone=gone)
        return NOTHING

    def _turn(self, session: str, is_stopped: bool, cause: Reason) -> None:
        self.is_stopped = is_stopped
        self._tell(event.Stopped(is_stopped, cause), "", session)
