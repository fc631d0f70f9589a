"""The runtime program: answers requests, prepares plans, starts runs on its driver, tells how they end."""

from time import monotonic_ns
from typing import Protocol

from onika.host.gate import Gate
from onika.host.preparation import Loading, Preparation, inspect, prepare
from onika.host.runner import Runner
from onika.host.units import Units
from onika.ring.segment import Segment
from onika.runtime.subsystem import Subsystem
from onika.runtime.table import SIZE, Table
from onika.wire import request
from onika.words.fault import Fault

_REST_NS = 300_000_000
"""How long the end of a run waits at most until every drive holds."""


class Driver(Units, Protocol):
    """Where a run happens: in wall or in virtual time."""

    @property
    def now(self) -> int:
        """The runtime's time in ns since its start."""
        ...

    @property
    def digest(self) -> str:
        """Of everything that happened in the run, where that is the same every time; else empty."""
        ...

    def share(self, name: str, segment: Segment) -> None:
        """Let the RTPUs see a table."""
        ...

    def begin(self, runner: Runner) -> None:
        """Start a run."""
        ...

    def advance(self, wall_ns: int) -> bool:
        """Let the run go on; False if nothing happens until somebody says something."""
        ...

    def abort(self, cause: str) -> None:
        """End the run."""
        ...

    def answer(self, subsystem: str, task: str, line: str) -> None:
        """The user's answer."""
        ...

    def stop(self) -> None:
        """Every drive in hold, latched."""
        ...

    def is_at_rest(self) -> bool:
        """Once a run is over: whether every drive holds."""
        ...

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        ...


class Program:
    """One runtime. Runs follow one another, never side by side: several flows of one application are one run."""

    def __init__(self, gate: Gate, driver: Driver, loading: Loading, rtpus: tuple[str, ...]) -> None:
        self._gate = gate
        self._driver = driver
        self._loading = loading
        self._rtpus = rtpus
        self._prepared: Preparation | None = None
        self._runner: Runner | None = None
        self._began_wall = 0
        self._over_since = 0
        self._runs = 0
        self.is_over = False

    @property
    def is_running(self) -> bool:
        """Whether an application is executed now."""
        return self._runner is not None

    def serve(self) -> None:
        """Carry out what was asked."""
        for ticket, asked in self._gate.requests():
            self._gate.reply(ticket, self._respond(asked))

    def advance(self, wall_ns: int) -> bool:
        """Let a run go on for about so long; tell its result when it is over. False: nothing happens by itself."""
        if self._runner is None:
            return False
        goes_on = self._driver.advance(wall_ns)
        if not self._runner.is_over:
            return goes_on
        self._over_since = self._over_since or monotonic_ns()
        if self._driver.is_at_rest() or monotonic_ns() - self._over_since > _REST_NS:
            self._tell_result(self._runner)
            self._runner = None
            self._over_since = 0
        return False

    def take(self, prepared: Preparation) -> None:
        """The next plan to run; one with faults leaves nothing to run."""
        self._prepared = None if prepared.faults else prepared

    def begin(self, asked: request.Begin) -> request.Response:
        """Start a run of the prepared plan on empty, zeroed tables (law 4)."""
        if self._runner is not None:
            return request.Refused("an application runs already")
        if self._prepared is None:
            return request.Refused("no plan is prepared, or it has faults")
        self._runs += 1
        subsystems = {}
        for number, flow in enumerate(self._prepared.plan.flows):
            table = Table(Segment.create(f"table-{flow.subsystem}", SIZE))
            self._driver.share(f"table:{flow.subsystem}", table.segment)
            rtpus = {task.name: self._rtpu(task.rtpu) for task in flow.tasks}
            subsystems[number] = Subsystem(
                flow.subsystem, table, self._prepared.flows[number], rtpus, self._prepared.constants[number]
            )
        self._began_wall = monotonic_ns()
        self._runner = Runner(self._prepared, asked, subsystems, self._driver, self._gate.tell)
        self._driver.begin(self._runner)
        return request.Done()

    def _respond(self, asked: request.Request) -> request.Response:
        match asked:
            case request.Prepare():
                return self._prepare(asked)
            case request.Inspect():
                faults, notes = inspect(asked.tasks, asked.code, self._loading)
                return request.Prepared(_texts(faults), tuple(notes))
            case request.Begin():
                return self.begin(asked)
            case request.Reply():
                self._driver.answer(asked.subsystem, asked.task, asked.line)
            case request.Abort():
                self._driver.abort(asked.cause)
            case request.Stop():
                self._driver.stop()
                self._driver.abort(asked.cause)
            case request.Snapshot():
                return request.Worlds(self._driver.snapshots())
            case request.Quit():
                self.is_over = True
        return request.Done()

    def _prepare(self, asked: request.Prepare) -> request.Response:
        prepared = prepare(asked.plan, asked.targets, self._loading)
        self.take(prepared)
        return request.Prepared(_texts(prepared.faults), tuple(prepared.notes))

    def _rtpu(self, wanted: str) -> str:
        """The unit a task runs on: the named one, else the first (decision 12)."""
        return wanted if wanted in self._rtpus else self._rtpus[0]

    def _tell_result(self, runner: Runner) -> None:
        assert self._prepared is not None  # noqa: S101 - a run has a plan
        actions = sum(len(flow.actions) for flow in self._prepared.plan.flows)
        wall = (monotonic_ns() - self._began_wall) * 1e-9
        self._gate.tell(runner.tally.result(actions, wall, self._driver.digest))


def _texts(faults: list[Fault]) -> tuple[request.FaultText, ...]:
    return tuple(
        request.FaultText(one.place.file, one.place.line, one.expected, one.found, one.instead) for one in faults
    )
