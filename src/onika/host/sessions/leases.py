"""The dead-man lease: who holds something and is not heard for so long holds it no more (requirement X12).

Silence is judged on the runtime's own clock that never goes back, by what was read: a runtime that was busy itself
takes in first what waits, and judges then. What counts is silence that was listened to: time in which the runtime, or
its listener, stood still itself is excused, for as long as the lease once more at most. The program that launched the
runtime has none: its end is noticed. In virtual time there are no leases (law 15).
"""

from collections.abc import Callable
from dataclasses import dataclass
from time import monotonic_ns
from typing import Protocol

_MS = 1_000_000
LEASE_NS = 1000 * _MS
"""Over TCP, where one lost packet may keep all others back; beats come ten times a second."""
NEAR_NS, FAR_NS = 250 * _MS, 500 * _MS
"""Where beats come as datagrams, twenty times a second: on a short way, and on a long one."""
_LONG_WAY_US = 20_000
"""The round trip from which on a way is long: what is between may keep datagrams for a while."""
_STEADY, _GONE_NS = 5, 1000 * _MS
"""How many datagrams have to have come before they are relied on, and after how long without one they no more are."""
_LOOK_NS = 50 * _MS
"""How often to look; what lies longer between two looks is time in which the runtime stood still."""


@dataclass(frozen=True, slots=True)
class SessionSilence:
    """How a session was heard: for how long not at all, and its beats that came as datagrams."""

    silent_ns: int
    beats: int = 0
    beats_silent_ns: int = 0
    round_trip_us: int = -1


class LeasedControl(Protocol):
    """Who holds something."""

    @property
    def needed(self) -> set[str]:
        """The sessions on whose being there something depends."""
        ...

    def lapse(self, session: str, silent_ns: int, now: int) -> None:
        """It has been silent for too long."""
        ...


SilenceOf = Callable[[str], SessionSilence | None]
"""How a session is heard; None where its lease never ends."""


class Leases:
    """Takes from holders what they hold when they are silent for too long.

    length_ns    the lease whatever the way; None: as the way allows; 0: there is none
    deaf         for how long nothing could be heard up to now, whoever spoke
    """

    def __init__(
        self,
        held: LeasedControl,
        hearing: SilenceOf,
        length_ns: int | None,
        clock: Callable[[], int] = monotonic_ns,
        deaf: Callable[[], int] = lambda: 0,
    ) -> None:
        self._deaf = deaf
        self._held = held
        self._hearing = hearing
        self._length_ns = length_ns
        self._clock = clock
        self._looked_ns = clock()
        self._excused: dict[str, tuple[int, int]] = {}
        """By session, when it was heard last, and for how long of the silence since then nobody listened."""

    def judge(self, now: int) -> list[str]:
        """Who has been silent for too long; it holds nothing any more. `now` is the runtime's time."""
        looked_ns, self._looked_ns = self._looked_ns, self._clock()
        stood_ns = max(0, self._looked_ns - looked_ns - 2 * _LOOK_NS)
        gone, excused, deaf_ns = [], {}, self._deaf()
        for session, heard in self._needed():
            length_ns = self._length(heard)
            at_ns, before_ns = self._excused.get(session, (0, 0))
            heard_ns = self._looked_ns - heard.silent_ns
            spared_ns = min((before_ns if abs(heard_ns - at_ns) < _MS else 0) + stood_ns, length_ns, heard.silent_ns)
            excused[session] = (heard_ns, spared_ns)
            if heard.silent_ns - max(spared_ns, min(deaf_ns, length_ns)) >= length_ns:
                self._held.lapse(session, heard.silent_ns, now)
                gone.append(session)
        self._excused = excused
        return gone

    def due_ns(self) -> int | None:
        """How long until `judge` may have something to do."""
        left = (self._left(session, heard) for session, heard in self._needed())
        least_ns = _LOOK_NS // 5 if self._deaf() else 0  # it is looked again, and soon
        return min((max(least_ns, min(_LOOK_NS, one)) for one in left), default=None)

    def of(self, session: str) -> int:
        """For how long a session may be silent now, in ns; 0: for ever."""
        hearing = self._hearing(session)
        return 0 if hearing is None else self._length(hearing)

    def _left(self, session: str, heard: SessionSilence) -> int:
        return self._length(heard) - heard.silent_ns + self._excused.get(session, (0, 0))[1]

    def _length(self, heard: SessionSilence) -> int:
        if self._length_ns is not None:
            return self._length_ns
        if heard.beats < _STEADY or heard.beats_silent_ns >= _GONE_NS:
            return LEASE_NS
        if heard.round_trip_us >= _LONG_WAY_US:
            return FAR_NS
        return NEAR_NS

    def _needed(self) -> list[tuple[str, SessionSilence]]:
        if self._length_ns == 0:
            return []
        heard = ((session, self._hearing(session)) for session in sorted(self._held.needed))
        return [(session, one) for session, one in heard if one is not None]
