"""What is shown of a recorded run at any instant: as it was told then, by the same rules as a run that goes on now."""

from bisect import bisect_right
from collections.abc import Sequence
from itertools import accumulate

from msgspec import structs

from onika.desk.environment.run_state import flow_progress
from onika.desk.environment.run_state.run import Run
from onika.wire import event
from onika.wire.view import RunView

_EVERY = 64
"""Pieces of news between two runs that are kept: so many are told again at most."""


class RunHistory:
    """The run as it began, and what was told of it since: when (ns), about which subsystem, and what."""

    def __init__(self, begun: Run, events: Sequence[tuple[int, str, event.Event]]) -> None:
        self._times = list(accumulate((at for at, _, _ in events), max))
        self._told = [message for _, _, message in events]
        self._kept = [begun]
        for number, message in enumerate(self._told, 1):
            begun = flow_progress.after(begun, message)
            if number % _EVERY == 0:
                self._kept.append(begun)

    @property
    def begun(self) -> Run:
        """The run as it began."""
        return self._kept[0]

    def at(self, at_s: float) -> RunView:
        """What was shown then. Nothing in it can be chosen: that time is over."""
        count = bisect_right(self._times, round(at_s * 1e9))
        run = self._kept[count // _EVERY]
        for message in self._told[count - count % _EVERY : count]:
            run = flow_progress.after(run, message)
        stops = {key: structs.replace(stop, choices=()) for key, stop in run.view.stops.items()}
        return structs.replace(run.view, stops=stops)
