"""The outcome of a run: how it ended, what was expected of it, and its faults (requirements E03, E14)."""

from dataclasses import dataclass, field
from typing import Any

from onika.wire import event
from onika.words.condition import Condition
from onika.words.fault import Fault
from onika.words.reason import Reason


@dataclass(slots=True)
class Outcome:
    """How a run ended. `result` is missing where it was refused; then there are faults."""

    name: str
    faults: list[Fault] = field(default_factory=list)
    notes: list[Reason] = field(default_factory=list)
    result: event.Result | None = None
    expectations: list[tuple[Condition, Any, bool]] = field(default_factory=list)
    snapshots: dict[str, bytes] = field(default_factory=dict)
    actions: int = 0
    """How many actions it has."""
    failed: tuple[Fault, ...] = ()
    """The line of the script that could not be carried out, and why."""
    printed: str = ""
    """What the runtime's processes printed, where the run was aborted."""

    @property
    def state(self) -> str:
        """`refused`, `completed` or `aborted`."""
        if self.result is None:
            return "refused"
        return "completed" if self.result.completed else "aborted"

    @property
    def exit_code(self) -> int:
        """0: completed and every expectation holds; 1: aborted, one does not hold, or a script failed; 2: refused."""
        if self.result is None:
            return 2
        is_good = self.result.completed and not self.failed
        if is_good and all(holds for _, _, holds in self.expectations):
            return 0
        return 1
