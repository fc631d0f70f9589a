"""The switch that follows each flow's current action lies ready on its unit, so that nobody is asked at the finish.

It is prepared when everybody of the action is ON and anew whenever that changes. What the user wants of a flow waits
until nothing is prepared for it any more: else the unit could go on while the engine believes that it has paused.
"""

from collections.abc import Callable, Mapping

from onika.engine.engine import Engine
from onika.engine.orders import Switch
from onika.host.execution.subsystem_executor import SubsystemExecutor
from onika.runtime import command


class PreparedSwitches:
    """Serves all flows of one run."""

    def __init__(self, engine: Engine, executors: Mapping[int, SubsystemExecutor]) -> None:
        self._engine = engine
        self._executors = executors
        self._revisions: dict[int, tuple[int, bool]] = {}
        self._ready: dict[int, Mapping[int, command.Switch]] = {}
        self._tasks: dict[int, str] = {}
        self._waiting: dict[int, list[Callable[[], None]]] = {}

    def refresh(self) -> None:
        """Prepare what follows, where that has changed."""
        for flow in self._executors:
            revision = self._engine.revision(flow)
            if self._revisions.get(flow) != revision and not self._waiting.get(flow):
                self._revisions[flow] = revision
                self._prepare(flow)

    def switched(self, switch: Switch) -> Switch | None:
        """The unit has carried out the case of the switch's number; what of it is still to be done, if anything.

        The unit forgets what it holds when anybody's state changes, so that mostly nothing is.
        """
        done = self._ready.pop(switch.flow)[switch.number]
        self._executors[switch.flow].adopt(done)
        started = {launch.task for launch in done.on}
        off = tuple(task for task in switch.off if task not in done.off)
        on = tuple(start for start in switch.on if start.task not in started)
        return Switch(switch.flow, off, on) if off or on else None

    def appointed(self, number: int, switches: Mapping[int, command.Switch]) -> None:
        """Units have carried these out by themselves at an agreed time, by flow (law 34)."""
        for flow, switch in switches.items():
            self._ready[flow] = {number: switch}

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
            self._executors[flow].unprepare(self._tasks[flow])

    def freed(self, flow: int) -> None:
        """The unit has forgotten what was prepared, or is gone."""
        self._ready.pop(flow, None)
        waiting = self._waiting.pop(flow, [])
        self._revisions.pop(flow, None)
        for then in waiting:
            then()

    def free_all(self) -> None:
        """The run comes to its end: nothing is prepared any more."""
        for flow in list(self._executors):
            self.freed(flow)

    def _prepare(self, flow: int) -> None:
        cases = self._engine.cases(flow)
        if not cases:
            self._drop(flow)
            return
        task = cases[0].task
        ready = self._executors[flow].prepare(task, cases)
        if ready is not None:
            self._tasks[flow], self._ready[flow] = task, ready

    def _drop(self, flow: int) -> None:
        """What was prepared does not hold any more."""
        if self._ready.get(flow):
            self.when_free(flow, lambda: None)
