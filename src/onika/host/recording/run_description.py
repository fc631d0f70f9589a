"""Describes runs as recordings say them: the plans that sessions have prepared, as they came (law 29)."""

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Protocol

from msgspec.structs import replace

from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.units.driver_clock import DriverClock
from onika.record.run import RunRecord
from onika.wire import request
from onika.wire.plan import Plan, PlannedFlow


class DescribedDriver(DriverClock, Protocol):
    """The driver, as far as a recording says how it was started."""

    options: tuple[str, ...]
    """What the runtime was started with beside, which changes what happens."""

    @property
    def worlds(self) -> Sequence[str]:
        """The worlds that are open."""
        ...


class RunDescriptions:
    """Of every run of a runtime."""

    def __init__(self, subsystems: Subsystems, driver: DescribedDriver) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._prepared: dict[str, request.Prepare] = {}
        self._has_run = False

    def keep(self, session: str, message: request.Prepare) -> None:
        """The plan that a session has prepared, as it came."""
        self._prepared[session] = message

    def lost(self, session: str) -> None:
        """A session is gone."""
        self._prepared.pop(session, None)

    def began(self) -> None:
        """A run has begun; no later one is the first."""
        self._has_run = True

    def describe(self, session: str, message: request.Begin) -> RunRecord | None:
        """The run that is to begin now; None where no plan of the session is known."""
        original = self._prepared.get(session)
        if original is None:
            return None
        driver = self._driver
        bare = replace(message, record="", repeat=(), repeat_until_ns=0, is_held=False)
        began = datetime.now(UTC).isoformat(timespec="milliseconds")
        units, options = self._subsystems.units, tuple(driver.options)
        return RunRecord(original, bare, units, driver.is_virtual, self._is_first(), began, options=options)

    def describe_by_hand(self, live: LiveSubsystem) -> RunRecord:
        """A subsystem that is held by hand, as it is now: a plan of its tasks, without an action."""
        tasks = tuple(wired.task for wired in live.wired)
        digests = dict.fromkeys(task.digest for task in tasks)
        code = tuple(live.executor.spawner.code(digest) for digest in digests)
        plan = Plan(live.name, (PlannedFlow(live.name, tasks, ()),), code)
        driver = self._driver
        began = datetime.now(UTC).isoformat(timespec="milliseconds")
        options = tuple(driver.options)
        return RunRecord(
            request.Prepare(plan, ()),
            request.Begin(),
            self._subsystems.units,
            driver.is_virtual,
            is_fresh=False,
            began=began,
            options=options,
            is_by_hand=True,
        )

    def _is_first(self) -> bool:
        """Whether nothing has happened here before; a subsystem that is only held changes nothing."""
        lives = not all(live.is_empty for live in self._subsystems.live.values())
        is_new = self._driver.now == 0 or not self._driver.is_virtual
        return not (self._has_run or lives or self._driver.worlds) and is_new
