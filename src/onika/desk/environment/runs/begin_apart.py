"""Beginning an application whose flows are carried out at several stations: each has its part, in one account (E12).

All are asked what there is, and to look at their part, before any begins. Where flows of several stations have a tag in
common, their runtimes learn of each other, and meet there by rendezvous (decision 56); then all flows begin together.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import Ask, AskAll, InterimModel, No, RequiredRuntime, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import PartsRecorder
from onika.desk.environment.reconcile import run_reducer
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.station_names import called
from onika.desk.environment.run_state.run import Run, RunPart
from onika.desk.environment.runs import beside, flow_placement, recording
from onika.desk.environment.runs.obstacles import obstacles
from onika.desk.environment.runs.readiness_refusal import refused_by_runtime
from onika.desk.environment.runs.run_start import RunStart, aborts
from onika.desk.environment.state.model import Model
from onika.desk.joined import meeting_links
from onika.desk.plan.plan_part import flows_of, part_of
from onika.desk.plan.plan_parts import BEGIN, PlanPart, parts_of, shared_tags
from onika.desk.plan.subsystem_renaming import rehoused
from onika.desk.run.runtime_conversation import in_short
from onika.link.starting.runtime_address import address_of
from onika.wire import live, request
from onika.wire.plan import Plan
from onika.wire.rendezvous_link import MeetingTerms
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason

_HERE = "127.0.0.1"


def begun(model: Model, start: RunStart, recorder: PartsRecorder | None) -> Steps[tuple[Model, No | None]]:
    """Have every station begin its part; or why none does. Where one cannot, what has begun is ended."""
    model, refused = yield from _begun(model, start, recorder)
    if refused is not None and recorder is not None and model.run is not None:
        recorder.forget(model.run)
    return model, refused


def _begun(model: Model, start: RunStart, recorder: PartsRecorder | None) -> Steps[tuple[Model, No | None]]:
    model = model.at("").making_room()
    parts = _parts(start.plan, start.stations)
    model = replace(model, run=_shown(model, start, parts))
    homes: dict[str, str] = {}
    for part in parts:
        model, free = yield from _looked(model.at(part.station), start, part)
        if isinstance(free, No):
            return model.at(""), free
        homes |= free
    start = replace(start, plan=rehoused(start.plan, homes))
    model = replace(model.at(""), run=_shown(model, start, parts))
    plans = _planned(start, parts)
    for part, planned in zip(parts, plans, strict=True):
        wish = request.Prepare(planned.plan, planned.targets(start.targets))
        model, response = yield Ask(model.at(part.station), wish)
        if not isinstance(response, request.Prepared) or response.faults:
            return model.at(""), refused_by_runtime(start.troubles, response)
    if start.record and model.run is not None:
        if recorder is None:
            return model.at(""), recording.without(Reason.of("run.record_no_folder"), start.command)
        unrecorded = recorder.begin(model.run, request.Prepare(start.plan, start.targets), _wish(start, None))
        if unrecorded:
            return model.at(""), recording.without(unrecorded, start.command)
    if not shared_tags(plans):
        return (yield from _begin(model, start, parts, None))
    model, terms = yield from _linked(model, parts, plans)
    if isinstance(terms, Reason):
        return model.at(""), No(Reason.of("run.does_not_run", name=start.name, why=terms), start.together)
    if model.run is not None:
        titles = [called(part.station) for part in parts]
        model = replace(model, run=model.run.noted(meeting_links.note(terms, titles)))
    return (yield from _begin(model, start, parts, terms))


def _linked(
    model: Model, parts: tuple[RunPart, ...], plans: Sequence[PlanPart]
) -> Steps[tuple[Model, MeetingTerms | Reason]]:
    """Have the runtimes learn of each other: the terms on which they meet, or why they cannot."""
    stations = [part.station for part in parts]
    hosts = [_host(model.at(station)) for station in stations]
    steps = meeting_links.linking(plans, [str(called(station)) for station in stations], hosts)
    requests = next(steps)
    while True:
        wishes = tuple(zip(stations, requests, strict=True))
        model, responses = yield AskAll(model.at(""), wishes)
        try:
            requests = steps.send(responses)
        except StopIteration as end:
            return model, end.value


def _planned(start: RunStart, parts: tuple[RunPart, ...]) -> Sequence[PlanPart]:
    """The plan of each part; where some would wait for others, all begin at a tag of their own."""
    sites = {start.plan.flows[flow].subsystem: site for site, part in enumerate(parts) for flow in part.flows}
    plans = parts_of(start.plan, sites)
    if any(shared.tag != BEGIN for shared in shared_tags(plans)):
        return plans
    return [PlanPart(part_of(start.plan, part.flows), part.flows) for part in parts]


def _host(model: Model) -> str:
    """Where the runtime of the station in focus is; one that was started here is on this machine."""
    url = model.runtime.address
    return address_of(url).host if url else _HERE


def _begin(
    model: Model, start: RunStart, parts: tuple[RunPart, ...], terms: MeetingTerms | None
) -> Steps[tuple[Model, No | None]]:
    for number, part in enumerate(parts):
        model, response = yield Ask(model.at(part.station), _wish(start, terms))
        if isinstance(response, request.Done):
            continue
        why = Reason.of("run.what_why", what=called(part.station), why=refusal(response))
        ends = aborts(model.run)[:number] if model.run is not None else ()
        for before, end in zip(parts, ends, strict=False):
            model, _ = yield Ask(model.at(before.station), end)
        return model.at(""), No(Reason.of("run.does_not_run", name=start.name, why=why))
    looks = tuple(run_reducer.look().at(part.station) for part in parts)
    model, _ = yield InterimModel(model.at(""), orders=looks)
    return model, None


def _wish(start: RunStart, terms: MeetingTerms | None) -> request.Begin:
    return request.Begin(may_ask=True, on_error="wait", on_loss=start.command.on_loss, meets=terms)


def _looked(model: Model, start: RunStart, part: RunPart) -> Steps[tuple[Model, dict[str, str] | No]]:
    """Subsystems at the station in focus that nobody else has, for the flows there; or what speaks against them."""
    if model.runtime.state != "linked":
        model = replace(model, runtime=flow_placement.starting(model.runtime))
    model, standing = yield Ask(model, live.Survey(), RequiredRuntime(model.runtime.address))
    if not isinstance(standing, Standing):
        why = refusal(standing)
        unreached = Reason.of("run.what_why", what=called(part.station), why=in_short(why))
        return flow_placement.lost(model, why), No(Reason.of("run.no_runtime", why=unreached))
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    plan = part_of(start.plan, part.flows)
    refused = flow_placement.refused(model, plan) or beside.refused(model, standing, plan, start.name)
    if refused is not None:
        return model, refused
    hindering = obstacles(model, standing, plan)
    if hindering:
        named = tuple(obstacle.named for obstacle in hindering)
        reason = Reason.of("run.in_the_way_at", station=called(part.station), obstacles=named)
        return model, No(reason)
    living = {subsystem.name for subsystem in standing.subsystems if subsystem.tasks or subsystem.application}
    return model, flow_placement.free(model, plan, living)


def _parts(plan: Plan, stations: Mapping[str, str]) -> tuple[RunPart, ...]:
    names = dict.fromkeys(stations.values())
    homes = {name: [home for home, station in stations.items() if station == name] for name in names}
    return tuple(RunPart(name, flows_of(plan, homes[name])) for name in names)


def _shown(model: Model, start: RunStart, parts: tuple[RunPart, ...]) -> Run:
    run = replace(start.run(model), parts=parts)
    flows = {name: structs.replace(flow, station=run.station_of(name)) for name, flow in run.view.flows.items()}
    return run.shown(flows=flows)
