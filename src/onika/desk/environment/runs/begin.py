"""Running an application from here: everything that speaks against it is told before anything moves (E01, E12).

What is open is prepared as it is shown. Then the runtime is asked, one thing after the other: what there is; to end
what stands in the way, if the user wants it; to check the plan; to begin. The act is answered when the run has begun.
"""

from dataclasses import replace
from pathlib import Path

from onika.desk.environment.control.held_subsystems import run_here
from onika.desk.environment.outcome.fault_view import FaultViews, place_of
from onika.desk.environment.outcome.on_file import closed
from onika.desk.environment.outcome.outcome import (
    Ask,
    AwaitedNews,
    Done,
    EditEnd,
    InterimModel,
    No,
    Order,
    Procedure,
    RequiredRuntime,
    RunEnd,
    Steps,
)
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.unread_faults import not_run
from onika.desk.environment.reconcile import putting_back, run_reducer
from onika.desk.environment.reconcile.descriptions import describe
from onika.desk.environment.reconcile.following import given_up
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.messages import IconWording
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.runs import (
    begin_apart,
    beside,
    flow_placement,
    flow_stations,
    going_on,
    put_back,
    puzzle_run,
    recording,
    takeover,
    unit_choice,
    unsaved,
)
from onika.desk.environment.runs.obstacles import documents_in_the_way, obstacles
from onika.desk.environment.runs.preflight_result import looked, worth_noting
from onika.desk.environment.runs.readiness_refusal import refused, refused_by_runtime
from onika.desk.environment.runs.run_start import RunStart, aborts
from onika.desk.environment.runs.unsaved import Changed
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.desk.plan.preparation import PreparedRun, prepare
from onika.desk.plan.subsystem_renaming import rehoused
from onika.desk.run.runtime_conversation import in_short
from onika.model.application import with_numbers_as_lines
from onika.model.syntax import Syntax
from onika.store.site import Site
from onika.wire import act, live, page, request, steer
from onika.wire.request import TargetValues
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason


def run(model: Model, command: act.Run, outside: Services) -> Procedure:
    """Run an application as it is here; the value is the number of the run."""
    if command.ends_former:
        model, refused_ = yield from _without_former(model, command.doc)
        if refused_ is not None:
            return refused_
    before = model
    begun_with = _start(model, command, outside)
    if isinstance(begun_with, No):
        return begun_with
    model, start = begun_with
    beginning = begin_apart.begun(model, start, outside.recorder) if start.stations else _begun(model, start)
    model, refused_ = yield from beginning
    if refused_ is not None:
        back = putting_back.due(_without_it(model, before))  # it does not run: what was there before comes back
        yield InterimModel(back.model, orders=back.orders)
        return refused_
    if model.run is None:
        return Done(model)
    run = model.run if model.run.is_over else model.run.shown(state="running")
    says = (page.Say("info", Reason.of("run.runs", name=start.name), command.doc),)
    described = describe(replace(model, run=run, performed=model.performed + 1))  # what tasks ask can be prefilled then
    orders = (*_said_before(run), run_reducer.look(), *described.orders)
    return Done(described.model, value=run.view.number, says=says, orders=orders)


def _said_before(run: Run) -> tuple[Order, ...]:
    """What the user has said of it before it had begun."""
    if run.is_given_up:
        return tuple(Order(wish, station=run.station_of(wish.subsystem)) for wish in aborts(run))
    if not run.is_to_pause:
        return ()
    return tuple(Order(steer.Pause(home), station=run.station_of(home)) for home in run.homes)


def _without_former(model: Model, doc: str) -> Steps[tuple[Model, No | None]]:
    """End the run of an application that goes on, and wait until it is over."""
    run = next((run for run in model.going if run.doc == doc and run.view.state != "beginning"), None)
    if run is None:
        return model, None
    for wish in aborts(run):
        model, response = yield Ask(model.at(run.station_of(wish.subsystem)), wish)
    if any(other.view.number == run.view.number for other in model.going):
        if not isinstance(response, request.Done):
            return model, No(refusal(response))
        model, _ = yield AwaitedNews(model, RunEnd(run.view.number))
    return model, None


