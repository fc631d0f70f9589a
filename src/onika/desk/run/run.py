"""Runs an application: prepares it, launches a runtime, follows and steers it (requirements E03, E07, E14)."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

from onika.desk.plan.compile import rtpus_of
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.flow_worlds import worlds_by_flow
from onika.desk.plan.known_worlds import with_worlds
from onika.desk.plan.preparation import PreparedRun, prepare_run
from onika.desk.plan.substitutes import with_substitutes
from onika.desk.plan.subsystem_renaming import chiefs, rehoused
from onika.desk.plan.varied import varied
from onika.desk.plan.world_causes import with_causes
from onika.desk.run import steering_script
from onika.desk.run.interruption import Interruption
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.outcome import Outcome
from onika.desk.run.running_application import Running
from onika.desk.run.runtime_conversation import RunRuntime, RuntimeConversation
from onika.desk.run.script_player import ScriptPlayer
from onika.desk.run.settings import RecordingSource, RunSettings
from onika.desk.run.steering_script import ScriptLine
from onika.desk.run.world_text import drive_lines
from onika.link.child.launcher import RuntimeStart
from onika.link.lost import LinkLost
from onika.model.redirect import Redirect
from onika.store.repeated_names import folded
from onika.store.site import Site
from onika.wire import event, live, request
from onika.wire.plan import Plan
from onika.wire.runtime_standing import Standing
from onika.wire.steer import Position
from onika.wire.world_values import WorldValues, options_of
from onika.words.cause import causes_first
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

if TYPE_CHECKING:
    from onika.desk.run.recorded_run import RecordedRun
    from onika.desk.run.remote_runtime import RemoteRuntime

_RECORD = Place("--record")
_AT = Place("--at")
Opens = Callable[[Plan, WorldValues], AbstractContextManager[RunRuntime]]
"""What gives the runtime for a plan, and for what is otherwise in its worlds."""
_LOOK_S = 0.05
"""How long a Ctrl-C, or a key, waits at most."""


class RunWatcher(Protocol):
    """Whoever watches a run."""

    @property
    def can_steer(self) -> bool:
        """Whether somebody is there who could go on after a pause or an error."""
        ...

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """Everything is ready and the run begins now."""
        ...

    def happens(self, message: event.Event) -> None:
        """Something has happened."""
        ...

    def answer(self, question: event.Asked) -> str | None:
        """The argument line for a task that asks; None where nobody answers."""
        ...

    def wishes(self) -> Sequence[str]:
        """The lines of steering that are wanted now (`desk.run.steering`)."""
        ...

    def looks(self) -> bool:
        """Whether to look now where the flows are."""
        ...

    def placed(self, positions: tuple[Position, ...]) -> None:
        """Where the flows are, for who looks."""
        ...

    def steered(self, line: str, faults: tuple[Fault, ...], positions: tuple[Position, ...]) -> None:
        """A line was carried out, or why not; the positions where it asked for them."""
        ...


class NotRun(ValueError):
    """An application is refused; `faults` are the reasons, all of them."""

    def __init__(self, faults: Sequence[Fault]) -> None:
        super().__init__("; ".join(map(str, faults)))
        self.faults = tuple(faults)


@contextmanager
def start(settings: RunSettings, site: Site) -> Iterator[Running]:
    """Begin an application, to be steered from a program; a run that goes on at the end of the block is aborted.

    Raises ValueError with every fault where it is refused, LinkLost or TimeoutError where there is no runtime.
    """
    with _started(settings, site, None) as running:
        yield running


@contextmanager
def start_on(
    runtime_for: Callable[[Plan, WorldValues], RuntimeConversation],
    settings: RunSettings,
    site: Site,
    prepared: PreparedRun | None = None,
) -> Iterator[Running]:
    """As `start`, on a runtime that is there and stays; it is asked for when the plan is known.

    prepared   the application, where it was prepared for an earlier run
    """

    @contextmanager
    def stays(plan: Plan, values: WorldValues) -> Iterator[RuntimeConversation]:
        yield runtime_for(plan, values)

    with _started(settings, site, stays, prepared) as running:
        yield running


@contextmanager
def _started(
    settings: RunSettings, site: Site, opens: Opens | None, prepared: PreparedRun | None = None
) -> Iterator[Running]:
    outcome = Outcome(settings.name)
    with _open(settings, site, outcome, settings.is_virtual, opens, prepared) as opened:
        if opened is None:
            raise NotRun(outcome.faults)
        running, _ = opened
        running.begin()
        try:
            yield running
        finally:
            running.close()


def run(
    settings: RunSettings,
    site: Site,
    watcher: RunWatcher,
    opens: Opens | None = None,
    start: RuntimeStart | None = None,
) -> Outcome:
    """Run an application to its end. Ctrl-C stops it, and loses no result; a second one is a KeyboardInterrupt.

    opens   what it runs on; None: the runtime that the settings name, or one that is launched for it
    start   the one that is launched for it, where it comes up already; whoever began it closes it
    """
    outcome = Outcome(settings.name)
    is_held = settings.is_virtual and settings.script is not None
    interruption = Interruption()
    try:
        with ExitStack() as ending:
            ending.push(interruption)  # entered when the run begins: before that, Ctrl-C has nothing to stop
            opened = ending.enter_context(_open(settings, site, outcome, is_held, opens, start=start))
            if opened is not None:
                running, script_lines = opened
                watcher.begins(running.prepared, running.pid)
                _follow(running, ScriptPlayer(running, script_lines, watcher.steered), watcher, interruption)
                running.close()
    except (LinkLost, TimeoutError) as lost:
        outcome.result = event.Result(False, reason_of(lost), 0, outcome.actions, 0.0, 0.0, {}, (), "")
    return outcome


@contextmanager
def _open(
    settings: RunSettings,
    site: Site,
    outcome: Outcome,
    is_held: bool,
    opens: Opens | None = None,
    ready: PreparedRun | None = None,
    start: RuntimeStart | None = None,
) -> Iterator[tuple[Running, tuple[ScriptLine, ...]] | None]:
    """A run that is ready to begin, and its script; None where there are faults."""
    prepared, recorded = _prepared(settings, site, outcome, ready)
    if prepared is None or prepared.plan is None:
        yield None
        return
    plan, world_values, faults = varied(_within(prepared.plan, settings.subsystems, outcome), settings.values)
    outcome.faults += faults
    prepared = replace(prepared, plan=plan)
    outcome.actions = sum(len(flow.actions) for flow in plan.flows)
    script_lines: tuple[ScriptLine, ...] = ()
    if settings.script is not None:
        script_lines, script_faults = steering_script.load(settings.script, FlowIndex.of(plan))
        outcome.faults += script_faults
    unfit = (*_unrecorded(settings), *_misplaced(settings, plan))
    if unfit:
        outcome.faults += unfit
        yield None
        return
    opened = _runtime(settings, plan, world_values, recorded, start) if opens is None else opens(plan, world_values)
    with opened as runtime:
        _prepare(prepared, plan, runtime, outcome)
        outcome.faults = with_causes(with_worlds(outcome.faults, site), site)
        outcome.faults = with_substitutes(outcome.faults, prepared, _by_number(settings), site)
        outcome.faults = causes_first((*outcome.faults, *_unheard_of(settings.expectations, plan)))
        if outcome.faults:
            yield None
        else:
            can_hold = is_held and (settings.elsewhere is None or _is_virtual(runtime))
            yield Running(settings, prepared, plan, runtime, outcome, is_held=can_hold, recorded=recorded), script_lines


def _prepared(
    settings: RunSettings, site: Site, outcome: Outcome, ready: PreparedRun | None
) -> "tuple[PreparedRun | None, RecordedRun | None]":
    """What is to be run, from files or from a recording; the outcome is told what is wrong and worth knowing."""
    recorded = None
    if settings.source is not None:
        recorded = _recorded(settings.source, outcome)
        if recorded is None:
            return None, None
    prepared = ready if recorded is None else recorded.prepared
    if prepared is None:
        prepared = prepare_run(settings.name, site, _by_number(settings))
    outcome.name = prepared.name
    outcome.faults += prepared.faults
    outcome.notes += [note.sentence for note in folded(prepared.notes)]
    return prepared, recorded


def _recorded(source: RecordingSource, outcome: Outcome) -> "RecordedRun | None":
    """The run to be repeated; None where it cannot be, and the outcome is told why."""
    from onika.desk.run.recorded_run import RecordedRun, recorded_run  # within: recordings take long to load

    recorded = recorded_run(source)
    if isinstance(recorded, RecordedRun):
        outcome.notes += recorded.notes
        return recorded
    outcome.name = source.path.name
    outcome.faults += recorded
    return None


def _follow(running: Running, player: ScriptPlayer, watcher: RunWatcher, interruption: Interruption) -> None:
    """Listen, answer, steer, until the result is there."""
    try:
        running.begin()
        interruption.__enter__()  # left where everything is ended
        while not running.is_over:
            _turn(running, player, watcher, interruption)
        while player.go_on():
            pass
    except (LinkLost, TimeoutError) as lost:
        running.lose(reason_of(lost))


def _turn(running: Running, player: ScriptPlayer, watcher: RunWatcher, interruption: Interruption) -> None:
    if interruption.is_new():
        running.stop(Reason.of("desk.stopped_by_user"))
    _hear(running, watcher, interruption, _LOOK_S)
    while player.go_on():
        _hear(running, watcher, interruption, 0.0)
    for line in watcher.wishes():
        faults = running.steer(line, at_once=True)
        is_look = line.split()[:1] == ["who"] and not faults
        watcher.steered(line, faults, running.who() if is_look else ())
    if not running.is_over and watcher.looks():
        watcher.placed(running.who())
    if player.is_over and not watcher.can_steer and not running.is_over and running.is_stuck():
        running.abort(Reason.of("desk.nobody_goes_on", flows=running.flow_tracker.standing()))
    running.go_on(player.until_s)


def _hear(running: Running, watcher: RunWatcher, interruption: Interruption, timeout_s: float) -> None:
    for message in running.hear(timeout_s):
        watcher.happens(message)
        if isinstance(message, event.Asked):
            with interruption.at_once():
                running.answer(message, watcher.answer(message))


def _within(plan: Plan, names: tuple[str, ...], outcome: Outcome) -> Plan:
    """The plan in subsystems of these names, one for each flow that is not nested; none: of its own."""
    if not names:
        return plan
    chief = chiefs(plan)
    if len(set(names)) != len(chief):
        outcome.faults.append(
            Fault(
                Place("--subsystem"),
                Reason.of("desk.flows_by_name", count=len(chief), names=" ".join(names)),
                Reason.of("words.nothing_run"),
            )
        )
        return plan
    return rehoused(plan, dict(zip(chief, names, strict=False)))


def _by_number(settings: RunSettings) -> tuple[Redirect, ...]:
    """Redirections whose flows are called by the names that they are given here."""
    numbers = {name: str(number) for number, name in enumerate(settings.subsystems)}
    return tuple(replace(redirect, flow=numbers.get(redirect.flow, redirect.flow)) for redirect in settings.redirects)


def _unrecorded(settings: RunSettings) -> tuple[Fault, ...]:
    """Why no recording can be made there."""
    if settings.record is None or settings.elsewhere is None:
        return ()
    return (
        Fault(_RECORD, Reason.of("desk.runtime_elsewhere", url=settings.elsewhere.url), Reason.of("words.nothing_run")),
    )


def _misplaced(settings: RunSettings, plan: Plan) -> list[Fault]:
    """What is wrong with where flows are to run."""
    if not settings.places:
        return []
    flows, named = chiefs(plan), [flow for flow, _ in settings.places]
    locations = {location for _, location in settings.places}
    if sorted(named) == sorted(flows) and len(locations) > 1 and not settings.is_virtual:
        return []
    reason = Reason.of("desk.flows_at", flows=flows, named=tuple(named))
    return [Fault(_AT, reason, Reason.of("words.nothing_run"))]


def _runtime(
    settings: RunSettings,
    plan: Plan,
    values: WorldValues,
    recorded: "RecordedRun | None",
    start: RuntimeStart | None,
) -> "LaunchedRuntime | RemoteRuntime":
    if recorded is not None:
        return LaunchedRuntime(recorded.run.rtpus, True, False, recorded.run.options, False, start)
    if settings.elsewhere is not None:
        from onika.desk.run.remote_runtime import connect  # within: it brings along all that speaks to other machines

        return connect(settings.elsewhere.url, settings.elsewhere.token, settings.elsewhere.ca)
    scale = () if settings.scale is None else ("--scale", f"{settings.scale:.15g}")
    options = (*scale, *options_of(settings.shake, values))
    return LaunchedRuntime(
        rtpus_of(plan), settings.is_virtual, settings.with_fifo, options, settings.has_black_box, start
    )


def _is_virtual(runtime: RunRuntime) -> bool:
    answer = runtime.ask(live.Survey())
    return isinstance(answer, Standing) and answer.is_virtual


def _prepare(prepared: PreparedRun, plan: Plan, runtime: RunRuntime, outcome: Outcome) -> None:
    answer = runtime.ask(request.Prepare(plan, prepared.targets))
    if isinstance(answer, request.Prepared):
        outcome.faults += [text.fault for text in answer.faults if text.fault not in outcome.faults]
        outcome.notes += answer.notes
        outcome.notes += drive_lines(worlds_by_flow(plan), answer.worlds)
    elif isinstance(answer, request.Refused):
        outcome.faults.append(
            Fault(
                Place("runtime"), Reason.of("desk.plan_refused", reason=answer.reason), Reason.of("words.nothing_run")
            )
        )


def _unheard_of(expectations: tuple[Condition, ...], plan: Plan) -> list[Fault]:
    """Expectations of variables that no task of the plan reads or writes."""
    flow_index, faults = FlowIndex.of(plan), []
    for expectation in expectations:
        try:
            flow_index.home(expectation.address)
        except ValueError:
            faults.append(
                Fault(
                    Place("--expect"),
                    Reason.of("desk.variable_unknown", address=expectation.address),
                    Reason.of("words.nothing_run"),
                )
            )
    return faults
