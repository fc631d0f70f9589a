"""Switches that a unit carries out by itself at an agreed time, and what it holds by itself afterwards (law 34).

It needs nobody for either: what it looks at lies in shared memory. So a program that is frozen, or a line that is cut,
neither lets a flow begin late nor keeps one moving that has begun alone.
"""

from dataclasses import dataclass, replace
from enum import Enum

from onika.ring.begin_words import BeginWords
from onika.runtime.command import Appointment

LATE_NS = 5_000_000
"""Nothing is begun later than this after its time, where the machine grants real time."""
SHARED_LATE_NS = 20_000_000
"""Nor than this where it does not: there a unit gets its turn that late, also at each of its cycles."""

NEVER = 2**63


class AppointmentStep(Enum):
    """What is to be done with an appointment whose time has come."""

    BEGIN = "begin"
    MISS = "miss"
    HOLD = "hold"


@dataclass(frozen=True, slots=True)
class _Kept:
    order: Appointment
    has_begun: bool = False

    @property
    def due_ns(self) -> int:
        return self.order.at_ns + (self.order.hold_ns if self.has_begun else 0)


class Appointments:
    """Of one unit, by their numbers. `next_ns` is when the next one wants to be looked at."""

    def __init__(self, words: BeginWords) -> None:
        self.next_ns = NEVER
        self.late_ns = LATE_NS
        """So late at most anything is begun."""
        self._words = words
        self._kept: dict[int, _Kept] = {}

    def keep(self, order: Appointment) -> None:
        """Begin at its time, if it is permitted then."""
        self._kept[order.number] = _Kept(order)
        self._look_ahead()

    def drop(self, number: int) -> Appointment | None:
        """Nothing follows from it any more; None: nothing does already."""
        kept = self._kept.pop(number, None)
        self._look_ahead()
        return None if kept is None else kept.order

    def drop_all(self) -> list[Appointment]:
        """Forget all; those that have not begun yet."""
        kept, self._kept = self._kept, {}
        self._look_ahead()
        return [each.order for each in kept.values() if not each.has_begun]

    def due(self, now: int) -> list[tuple[AppointmentStep, Appointment]]:
        """What is to be done now; what is confirmed is through."""
        steps = []
        for number, kept in list(self._kept.items()):
            if now >= kept.due_ns:
                step = self._step(kept, now)
                if step is not None:
                    steps.append((step, kept.order))
                if step is AppointmentStep.BEGIN:
                    self._kept[number] = replace(kept, has_begun=True)
                else:
                    del self._kept[number]
        self._look_ahead()
        return steps

    def _step(self, kept: _Kept, now: int) -> AppointmentStep | None:
        number = kept.order.number
        if kept.has_begun:
            return None if self._words.is_confirmed(number) else AppointmentStep.HOLD
        is_late = now > kept.order.at_ns + self.late_ns
        return AppointmentStep.BEGIN if self._words.is_permitted(number) and not is_late else AppointmentStep.MISS

    def _look_ahead(self) -> None:
        self.next_ns = min((kept.due_ns for kept in self._kept.values()), default=NEVER)
