"""The processing units that people add to a runtime while it works, and those that they start anew after a loss.

It is a person's act: no unit comes back by itself, and one that comes is empty (laws 17, 30).
"""

from collections.abc import Callable
from functools import partial
from typing import Protocol

from onika.host.subsystems.subsystem_registry import Subsystems
from onika.wire import live, request
from onika.words.name import TASK_NAME
from onika.words.reason import NOTHING, Reason

MOST_UNITS = 8
"""Units of one runtime to which no further one is added."""

Answer = Callable[[request.Response], None]


class StartingDriver(Protocol):
    """Who brings units up."""

    def add_unit(self, name: str, answer: Callable[[Reason], None]) -> None:
        """Begin; answered with nothing when it is up, else with why not."""
        ...


class UnitStarts:
    """Judges who may come, and answers when it is up."""

    def __init__(self, subsystems: Subsystems, driver: StartingDriver) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._starting: set[str] = set()

    def add(self, message: live.AddUnit, answer: Answer) -> None:
        """Begin to start a unit; answered when it is up, or cannot be."""
        refusal = self._refusal(message.name)
        if refusal:
            answer(request.Refused(refusal))
            return
        self._starting.add(message.name)
        self._driver.add_unit(message.name, partial(self._started, message.name, answer))

    def _started(self, name: str, answer: Answer, why_not: Reason) -> None:
        self._starting.discard(name)
        if why_not:
            answer(request.Refused(why_not))
            return
        self._subsystems.unit_up(name)
        answer(request.Done())

    def _refusal(self, name: str) -> Reason:
        """Why no unit of this name is started; empty: it is."""
        units = self._subsystems.units
        if not TASK_NAME.match(name):
            return Reason.of("host.unit_misnamed", name=name)
        if name in self._starting:
            return Reason.of("host.unit_starts", name=name)
        if name in units and name not in self._subsystems.lost_units:
            return Reason.of("host.unit_lives", name=name)
        if name not in units and len({*units, *self._starting}) >= MOST_UNITS:
            return Reason.of("host.units_many", most=MOST_UNITS)
        return NOTHING
