"""A run from the environment's side: prepare, launch a runtime, follow it to its end (requirements E03, E14)."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from msgspec import structs

from onika.desk.compile import rtpus_of
from onika.desk.interruption import Interruption
from onika.desk.preparation import PreparedRun, prepare_run
from onika.desk.runtime import Conversation, Reached, Runtime, connect
from onika.link.lost import LinkLost
from onika.store.site import Site
from onika.wire import event, request
from onika.wire.plan import Plan
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.name import resolve

_LOOK_S = 0.05
"""How long a Ctrl-C waits at most."""


@dataclass(frozen=True, slots=True)
class Elsewhere:
    """A runtime that somebody else started: its address, a token (empty: see `connect`), certificates to trust."""

    url: str
    token: str = ""
    ca: Path | None = None


@dataclass(frozen=True, slots=True)
class RunSettings:
    """What a run is to be."""

    name: str
    is_virtual: bool = False
    expectations: tuple[Condition, ...] = ()
    settle_s: float = 0.5
    seed: int = 0
    answers: tuple[tuple[str, str, str], ...] = ()
    """Task, name of an input, values."""
    may_ask: bool = False
    wants_picture: bool = False
    with_fifo: bool = True
    elsewhere: Elsewhere | None = None
    scale: float | None = None
    """In virtual time: how many times as fast as wall time it passes; None: as fast as it goes."""
    subsystems: tuple[str, ...] = ()
    """Names for the flows' subsystems in place of flow0, flow1 …"""
    on_loss: str = "stop"
    """What becomes of the run when this program is gone: `stop`, or `run` on."""
    """The runtime to run on; else one is launched here."""


@dataclass(slots=True)
class Outcome:
    """How a run ended. `result` is missing where it was refused; then there are faults."""

    name: str
    faults: list[Fault] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    result: event.Result | None = None
    expectations: list[tuple[Condition, Any, bool]] = field(default_factory=list)
    snapshots: dict[str, bytes] = field(default_factory=dict)
    printed: str = ""
    """What the runtime's processes printed, where the run was aborted."""

    @property
    def state(self) -> str:
        """`refused`, `completed` or `aborted`."""
        if self.result is None:
            return "refused"
        return "completed" if self.result.completed else "aborted"

    @property
    def exit_code(self) -> int:
        """0: completed and every expectation holds; 1: aborted, or one does not hold; 2: refused."""
        if self.result is None:
            return 2
        return 0 if self.result.completed and all(holds for _, _, holds in self.expectations) else 1


class Watcher(Protocol):
    """Whoever watches a run."""

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """Everything is ready and the run begins now."""
        ...

    def happens(self, one: event.Event) -> None:
        """Something has happened."""
        ...

    def answer(self, asked: event.Asked) -> str | None:
        """The argument line for a task that asks; None where nobody answers."""
        ...


def run(settings: RunSettings, site: Site, watcher: Watcher) -> Outcome:
    """Run an application to its end. Ctrl-C stops it; a second one is a KeyboardInterrupt."""
    prepared = prepare_run(settings.name, site)
    outcome = Outcome(prepared.name, list(prepared.faults), [str(note) for note in prepared.notes])
    if prepared.plan is None:
        return outcome
    plan = _within(prepared.plan, settings.subsystems, outcome)
    try:
        with _runtime(settings, plan) as runtime:
            _prepare(prepared, plan, runtime, outcome)
            outcome.faults += _unheard_of(settings.expectations, plan)
            if not outcome.faults:
                watcher.begins(prepared, runtime.pid)
                _carry_out(settings, plan, runtime, watcher, outcome)
    except (LinkLost, TimeoutError) as lost:
        outcome.result = _aborted(str(lost), plan)
    return outcome


def _within(plan: Plan, names: tuple[str, ...], outcome: Outcome) -> Plan:
    """The plan in subsystems of these names; none: of its own."""
    if not names:
        return plan
    if len(set(names)) != len(plan.flows):
        expected = f"{len(plan.flows)} different names, one for each flow"
        outcome.faults.append(Fault(Place("--subsystem"), expected, " ".join(names), "nothing is run"))
        return plan
    flows = (structs.replace(flow, subsystem=name) for flow, name in zip(plan.flows, names, strict=True))
    return structs.replace(plan, flows=tuple(flows))