def _start(model: Model, command: act.Run, outside: Services) -> tuple[Model, RunStart] | No:
    """What is to be begun, with everything saved that it uses; or all that speaks against it here."""
    opened = model.applications.get(command.doc)
    if opened is None:
        return closed(DocumentKind.APPLICATION)
    syntax = model.syntax
    busy = _busy(model, opened)
    if busy is not None:
        return busy
    if syntax is None:
        return No(Reason.of("run.no_icon_types"))
    unread = not_run(opened)
    if unread is not None:
        return unread
    prepared_here = _prepared_here(model, opened, command, outside, syntax)
    if isinstance(prepared_here, No):
        return prepared_here
    model, prepared, changed = prepared_here
    troubles = FaultViews.of(opened, syntax, prepared, outside.site)
    complaint = refused(opened, tuple(troubles.views(prepared)))
    if complaint is not None:
        return complaint
    if prepared.plan is None:
        return No(Reason.of("run.has_nothing", name=opened.name))
    is_unsaved = unsaved.refused(opened, changed, command)
    plan = going_on.placed(model, command, opened.name, prepared.plan)
    if isinstance(plan, No):
        return plan
    in_the_way = documents_in_the_way(model, plan)
    if is_unsaved is not None and (command.confirmed or not in_the_way):
        return is_unsaved
    stations = flow_stations.apart(opened, plan)
    file = recording.place(model, command, opened.name, outside, is_apart=bool(stations))
    if isinstance(file, No):
        return file
    return model, RunStart(
        command=command,
        name=opened.name,
        plan=plan,
        targets=prepared.targets,
        belonging=StepMembership.of(opened.application, syntax),
        wording=IconWording.of(place_of(opened), with_numbers_as_lines(opened.application), prepared.program, syntax),
        troubles=troubles,
        durations=durations(prepared.targets, syntax),
        notes=unsaved.other_files(model, prepared.places, prepared.program),
        began_at_s=outside.calendar(),
        record="" if file is None else str(file),
        changed=tuple(dict.fromkeys((*changed, *takeover.unsaved(in_the_way)))),
        unsaved=is_unsaved,
        stations=stations,
        together=flow_stations.together(opened, plan),
        puzzle=puzzle_run.puzzle_of(opened, outside.site),
        uncounted=puzzle_run.uncounted(opened, prepared.plan, command),
    )


def _prepared_here(
    model: Model, opened: OpenApplication, command: act.Run, outside: Services, syntax: Syntax
) -> tuple[Model, PreparedRun, tuple[Changed, ...]] | No:
    """The application as it runs, and what it uses that is not saved; where that is wanted, with all of it saved."""
    prepared = ready(opened, outside.site, syntax, passes_breakpoints=command.passes_breakpoints)
    changed = (*unsaved.used(unsaved.dirty(model), prepared.program), *unsaved.tasks(model, prepared.program))
    if not command.saves_unsaved:
        return model, prepared, changed
    taken = () if prepared.plan is None else takeover.unsaved(documents_in_the_way(model, prepared.plan))
    changed = tuple(dict.fromkeys((*changed, *taken)))
    if not changed:
        return model, prepared, changed
    saved = unsaved.saved(model, changed, outside)
    if isinstance(saved, No):
        return saved
    again = ready(opened, outside.site, syntax, passes_breakpoints=command.passes_breakpoints)
    return saved.model, again, ()


def _busy(model: Model, opened: OpenApplication) -> No | None:
    """Why it cannot run beside what runs: it runs itself, or something is not through its beginning."""
    for run in model.going:
        name, abort = run.view.name, Remedy(Reason.of("run.abort_it"), act.Steer("abort", run.doc))
        if run.doc == opened.id:
            return No(Reason.of("run.runs_already", name=name), (abort,))
        if run.view.state == "beginning" or run.view.repeats_until_s:
            return No(Reason.of("run.another_begins", name=name), (abort,))
    taken = run_here(model)
    if taken:
        other = model.runtime.holds[taken].application
        return No(Reason.of("run.taken_runs", name=other))
    return None


def ready(opened: OpenApplication, site: Site, syntax: Syntax, *, passes_breakpoints: bool = False) -> PreparedRun:
    """An application as it is here, judged and compiled; the lines in faults and plan are the numbers of its steps."""
    application = with_numbers_as_lines(opened.application)
    home = site if opened.base is None else site.at(Path(opened.base))
    return prepare(
        application, place_of(opened), home, syntax, passes_breakpoints=passes_breakpoints, redirects=opened.redirects
    )


def durations(targets: tuple[TargetValues, ...], syntax: Syntax) -> dict[tuple[int, int], float]:
    """What the targets of a plan say of how long their actions should take, in s, by flow and action."""
    durations: dict[tuple[int, int], float] = {}
    for target in targets:
        kind, at = syntax.find(target.kind), 0
        for item in kind.items if kind else ():
            value = target.values[at] if at < len(target.values) else 0.0
            if item.name.lower() == "duration" and not isinstance(value, str):
                durations[target.flow, target.action] = durations.get((target.flow, target.action), 0.0) + float(value)
            at += item.count
    return durations


def _without_it(model: Model, before: Model) -> Model:
    """The model where a run has not begun; those that went on meanwhile are as they are now."""
    now = {run.view.number: run for run in model.beside.values()}
    former = before.run and now.get(before.run.view.number, before.run)
    others = {number: now.get(number, run) for number, run in before.beside.items()}
    return replace(model, run=former, beside=others)


