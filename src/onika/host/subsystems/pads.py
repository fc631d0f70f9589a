"""Pads: what a person pushes is written where a task listens to it, for whoever holds the subsystem (K07, law 27).

A push is believed for a moment only, and it is the task that counts how old the last one is: whoever falls silent, in
whatever way, leads nothing any more.
"""

import numpy as np

from onika.host.subsystems.subsystem_registry import Subsystems
from onika.model import pad
from onika.model.lifecycle import State
from onika.wire import live, request
from onika.words.reason import Reason

_ALONE_NS = 1_000_000_000
"""So long after his last push nobody else leads in place of who let his pad fall."""
_COUNTS = 2.0**31
"""Counts go round: what matters is that two that follow each other differ."""


class Pads:
    """Writes pushes into tables; one person at a time leads in a subsystem."""

    def __init__(self, subsystems: Subsystems) -> None:
        self._subsystems = subsystems
        self._leaders: dict[str, tuple[str, int]] = {}
        """By subsystem: who holds the dead-man, and when this was said last, in ns."""

    def push(self, session: str, push: live.Push, now: int) -> request.Response:
        """Write it, or say why nobody is led by it."""
        home = self._home(session, push.subsystem)
        if isinstance(home, Reason):
            return request.Refused(home)
        leader, at = self._leaders.get(home, ("", 0))
        if leader and leader != push.source and now - at < _ALONE_NS:
            return request.Refused(Reason.of("host.pad_taken"))
        self._leaders[home] = (push.source if push.is_held else "", now)
        ring = self._subsystems.tables[home].ring(pad.NAME)
        count = float(self._subsystems.tables[home].value(pad.NAME)[pad.COUNT])
        ring.write(_row(push, (count + 1.0) % _COUNTS).tobytes())
        ring.seal()
        return request.Done()

    def _home(self, session: str, wanted: str) -> str | Reason:
        """The subsystem that this session leads in, or why there is none."""
        homes = [wanted] if wanted else list(self._subsystems.tables)
        listening = [home for home in homes if self._listens(home)]
        if not listening:
            return Reason.of("host.no_pad_in", subsystem=wanted) if wanted else Reason.of("host.no_pad")
        own = [home for home in listening if self._holder(home) == session]
        if len(own) == 1:
            return own[0]
        if own:
            return Reason.of("host.one_subsystem", names=tuple(own))
        holder = self._holder(listening[0])
        if holder:
            return Reason.of("host.pad_held", subsystem=listening[0], holder=holder)
        return Reason.of("host.pad_of_nobody", subsystem=listening[0])

    def _listens(self, home: str) -> bool:
        """Whether a task that is ON reads pushes there, which no task of it makes."""
        members = self._subsystems.members(home).values()
        if any(pad.NAME in (*member.wired.outvar, *member.wired.outconst) for member in members):
            return False
        readers = [member for member in members if pad.NAME in member.wired.invar]
        if not any(member.state is State.ON for member in readers):
            return False
        entry = self._subsystems.tables[home].entries.get(pad.NAME)
        return entry is not None and str(entry.shape) == f"double[{pad.SIZE}]"

    def _holder(self, home: str) -> str:
        run = self._subsystems.run_in(home)
        if run is not None:
            return run.session
        by_hand = self._subsystems.live.get(home)
        return by_hand.holder if by_hand is not None else ""


def _row(push: live.Push, count: float) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    frame = float(pad.FRAMES.index(push.frame))
    axes = np.clip(push.axes, -1.0, 1.0)
    return np.array([count, push.is_held, min(max(push.scale, 0.0), 1.0), frame, push.button, *axes], dtype=np.float64)
