"""Variables that somebody looks at with a scope: their values at every cycle, as long as they are asked for (C14, C27).

The tables are looked at, never the tasks: what is watched costs what controls nothing.
"""

from collections.abc import Callable
from dataclasses import dataclass
from time import monotonic_ns
from typing import Protocol

from onika.host.recording.sample_history import SampleHistory
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.ring.slots import LONGEST_SEALED
from onika.runtime.table import Table, TableEntry
from onika.wire import samples
from onika.wire.request import Refused, Response
from onika.words.reason import NOTHING, Reason
from onika.words.value import ValueType

LOOKED_EVERY_NS = 5_000_000
"""An entry keeps sixty-three values: of what is written 500 times a second nothing is missed for 126 ms."""
MOST_TRACES = 64
"""Of all that ask together."""
_UNASKED_NS = 5_000_000_000
"""So long after it was asked for last, a variable is no longer looked at (in wall time, also of virtual runs)."""


class SampledDriver(Protocol):
    """The driver, as far as it is sampled."""

    @property
    def now(self) -> int:
        """The runtime's time in ns."""
        ...

    @property
    def is_virtual(self) -> bool:
        """Whether time is virtual."""
        ...

    def each_instant(self, look: Callable[[], None]) -> None:
        """In virtual time: call this one too at the end of every instant."""
        ...

    def leave_instants(self, look: Callable[[], None]) -> None:
        """Call it no more."""
        ...


@dataclass(slots=True)
class _Followed:
    """A variable that is looked at."""

    table: Table
    entry: TableEntry
    history: SampleHistory
    asked_ns: int
    period_ns: int


class Sampling:
    """All variables that anybody samples; each is kept once."""

    def __init__(self, subsystems: Subsystems, seen: SampledDriver, clock: Callable[[], int] = monotonic_ns) -> None:
        self._subsystems = subsystems
        self._seen = seen
        self._clock = clock
        self._followed: dict[str, _Followed] = {}
        self._looked_at = -1
        self._due_ns = 0

    def answer(self, message: samples.Sample) -> Response:
        """What came since the last asking."""
        names = message.variables
        if len(names) > samples.MOST_VARIABLES or len(message.after) not in (0, len(names)):
            return Refused(Reason.of("host.samples_form", most=samples.MOST_VARIABLES))
        self._look()
        after = message.after or (0,) * len(names)
        traces = tuple(self._trace(name, number) for name, number in zip(names, after, strict=True))
        return samples.Sampled(self._seen.now, traces)

    def serve(self) -> None:
        """Look, if it is time; forget what nobody asks for."""
        now = self._clock()
        if not self._followed or now < self._due_ns:
            return
        self._due_ns = now + LOOKED_EVERY_NS
        for name, followed in list(self._followed.items()):
            if now - followed.asked_ns > _UNASKED_NS:
                self._leave(name)
        if not self._seen.is_virtual:
            self._look()

    def due_ns(self, wall_ns: int) -> int | None:
        """How long until `serve` has something to do."""
        return max(0, self._due_ns - wall_ns) if self._followed else None

    # Inner

    def _trace(self, name: str, after: int) -> samples.SampleTrace:
        followed, reason = self._follow(name)
        if followed is None:
            return samples.SampleTrace(name, reason=reason)
        stretches, values = followed.history.since(after)
        return samples.SampleTrace(name, str(followed.entry.shape), stretches, values, reason)

    def _follow(self, name: str) -> tuple[_Followed | None, Reason]:
        """The variable as it is looked at from now on; why not, where it is not there or no more."""
        followed = self._followed.get(name)
        home, _, variable = name.rpartition("/")
        table = self._subsystems.tables.get(home)
        entry = table.entries.get(variable) if table is not None else None
        if table is None or entry is None:
            return followed, Reason.of("host.not_sampled_there", name=name)
        if followed is not None and followed.table is table and followed.entry is entry:
            followed.asked_ns = self._clock()
            followed.period_ns = self._period_ns(home, variable)
            return followed, NOTHING
        reason = self._why_not(name, entry)
        if reason:
            return None, reason
        followed = _Followed(
            table, entry, SampleHistory(table.ring(variable)), self._clock(), self._period_ns(home, variable)
        )
        self._followed[name] = followed
        if len(self._followed) == 1:
            self._seen.each_instant(self._look)
            self._looked_at = -1
        self._take(followed, self._seen.now)
        return followed, NOTHING

    def _why_not(self, name: str, entry: TableEntry) -> Reason:
        if entry.shape.type.is_text or entry.shape.type is ValueType.CHAR:
            return Reason.of("host.not_sampled_text", name=name)
        if entry.shape.size > LONGEST_SEALED:
            return Reason.of("host.not_sampled_long", name=name, most=LONGEST_SEALED)
        if name not in self._followed and len(self._followed) >= MOST_TRACES:
            return Reason.of("host.too_many_sampled", most=MOST_TRACES)
        return NOTHING

    def _period_ns(self, home: str, variable: str) -> int:
        """How often its writer cycles; 0: nobody knows, or in virtual time, where every value has its own instant."""
        if self._seen.is_virtual:
            return 0
        by_hand = self._subsystems.live.get(home)
        for task, member in self._subsystems.members(home).items():
            if variable in member.wired.outvar:
                rate = by_hand.desired.rate(task) if by_hand is not None else None
                hertz = rate or member.wired.task.frequency
                return round(1e9 / hertz) if hertz else 0
        return 0

    def _leave(self, name: str) -> None:
        del self._followed[name]
        if not self._followed:
            self._seen.leave_instants(self._look)

    def _look(self) -> None:
        now = self._seen.now
        for followed in self._followed.values():
            self._take(followed, now)
        self._looked_at = now

    def _take(self, followed: _Followed, now: int) -> None:
        table, entry = followed.table, followed.entry
        if table.entries.get(entry.name) is entry:
            followed.history.take(table.ring(entry.name), now, self._looked_at, followed.period_ns)
