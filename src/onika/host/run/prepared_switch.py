"""The outlook: what follows each flow's current action lies ready on its unit, so that nobody is asked at the finish.

It is prepared when everybody of the action is ON and anew whenever that changes. What the user wants of a flow waits
until nothing is prepared for it any more: else the unit could go on while the engine believes that it has paused.
"""

from collections.abc import Callable, Mapping

from onika.engine.engine import Engine
from onika.engine.orders import Switch
from onika.host.run.switch_dispatch import Switchboard
from onika.runtime import command
from onika.runtime.subsystem import RunningSubsystem


class Outlook:
    """Of all flows of one run."""

    def __init__(self, engine: Engine, subsystems: Mapping[int, RunningSubsystem], switchboard: Switchboard) -> None:
        self._engine = engine
        self._subsystems = subsystems
        self._switchboard = switchboard
        self._known: dict[int, tuple[int, bool]] = {}
        self._ready: dict[int, Mapping[int, command.Switch]] = {}
        self._tasks: dict[int, str] = {}
        self._waiting: dict[int, list[Callable[[], None]]] = {}

    def look(self) -> None:
        """Prepare what follows, where that has changed."""
        for flow in self._subsystems:
            revision = self._engine.revision(flow)
            if self._known.get(flow) != revision and not self._waiting.get(flow):
                self._known[flow] = revision
                self._prepare(flow)

    def switched(self, flow: int, order: Switch) -> Switch | None:
        """The unit has carried out the case of the order's number; what of the order is still to be done, if anything.

        The unit forgets what it holds when anybody's state changes, so that mostly nothing is.
        """
        done = self._ready.pop(flow)[order.number]
        self._switchboard.adopt(flow, done)
        started = {launch.task for launch in done.on}
        off = tuple(task for task in order.off if task not in done.off)
        on = tuple(start for start in order.on if start.task not in started)
        return Switch(flow, off, on) if off or on else None

    def finished(self, flow: int) -> None:
        """The action has ended in another way than was prepared."""
        self._ready.pop(flow, None)

    def when_free(self, flow: int, then: Callable[[], None]) -> None:
        """Do this as soon as nothing is prepared for a flow; at once if nothing is."""
        if not self._ready.get(flow):
            then()
            return
        waiting = self._waiting.setdefault(flow, [])
        waiting.append(then)
        if len(waiting) == 1:
            self._switchboard.unprepare(flow, self._tasks[flow])

    def freed(self, flow: int) -> None:
        """The unit has forgotten what was prepared, or is gone."""
        self._ready.pop(flow, None)
        waiting = self._waiting.pop(flow, [])
        self._known.pop(flow, None)
        for then in waiting:
            then()

    def free_all(self) -> None:
        """The run comes to its end: nothing is prepared any more."""
        for flow in list(self._subsystems):
            self.freed(flow)

    def _prepare(self, flow: int) -> None:
        cases = self._engine.cases(flow)
        if not cases:
            self._drop(flow)
            return
        subsystem, task = self._subsystems[flow], cases[0].task
        ready = []
        for case in cases:
            on = [start.task for start in case.switch.on]
            if subsystem.clashes((task, *case.switch.off), on):
                return  # it is refused when its time comes
            ready.append((case, subsystem.forgotten(case.switch.off, on, finished=task)))
        self._tasks[flow] = task
        self._ready[flow] = self._switchboard.prepare(flow, task, ready)

    def _drop(self, flow: int) -> None:
        """What was prepared does not hold any more."""
        if self._ready.get(flow):
            self.when_free(flow, lambda: None)
