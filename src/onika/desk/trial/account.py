"""An account of a run in virtual time: its actions, their durations, and the values of variables after each."""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import msgspec
from msgspec.structs import replace

from onika.desk.run.run import NotRun, start
from onika.desk.run.running_application import Running
from onika.desk.run.settings import RunSettings
from onika.desk.trial.variables import KeptVariable, kept_after, robots
from onika.link.lost import LinkLost
from onika.model.kept import KeptMeeting
from onika.store.site import Site
from onika.wire import event
from onika.wire.plan import Plan
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason, reason_of

LONGEST_S = 86_400.0
"""How much virtual time a run may take where nothing else is said."""

_LOOK_S = 0.05

Elements = dict[str, tuple[float, ...]]
"""Values by address; one whose elements have different units is there element by element."""


@dataclass(slots=True)
class CompletedAction:
    """An action that was carried out, and what was so when it had ended."""

    name: str
    began_s: float
    ended_s: float
    variables: tuple[KeptVariable, ...] = ()
    values: Elements = field(default_factory=dict)


@dataclass(slots=True)
class FlowAccount:
    """What happened on one subsystem; `current` is the action that goes on."""

    subsystem: str
    robots: tuple[tuple[str, str], ...]
    passed: list[CompletedAction] = field(default_factory=list)
    at_end: Elements = field(default_factory=dict)
    current: CompletedAction | None = None


@dataclass(slots=True)
class RunAccount:
    """What happened in a run. `cause` says why it did not come to its end, empty: it did; `refusals` why none began."""

    digest: str = ""
    parts: list[FlowAccount] = field(default_factory=list)
    meetings: list[KeptMeeting] = field(default_factory=list)
    expectations: list[tuple[str, Any, bool]] = field(default_factory=list)
    warnings: list[Reason] = field(default_factory=list)
    cause: Reason = NOTHING
    refusals: tuple[Fault, ...] = ()
    lasted_s: float = 0.0
    hash: str = ""


def give_account(settings: RunSettings, site: Site, limit_s: float = LONGEST_S) -> RunAccount:
    """Run an application in virtual time and look at it after each action; it is ended after so many seconds of it."""
    account = RunAccount()
    try:
        with start(settings, site) as running:
            _watch(running, account, limit_s)
            running.close()
            account.expectations = [(condition.text, *rest) for condition, *rest in running.outcome.expectations]
    except NotRun as refused:
        account.refusals, account.cause = refused.faults, Reason.of("trial.is_refused")
    except (LinkLost, TimeoutError) as lost:
        account.cause = account.cause or reason_of(lost)
    return account


def digest_of(plan: Plan) -> str:
    """Of everything that an application consists of, wherever its files lie."""
    flows = [
        replace(
            flow,
            tasks=tuple(replace(task, place="") for task in flow.tasks),
            actions=tuple(replace(action, place="", line=0, spot=()) for action in flow.actions),
        )
        for flow in plan.flows
    ]
    content = msgspec.msgpack.encode((flows, sorted(code.digest for code in plan.code)))
    return hashlib.sha256(content).hexdigest()[:16]


def timed_events(running: Running, limit_s: float) -> Iterator[event.Event]:
    """What happens, each time with the clock standing; ended where nothing goes on by itself, or not soon enough."""
    pending: list[event.Event] = []
    while not running.is_over:
        pending += running.hear(_LOOK_S)
        if not running.stands and not running.is_over:
            continue
        yield from pending
        pending = []
        if running.now_s >= limit_s:
            running.abort(Reason.of("desk.not_ended_after", seconds=limit_s))
        elif running.is_stuck():
            running.abort(Reason.of("desk.nobody_goes_on", flows=running.flow_tracker.standing()))
        running.go_on(limit_s)
    yield from (*pending, *running.hear())


def _watch(running: Running, account: RunAccount, limit_s: float) -> None:
    plan, sheets = running.plan, running.sheets()
    account.digest = digest_of(plan)
    account.parts = [FlowAccount(flow.subsystem, robots(flow, sheets)) for flow in plan.flows]
    kept: dict[tuple[int, int], tuple[KeptVariable, ...]] = {}
    for message in timed_events(running, limit_s):
        match message:
            case event.Began() if not plan.flows[message.flow].actions[message.index].is_noop:
                flow, place = plan.flows[message.flow], (message.flow, message.index)
                if place not in kept:
                    kept[place] = kept_after(flow, flow.actions[message.index], sheets)
                began = CompletedAction(message.action, message.at_s, message.at_s, kept[place])
                account.parts[message.flow].current = began
            case event.Done():
                _done(running, account.parts[message.flow], message.at_s)
            case _:
                _note(account, message)
    for part in account.parts:
        part.at_end = _read(running, part, measured(part))


def _note(account: RunAccount, message: event.Event) -> None:
    """What is noted of the run as a whole."""
    match message:
        case event.Met():
            account.meetings.append(KeptMeeting(message.tag.rpartition(" ")[2], message.subsystems))
        case event.Failed() | event.Warned() if message.task:
            flow, task, text = message.subsystem, message.task, message.text
            account.warnings.append(Reason.of("trial.warning", flow=flow, task=task, text=text))
        case event.Result():
            account.cause = NOTHING if message.completed else message.cause or Reason.of("trial.no_end")
            account.lasted_s, account.hash = message.runtime_s, message.hash


def measured(part: FlowAccount) -> tuple[KeptVariable, ...]:
    """The variables that were measured after any of the actions of a flow."""
    seen = {variable.name: variable for passed in part.passed for variable in passed.variables}
    return tuple(variable for variable in seen.values() if variable.is_measured)


def _done(running: Running, part: FlowAccount, at_s: float) -> None:
    passed, part.current = part.current, None
    if passed is not None:
        passed.ended_s = at_s
        passed.values = _read(running, part, passed.variables)
        part.passed.append(passed)


def _read(running: Running, part: FlowAccount, variables: tuple[KeptVariable, ...]) -> Elements:
    elements: Elements = {}
    for variable in variables:
        value = running.read(f"{part.subsystem}/{variable.name}")
        numbers = tuple(map(float, value if isinstance(value, list) else [value]))
        if len(variable.units) == 1:
            elements[variable.name] = numbers
        else:
            elements |= {f"{variable.name}[{at}]": (number,) for at, number in enumerate(numbers)}
    return elements
