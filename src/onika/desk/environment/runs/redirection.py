"""Redirection from the page: who stands for whom in an application as long as it is open (E09, §5.9.1)."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.fault_text import said
from onika.desk.environment.outcome.on_file import on_application, on_resting_application, syntax_of
from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.world_kinds import with_kinds
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan import redirection, world_redirection
from onika.desk.plan.preparation import PreparedRun
from onika.desk.plan.redirection import RedirectableTask
from onika.desk.run.runtime_conversation import in_short
from onika.model.redirect import Redirect
from onika.model.rules.union import devices
from onika.store.library import open_libraries
from onika.wire import act, live
from onika.wire.runtime_standing import Standing
from onika.wire.view import CandidateView, SeatsView, SeatView, WorldSeatView
from onika.words.reason import Reason, reason_of


@on_resting_application
def redirect(model: Model, opened: OpenApplication, command: act.Redirect, outside: Services) -> Done | No:
    """Let a task stand for another one; refused with all reasons why it cannot."""
    wish = Redirect(command.old, command.new or command.old, command.flow)
    if wish.is_of_world:
        try:
            Redirect.parse(str(wish))
        except ValueError as wrong:
            return No(reason_of(wrong))
    is_split = bool(wish.home) and any(redirect.old == wish.old and not redirect.home for redirect in opened.redirects)
    before = ready(opened, outside.site, syntax_of(model)) if is_split else None
    others = tuple(_others(opened.redirects, wish, before))
    redirects = others if wish.new == wish.old else (*others, wish)
    prepared = ready(replace(opened, redirects=redirects), outside.site, syntax_of(model))
    if wish in redirects and prepared.plan is not None and prepared.program is not None:
        faults = list(redirection.faults((wish,), prepared.plan, prepared.program))
        if faults:
            reasons = tuple(map(said, faults))
            return No(Reason.of("run.cannot_stand_for", new=wish.new, old=wish.old, reasons=reasons))
    changed = replace(opened, redirects=redirects, judgement=None, marks={}, looked=None)
    return Done(model.with_application(changed))


def _others(redirects: tuple[Redirect, ...], wish: Redirect, prepared: PreparedRun | None) -> Iterator[Redirect]:
    """What holds besides: a wish for all flows ends those for single ones, and is meant for the others after one."""
    for redirect in redirects:
        if redirect.old != wish.old or (wish.home and redirect.home and redirect.home != wish.home):
            yield redirect
        elif prepared is not None and not redirect.home and prepared.plan is not None and prepared.program is not None:
            homes = redirection.homes_of(redirect, prepared.plan, prepared.program)
            yield from (replace(redirect, flow=home) for home in homes if home != wish.home)


@on_application
def seats(model: Model, opened: OpenApplication, command: act.Seats, outside: Services) -> Done | No:
    """Who could stand for whom; the value is a `view.SeatsView`."""
    prepared = ready(opened, outside.site, syntax_of(model))
    if prepared.plan is None or prepared.program is None:
        return No(Reason.of("run.has_nothing", name=opened.name))
    library_tasks = [
        record.task for library in open_libraries(outside.site.directories) for record in library.tasks.values()
    ]
    seats = redirection.seats(prepared.program, prepared.plan, opened.redirects, library_tasks)
    flows = {flow: tuple(map(_seat, some)) for flow, some in seats.items()}
    worlds = {
        flow: tuple(WorldSeatView(seat.world, seat.taken_by) for seat in some)
        for flow, some in world_redirection.world_seats(prepared.plan, opened.redirects).items()
    }
    known = model.runtime.world_kinds
    of_files = {files.world: True for files in prepared.plan.worlds if files.world not in known}
    model = with_kinds(model, of_files)  # before a runtime has been asked: such worlds are always simulated
    if len(flows) < 2:
        return Done(model, value=SeatsView(flows, worlds))
    return Done(model, value=SeatsView({"": _everywhere(flows), **flows}, {"": _worlds_everywhere(worlds), **worlds}))


def find_worlds(model: Model, _asked: act.FindWorlds, _outside: Services) -> Procedure:
    """Which worlds the runtime has, to be shown with it; it is started where there is none."""
    url = model.runtime.address
    state = model.runtime if model.runtime.state == "linked" else flow_placement.starting(model.runtime)
    model, standing = yield Ask(replace(model, runtime=state), live.Survey(), RequiredRuntime(url))
    if not isinstance(standing, Standing):
        why = refusal(standing)
        yield InterimModel(flow_placement.lost(model, why))
        return No(Reason.of("run.no_runtime", why=in_short(why)))
    model, response = yield Ask(replace(model, runtime=runtime_view(model.runtime, standing)), live.ListWorlds())
    if not isinstance(response, live.WorldList):
        yield InterimModel(model)
        return No(refusal(response))
    return Done(with_kinds(model, response.simulated), value=response.faults)


def _everywhere(flows: dict[str, tuple[SeatView, ...]]) -> tuple[SeatView, ...]:
    """The seats of all flows as those of one: who is to stand in all of them has to be able to in each."""
    by_home: dict[str, list[SeatView]] = {}
    for some in flows.values():
        for seat_view in some:
            by_home.setdefault(seat_view.task, []).append(seat_view)
    return tuple(map(_joined, by_home.values()))


def _worlds_everywhere(worlds: dict[str, tuple[WorldSeatView, ...]]) -> tuple[WorldSeatView, ...]:
    """The worlds of all flows as those of one."""
    holders: dict[str, set[str]] = {}
    for seat in (seat for some in worlds.values() for seat in some):
        holders.setdefault(seat.world, set()).add(seat.taken_by)
    return tuple(WorldSeatView(world, min(who) if len(who) == 1 else "") for world, who in sorted(holders.items()))


def _joined(seats: Sequence[SeatView]) -> SeatView:
    first, holders = seats[0], {seat.taken_by for seat in seats}
    reasons: dict[str, dict[Reason, None]] = {}
    for each in (each for seat in seats for each in seat.candidates):
        reasons.setdefault(each.name, {}).update(dict.fromkeys(each.reasons))
    candidates = [structs.replace(each, reasons=tuple(reasons[each.name])) for each in first.candidates]
    candidates.sort(key=lambda each: (bool(each.reasons), each.name))
    return structs.replace(first, taken_by=first.taken_by if len(holders) == 1 else "", candidates=tuple(candidates))


def _seat(seat: RedirectableTask) -> SeatView:
    candidates = tuple(
        CandidateView(
            each.task.name, each.task.description, each.more, tuple(refusal.reason for refusal in each.refusals)
        )
        for each in seat.candidates
    )
    is_hardware = bool(list(devices(seat.task)))
    return SeatView(seat.task.name, seat.taken_by, candidates, seat.task.description, is_hardware)
