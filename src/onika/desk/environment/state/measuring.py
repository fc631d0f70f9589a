"""A subsystem that lives for a moment, so that tasks in it measure where an arm stands (D23)."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class MeasuringSubsystem:
    """Its name, and how the changes of it have ended."""

    name: str
    ends: Mapping[int, Reason] = field(default_factory=lambda: MappingProxyType({}))
    """By the runtime's numbers: why one was taken back; nothing: it is done."""
    awaits: int | None = None
    """The change whose end an act waits for."""
    station: str = ""
    """Where it lives."""

    def ended(self, number: int, cause: Reason) -> "MeasuringSubsystem":
        """With the end of one more change."""
        return replace(self, ends={**self.ends, number: cause})