def _begun(model: Model, start: RunStart) -> Steps[tuple[Model, No | None]]:
    """Ask the runtime of this environment to begin; it is started where there is none."""
    url = model.runtime.address
    state = model.runtime if model.runtime.state == "linked" else flow_placement.starting(model.runtime)
    model = model.making_room()
    model = replace(model, run=start.run(model), runtime=state)
    model, standing = yield Ask(model, live.Survey(), RequiredRuntime(url))
    if not isinstance(standing, Standing):
        why = refusal(standing)
        return flow_placement.lost(model, why), No(Reason.of("run.no_runtime", why=in_short(why)))
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    placed = _placed(model, standing, start)
    if isinstance(placed, No):
        return model, placed
    start, ended = placed
    is_to_pause = model.run is not None and model.run.is_to_pause
    model = replace(model, run=replace(start.run(model), is_to_pause=is_to_pause))
    for subsystem in ended:
        model, refused_ = yield from _ended(model, start, subsystem)
        if refused_ is not None:
            return model, refused_
    if start.command.puts_back:
        model, refused_ = yield from put_back.before_run(model, start.plan, start.command)
        if refused_ is not None:
            return model, refused_
    model, response = yield Ask(model, request.Prepare(start.plan, start.targets))
    model, refused_ = _prepared(model, response, start)
    if refused_ is not None:
        return model, refused_
    watch = () if model.run is None or model.run.attempt is None else model.run.attempt.watch
    begin = request.Begin(watch, may_ask=True, on_error="wait", on_loss=start.command.on_loss, record=start.record)
    model, response = yield Ask(model, begin)
    return model, None if isinstance(response, request.Done) else _unbegun(start, refusal(response))


def _placed(model: Model, standing: Standing, start: RunStart) -> tuple[RunStart, tuple[str, ...]] | No:
    """The run in subsystems that nobody else has, and those that are to end first."""
    if _is_given_up(model):
        return _given_up(start)
    refused_ = flow_placement.refused(model, start.plan)
    refused_ = refused_ or beside.refused(model, standing, start.plan, start.name)
    refused_ = refused_ or unit_choice.question(model, start.plan, start.name, start.command)
    if refused_ is not None:
        return refused_
    obstructing = obstacles(model, standing, start.plan)
    if obstructing and not start.command.confirmed:
        return takeover.question(model, obstructing, start.name, start.plan, start.command, start.changed)
    wrong = takeover.in_a_switch(model, obstructing, start.command) if obstructing else start.unsaved
    if wrong is not None:
        return wrong
    gone = tuple(obstacle.subsystem for obstacle in obstructing)
    living = {subsystem.name for subsystem in standing.subsystems if subsystem.tasks or subsystem.application}
    living |= {home for run in model.beside.values() if run.station == model.station for home in run.homes}
    chosen = unit_choice.placed(start.plan, start.command)
    plan = rehoused(chosen, flow_placement.free(model, start.plan, living - set(gone)))
    return replace(start, plan=plan, notes=(*start.notes, *flow_placement.notes(model, plan))), gone


def _ended(model: Model, start: RunStart, subsystem: str) -> Steps[tuple[Model, No | None]]:
    """End what stands in the way, with all its tasks."""
    documents = model.documents_here.values()
    names = [document.name for document in documents if document.live and document.live.subsystem == subsystem]
    says = tuple(page.Say("info", Reason.of("run.taken_over_by", name=name, application=start.name)) for name in names)
    after = takeover.taken_over(model, subsystem, model.performed + 1, start.name)
    model, response = yield Ask(after, live.Close(subsystem), says=says, news=given_up(model, after))
    if not isinstance(response, live.Accepted):
        return model, No(refusal(response))
    if model.run is None:
        return model, No(Reason.of("run.given_up"))
    cause = model.run.outcomes.get(response.number)  # its outcome is told by an event, before or after this
    refused_ = No(cause) if cause else None
    if cause is None:
        awaiting = replace(model.run, awaits=response.number)
        model, refused_ = yield AwaitedNews(replace(model, run=awaiting), EditEnd(response.number, model.station))
    if refused_ is None and _is_given_up(model):
        refused_ = _given_up(start)
    return model, refused_


def _prepared(model: Model, response: request.Response, start: RunStart) -> tuple[Model, No | None]:
    """The runtime has looked at every module, argument line and target of the plan."""
    if isinstance(response, request.Prepared):
        model = looked(model, start.troubles, start.plan, response)
    if not isinstance(response, request.Prepared) or response.faults:
        return model, refused_by_runtime(start.troubles, response)
    if _is_given_up(model):
        return model, _given_up(start)
    if model.run is not None:
        for note in worth_noting(response):
            model = replace(model, run=model.run.noted(note))
    return model, None


def _unbegun(start: RunStart, why: Reason) -> No:
    """The runtime will not begin it, for its recording's sake or another's."""
    if start.record and isinstance(why, Reason) and why.key == "host.no_recording":
        return recording.without(why.args["why"], start.command)
    return No(Reason.of("run.does_not_run", name=start.name, why=why))


def _is_given_up(model: Model) -> bool:
    """Whether the user has said abort of a run that is about to begin."""
    return model.run is not None and model.run.is_given_up


def _given_up(start: RunStart) -> No:
    return No(Reason.of("run.aborted_before", name=start.name))
