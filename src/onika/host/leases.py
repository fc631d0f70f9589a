"""The dead-man lease: who holds something and is not heard for so long holds it no more (requirement X12).

Silence is judged on the runtime's own clock that never goes back, by what was read: a runtime that was busy itself
takes in first what waits, and judges then. The program that launched the runtime has none: its end is noticed. In
virtual time there are no leases (law 15).
"""

from collections.abc import Callable
from typing import Protocol

LEASE_NS = 1_000_000_000
"""Over TCP, where one lost packet may keep all others back; beats come ten times a second."""


class Held(Protocol):
    """Who holds something."""

    @property
    def needed(self) -> set[str]:
        """The sessions on whose being there something depends."""
        ...

    def lapse(self, session: str, silent_ns: int, now: int) -> None:
        """It has been silent for too long."""
        ...


Silent = Callable[[str], int | None]
"""For how long a session has not been heard, in ns; None where its lease never ends."""


class Leases:
    """Takes from holders what they hold when they are silent for too long; `length_ns` 0: never."""

    def __init__(self, held: Held, silent: Silent, length_ns: int) -> None:
        self._held = held
        self._silent = silent
        self._length_ns = length_ns

    def judge(self, now: int) -> list[str]:
        """Who has been silent for too long; it holds nothing any more. `now` is the runtime's time."""
        gone = []
        for session, silent_ns in self._silences():
            if silent_ns >= self._length_ns:
                self._held.lapse(session, silent_ns, now)
                gone.append(session)
        return gone

    def due_ns(self) -> int | None:
        """How long until `judge` may have something to do."""
        return min((max(0, self._length_ns - one) for _, one in self._silences()), default=None)

    def _silences(self) -> list[tuple[str, int]]:
        if not self._length_ns:
            return []
        silences = ((session, self._silent(session)) for session in sorted(self._held.needed))
        return [(session, silent_ns) for session, silent_ns in silences if silent_ns is not None]