def _runtime(settings: RunSettings, plan: Plan) -> Runtime | Reached:
    if settings.elsewhere is not None:
        return connect(settings.elsewhere.url, settings.elsewhere.token, settings.elsewhere.ca)
    options = () if settings.scale is None else ("--scale", f"{settings.scale:g}")
    return Runtime(rtpus_of(plan), settings.is_virtual, settings.with_fifo, options)


def _prepare(prepared: PreparedRun, plan: Plan, runtime: Conversation, outcome: Outcome) -> None:
    answer = runtime.ask(request.Prepare(plan, prepared.targets))
    if isinstance(answer, request.Prepared):
        outcome.faults += [fault for fault in map(_fault, answer.faults) if fault not in outcome.faults]
        outcome.notes += answer.notes
    elif isinstance(answer, request.Refused):
        outcome.faults.append(Fault(Place("the runtime"), "a plan that it takes", answer.reason, "nothing is run"))


def _carry_out(settings: RunSettings, plan: Plan, runtime: Conversation, watcher: Watcher, outcome: Outcome) -> None:
    outcome.result = _follow(settings, plan, runtime, watcher)
    outcome.printed = "" if outcome.result.completed else runtime.printed()
    values = outcome.result.values
    outcome.expectations = [(one, one.found(values), one.holds(values)) for one in settings.expectations]
    if settings.wants_picture:
        outcome.snapshots = _snapshots(runtime)


def _follow(settings: RunSettings, plan: Plan, runtime: Conversation, watcher: Watcher) -> event.Result:
    watch = tuple(dict.fromkeys(one.address for one in settings.expectations))
    begin = request.Begin(watch, settings.settle_s, settings.seed, settings.answers, settings.may_ask, settings.on_loss)
    done = 0
    try:
        answer = runtime.ask(begin)
        if isinstance(answer, request.Refused):
            return _aborted(answer.reason, plan)
        with Interruption() as interruption:
            while True:
                if interruption.is_new():
                    runtime.ask(request.Stop("stopped by the user (Ctrl-C)"))
                for one in runtime.events(_LOOK_S):
                    watcher.happens(one)
                    done += isinstance(one, event.Done)
                    if isinstance(one, event.Result):
                        return one
                    if isinstance(one, event.Asked):
                        with interruption.at_once():
                            runtime.ask(_answer(one, watcher.answer(one)))
    except (LinkLost, TimeoutError) as lost:
        return _aborted(str(lost), plan, done)


def _answer(asked: event.Asked, line: str | None) -> request.Request:
    if line is None:
        return request.Abort(f"task {asked.task} asks for input and nobody answers")
    return request.Reply(asked.subsystem, asked.task, line)


def _snapshots(runtime: Conversation) -> dict[str, bytes]:
    try:
        answer = runtime.ask(request.Snapshot())
    except (LinkLost, TimeoutError):
        return {}
    return answer.snapshots if isinstance(answer, request.Worlds) else {}


def _aborted(cause: str, plan: Plan, done: int = 0) -> event.Result:
    """What the environment knows of a run whose runtime can say nothing any more (E10)."""
    return event.Result(False, cause, done, sum(len(flow.actions) for flow in plan.flows), 0.0, 0.0, {}, (), "")


def _unheard_of(expectations: tuple[Condition, ...], plan: Plan) -> list[Fault]:
    """Expectations of variables that no task of the plan reads or writes."""
    known = {
        f"{flow.subsystem}/{svar}"
        for flow in plan.flows
        for task in flow.tasks
        for svar in resolve(task.inconst + task.outconst + task.invar + task.outvar, dict(task.aliases))
    }
    names = known | {address.partition("/")[2] for address in known}
    return [
        Fault(Place("--expect"), "a variable that some task reads or writes", one.address, "nothing is run")
        for one in expectations
        if one.address not in names
    ]


def _fault(text: request.FaultText) -> Fault:
    return Fault(Place(text.file, text.line), text.expected, text.found, text.instead)
