"""The suspicion: from whom upstream came what is no number, when a task failed over it (requirement X06, law 5)."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from onika.runtime.wiring import WiredTask
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class Suspicion:
    """The way of what is no number, from the failed task upstream; nothing where it read proper numbers."""

    trail: tuple[tuple[str, str], ...] = ()
    """The variables on that way, each with the task that wrote it; the last one is suspected."""
    is_made_there: bool = False
    """Whether everything that the last one reads is in order."""

    @property
    def task(self) -> str:
        """Who is suspected; empty: nobody."""
        return self.trail[-1][1] if self.trail else ""

    @property
    def reason(self) -> Reason:
        """The same in words."""
        if not self.trail:
            return NOTHING
        (svar, writer), *before = self.trail
        way = [Reason.of("host.made_by", task=writer)]
        way += [Reason.of("host.made_out_of", variable=name, task=other) for name, other in before]
        if self.is_made_there:
            way.append(Reason.of("host.of_proper_numbers"))
        return Reason.of("host.no_number", variable=svar, way=tuple(way))


def suspicion(failed: WiredTask, beside: Sequence[WiredTask], is_wrong: Callable[[str], bool]) -> Suspicion:
    """Follow what is no number upstream among the tasks that were ON beside the failed one, which may be among them."""
    writers = {
        svar: wired_task
        for wired_task in beside
        if wired_task.name != failed.name
        for svar in (*wired_task.outconst, *wired_task.outvar)
    }
    trail: list[tuple[str, str]] = []
    reader, met = failed, {failed.name}
    while True:
        wrong = [svar for svar in (*reader.invar, *reader.inconst) if is_wrong(svar)]
        known = next((svar for svar in wrong if svar in writers and writers[svar].name not in met), None)
        if known is None:
            return Suspicion(tuple(trail), bool(trail) and not wrong)
        reader = writers[known]
        trail.append((known, reader.name))
        met.add(reader.name)


def is_no_number(value: Any) -> bool:
    """Whether a value, or one of those in it, is NaN or infinity."""
    if isinstance(value, list | tuple):
        return any(is_no_number(one) for one in value)
    return isinstance(value, float) and not math.isfinite(value)
