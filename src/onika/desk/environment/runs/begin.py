"""Running an application from here: everything that speaks against it is told before anything moves (E01, E12).

What is open is prepared as it is shown. Then the runtime is asked, one thing after the other: what there is; to end
what stands in the way, if the user wants it; to check the plan; to begin. The act is answered when the run has begun.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import msgspec

from onika.desk.environment.control.held_subsystems import run_here
from onika.desk.environment.following import given_up
from onika.desk.environment.outcome.fault_view import Troubles, place_of
from onika.desk.environment.outcome.on_application import closed
from onika.desk.environment.outcome.outcome import Done, No, Order, Reach
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.outcome.unread_faults import not_run
from onika.desk.environment.reconcile.descriptions import describe
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.run_state.membership import Belonging
from onika.desk.environment.run_state.messages import Speech
from onika.desk.environment.run_state.run import Run, Wait, begun
from onika.desk.environment.runs import flow_placement, recording, run_reducer, unsaved
from onika.desk.environment.runs.obstacles import Obstacle, left, obstacles
from onika.desk.environment.runs.preflight_result import looked, worth_noting
from onika.desk.environment.runs.readiness_refusal import refused, refused_by_runtime
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.preparation import PreparedRun, prepare
from onika.desk.plan.subsystem_renaming import rehoused
from onika.desk.run.runtime import in_short
from onika.model.application import with_numbers_as_lines
from onika.model.syntax import Syntax
from onika.store.site import Site
from onika.wire import act, live, page, request
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.wire.view import Remedy

_END_THEM = "End them and run"
_NO_RECORDING = "no recording can be made"
_ABORT = Remedy("Abort it", act.Steer("abort"))


@dataclass(frozen=True, slots=True)
class _Start:
    """A run on its way: what is to be begun, and what there was to be seen before it."""

    asked: act.Run
    name: str
    plan: Plan
    targets: tuple[TargetValues, ...]
    belonging: Belonging
    speech: Speech
    troubles: Troubles
    durations: dict[tuple[int, int], float]
    notes: tuple[str, ...]
    former: Run | None
    began_at_s: float
    closes: tuple[str, ...] = ()
    """Subsystems that are to end first."""
    record: str = ""
    """The file of its recording; empty: none is made."""


def run(model: Model, asked: act.Run, outside: Surroundings) -> Done | No:
    """Run an application as it is here."""
    opened = model.applications.get(asked.doc)
    if opened is None:
        return closed()
    if model.run is not None and not model.run.is_over:
        return No(f"{model.run.view.name} runs already, and one application runs at a time", (_ABORT,))
    if run_here(model):
        other = model.runtime.holds[run_here(model)].application
        return No(f"{other}, which was taken over here, runs already, and one application runs at a time")
    syntax = model.syntax
    if syntax is None:
        return No("there is no syntax definition that can be read: nothing is known of the types of icons")
    unread = not_run(opened)
    if unread is not None:
        return unread
    prepared = ready(opened, outside.site, syntax, passes_breakpoints=asked.passes_breakpoints)
    changed = unsaved.used(unsaved.dirty(model), prepared.program)
    if changed and asked.saves_unsaved:
        saved = unsaved.saved(model, changed, outside)
        if isinstance(saved, No):
            return saved
        model, changed = saved.model, ()
        prepared = ready(opened, outside.site, syntax, passes_breakpoints=asked.passes_breakpoints)
    troubles = Troubles.of(opened, syntax, prepared, outside.site)
    complaint = refused(opened, tuple(troubles.views(prepared))) or unsaved.refused(opened, changed, asked)
    if complaint is not None:
        return complaint
    if prepared.plan is None:
        return No(f"{opened.name} has nothing to run")
    file = recording.place(model, asked, opened.name, outside)
    if isinstance(file, No):
        return file
    start = _Start(
        asked=asked,
        name=opened.name,
        plan=prepared.plan,
        targets=prepared.targets,
        belonging=Belonging.of(opened.application, syntax),
        speech=Speech.of(place_of(opened), with_numbers_as_lines(opened.application), prepared.program, syntax),
        troubles=troubles,
        durations=durations(prepared.targets, syntax),
        notes=(),
        former=model.run,
        began_at_s=outside.calendar(),
        record="" if file is None else str(file),
    )
    return _began(replace(model, run=_new(model, start)), start)


def ready(opened: OpenApplication, site: Site, syntax: Syntax, *, passes_breakpoints: bool = False) -> PreparedRun:
    """An application as it is here, judged and compiled; the lines in faults and plan are the numbers of its steps."""
    application = with_numbers_as_lines(opened.application)
    home = site if opened.base is None else site.at(Path(opened.base))
    return prepare(
        application, place_of(opened), home, syntax, passes_breakpoints=passes_breakpoints, redirects=opened.redirects
    )


def durations(targets: tuple[TargetValues, ...], syntax: Syntax) -> dict[tuple[int, int], float]:
    """What the targets of a plan say of how long their actions should take, in s, by flow and action."""
    found: dict[tuple[int, int], float] = {}
    for one in targets:
        kind, at = syntax.find(one.kind), 0
        for item in kind.items if kind else ():
            value = one.values[at] if at < len(one.values) else 0.0
            if item.name.lower() == "duration" and not isinstance(value, str):
                found[one.flow, one.action] = found.get((one.flow, one.action), 0.0) + float(value)
            at += item.count
    return found


def _new(model: Model, start: _Start) -> Run:
    run = begun(start.asked.doc, start.plan, model.performed + 1, start.began_at_s, start.belonging, start.speech)
    run = replace(run, durations=start.durations).shown(recording=start.record)
    for note in start.notes:
        run = run.noted(note)
    return run


def _began(model: Model, start: _Start) -> Done:
    """The runtime of this environment is asked what there is; it is started where there is none."""
    url = model.runtime.address
    state = model.runtime if model.runtime.state == "linked" else flow_placement.starting(model.runtime)
    then = partial(_surveyed, start=start)
    order = Order(live.Survey(), then, start.asked.doc, Reach(url))
    return Done(replace(model, runtime=state), orders=(order,), is_answered_later=True)


def _surveyed(model: Model, response: request.Response, start: _Start) -> Done | No:
    if not isinstance(response, live.Standing):
        return _off(
            flow_placement.lost(model, refusal(response)), start, No(f"no runtime: {in_short(refusal(response))}")
        )
    model = replace(model, runtime=runtime_view(model.runtime, response))
    if _is_given_up(model):
        return _off(model, start, _given_up(start))
    refused_ = flow_placement.refused(model, start.plan)
    if refused_ is not None:
        return _off(model, start, refused_)
    found = obstacles(model, response, start.plan)
    if found and not start.asked.confirmed:
        return _off(model, start, _in_the_way(found, start))
    gone = tuple(one.subsystem for one in found)
    taken = {one.name for one in response.subsystems if one.tasks or one.application} - set(gone)
    plan = rehoused(start.plan, flow_placement.free(model, start.plan, taken))
    notes = flow_placement.notes(model, plan)
    start = replace(start, plan=plan, notes=notes, closes=gone)
    return _close(replace(model, run=_new(model, start)), start)


def _in_the_way(found: Sequence[Obstacle], start: _Start) -> No:
    what = ", ".join(dict.fromkeys(one.document or f"subsystem {one.subsystem}" for one in found))
    has = "has" if len(found) == 1 else "have"
    reason = (
        f"{' and '.join(map(str, found))} live already, and {start.name} needs such tasks for itself. "
        f"{what} {has} to end first, with all tasks; nothing else ends"
    )
    return No(reason, (Remedy(_END_THEM, msgspec.structs.replace(start.asked, confirmed=True)),))


def _close(model: Model, start: _Start) -> Done | No:
    """What stands in the way is ended, one after the other; then the plan is checked."""
    if not start.closes:
        then = partial(_prepared, start=start)
        order = Order(request.Prepare(start.plan, start.targets), then, start.asked.doc)
        return Done(model, orders=(order,), is_answered_later=True)
    subsystem = start.closes[0]
    names = [one.name for one in model.documents.values() if one.live is not None and one.live.subsystem == subsystem]
    after = left(model, (subsystem,))
    says = [page.Say("info", f"{name} is no longer connected: its tasks end for {start.name}") for name in names]
    then = partial(_closing, start=replace(start, closes=start.closes[1:]))
    order = Order(live.Close(subsystem), then, start.asked.doc)
    return Done(after, orders=(order,), is_answered_later=True, says=tuple(says), replies=given_up(model, after))


def _closing(model: Model, response: request.Response, start: _Start) -> Done | No:
    """It is being ended; its outcome is told by an event, before or after this."""
    if not isinstance(response, live.Accepted):
        return _off(model, start, No(refusal(response)))
    if model.run is None:
        return _off(model, start, No("the run was given up"))
    kept = Order(live.Survey(), partial(_closed, start=start), start.asked.doc, is_kept=True)
    cause = model.run.outcomes.get(response.number)
    if cause is not None:
        answered: request.Response = request.Refused(cause) if cause else request.Done()
        return Done(model, orders=(kept,), is_answered_later=True, replies=((kept, answered),))
    waiting = replace(model.run, wait=Wait(kept, response.number))
    return Done(replace(model, run=waiting), orders=(kept,), is_answered_later=True)


def _closed(model: Model, response: request.Response, start: _Start) -> Done | No:
    if not isinstance(response, request.Done):
        return _off(model, start, No(refusal(response)))
    return _off(model, start, _given_up(start)) if _is_given_up(model) else _close(model, start)


def _prepared(model: Model, response: request.Response, start: _Start) -> Done | No:
    """The runtime has looked at every module, argument line and target of the plan."""
    if not isinstance(response, request.Prepared) or response.faults:
        if isinstance(response, request.Prepared):
            model = looked(model, start.troubles, start.plan, response)
        return _off(model, start, refused_by_runtime(start.troubles, response))
    if _is_given_up(model):
        return _off(model, start, _given_up(start))
    model = looked(model, start.troubles, start.plan, response)
    if model.run is not None:
        for note in worth_noting(response):
            model = replace(model, run=model.run.noted(note))
    asked = request.Begin(may_ask=True, on_error="wait", on_loss=start.asked.on_loss, record=start.record)
    then = partial(_running, start=start)
    return Done(model, orders=(Order(asked, then, start.asked.doc),), is_answered_later=True)


def _running(model: Model, response: request.Response, start: _Start) -> Done | No:
    if not isinstance(response, request.Done):
        return _off(model, start, _unbegun(start, refusal(response)))
    if model.run is None:
        return Done(model)
    run = model.run if model.run.is_over else model.run.shown(state="running")
    says = (page.Say("info", f"{start.name} runs", start.asked.doc),)
    described = describe(replace(model, run=run, performed=model.performed + 1))  # what tasks ask can be prefilled then
    end = (Order(request.Abort("aborted by the user"), doc=start.asked.doc, is_aside=True),)
    orders = (*(end if _is_given_up(model) else ()), run_reducer.look(), *described.orders)
    return Done(described.model, value=run.view.number, says=says, orders=orders)


def _unbegun(start: _Start, why: str) -> No:
    """The runtime will not begin it, for its recording's sake or another's."""
    if start.record and why.startswith(_NO_RECORDING):
        return recording.without(why.removeprefix(f"{_NO_RECORDING}: "), start.asked)
    return No(f"{start.name} does not run: {why}")


def _is_given_up(model: Model) -> bool:
    """Whether the user has said abort of a run that is about to begin."""
    return model.run is not None and model.run.is_given_up


def _given_up(start: _Start) -> No:
    return No(f"{start.name} was aborted before it had begun")


def _off(model: Model, start: _Start, why: No) -> No:
    """Nothing runs: what was shown before is shown again."""
    return replace(why, instead=Done(replace(model, run=start.former)))
