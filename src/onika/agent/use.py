"""When nobody uses a runtime any more that was launched for whoever came. No I/O, no clock."""

from dataclasses import dataclass

FIRST_NS = 60 * 1_000_000_000
"""How long it waits for the first one who connects."""
LAST_NS = 10 * 1_000_000_000
"""How long after the last one has gone, and nothing runs any more."""


@dataclass(slots=True)
class RuntimeUse:
    """Since when nobody is there; all times in ns of one clock."""

    since_ns: int
    """When it was launched, or was used last."""
    was_used: bool = False

    def look(self, now_ns: int, *, is_used: bool) -> bool:
        """Whether it is used no more."""
        if is_used:
            self.since_ns, self.was_used = now_ns, True
            return False
        return now_ns - self.since_ns >= (LAST_NS if self.was_used else FIRST_NS)
