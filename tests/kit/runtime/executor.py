"""An executor of a subsystem for tests: what it tells goes nowhere, unless a test wants it."""

from collections.abc import Callable, Mapping

from onika.host.execution import task_events
from onika.host.execution.spawner import Spawner
from onika.host.execution.subsystem_executor import Client, SubsystemExecutor
from onika.host.units.unit_registry import Units
from onika.runtime.subsystem import RunningSubsystem
from onika.wire import event
from onika.words.reason import Reason


def executor(
    subsystem: RunningSubsystem,
    units: Units,
    client: Client = lambda _message, _before: None,
    tell: Callable[[event.Event], None] = lambda _event: None,
    lost: Mapping[str, Reason] | None = None,
) -> SubsystemExecutor:
    """An executor that has no code; `executor.spawner` takes it."""
    gone = lost if lost is not None else {}
    return SubsystemExecutor(subsystem, units, Spawner(units, gone), client, tell, task_events.by_hand, gone)
