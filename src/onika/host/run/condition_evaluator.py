"""Says whether a condition on state variables holds at this moment, as the tables of a run have them (law 8)."""

from collections.abc import Mapping

from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import plain
from onika.words.condition import Condition


class ConditionEvaluator:
    """Evaluates conditions that are texts.

    An address without a subsystem means the asking flow's own; what is not there never holds.
    """

    def __init__(self, subsystems: Mapping[int, RunningSubsystem]) -> None:
        self._subsystems = subsystems
        self._by_name = {subsystem.name: subsystem for subsystem in subsystems.values()}
        self._parsed: dict[str, Condition] = {}

    def holds(self, flow: int, text: str) -> bool:
        """Whether it holds; raises ValueError for what is no condition."""
        if text not in self._parsed:
            self._parsed[text] = Condition.parse(text)
        condition = self._parsed[text]
        home, _, name = condition.address.rpartition("/")
        subsystem = self._by_name.get(home) if home else self._subsystems[flow]
        if subsystem is None or name not in subsystem.table.entries:
            return False
        return condition.holds({condition.address: plain(subsystem.table.value(name))})
