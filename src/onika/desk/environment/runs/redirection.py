"""Redirection from the page: who stands for whom in an application as long as it is open (E09, §5.9.1)."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.on_file import on_application, on_resting_application, syntax_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan import redirection
from onika.desk.plan.preparation import PreparedRun
from onika.desk.plan.redirection import Seat
from onika.model.redirect import Redirect
from onika.model.rules.union import devices
from onika.store.library import open_libraries
from onika.wire import act
from onika.wire.view import CandidateView, SeatsView, SeatView


@on_resting_application
def redirect(model: Model, opened: OpenApplication, asked: act.Redirect, outside: Surroundings) -> Done | No:
    """Let a task stand for another one; refused with all reasons why it cannot."""
    wish = Redirect(asked.old, asked.new or asked.old, asked.flow)
    is_split = bool(wish.home) and any(one.old == wish.old and not one.home for one in opened.redirects)
    before = ready(opened, outside.site, syntax_of(model)) if is_split else None
    others = tuple(_others(opened.redirects, wish, before))
    redirects = others if wish.new == wish.old else (*others, wish)
    prepared = ready(replace(opened, redirects=redirects), outside.site, syntax_of(model))
    if wish in redirects and prepared.plan is not None and prepared.program is not None:
        faults = list(redirection.faults((wish,), prepared.plan, prepared.program))
        if faults:
            reasons = "; ".join(fault.found for fault in faults)
            return No(f"{wish.new} cannot stand for {wish.old}: {reasons}")
    changed = replace(opened, redirects=redirects, judgement=None, marks={}, looked=None)
    return Done(model.with_application(changed))


def _others(redirects: tuple[Redirect, ...], wish: Redirect, prepared: PreparedRun | None) -> Iterator[Redirect]:
    """What holds besides: a wish for all flows ends those for single ones, and is meant for the others after one."""
    for one in redirects:
        if one.old != wish.old or (wish.home and one.home and one.home != wish.home):
            yield one
        elif prepared is not None and not one.home and prepared.plan is not None and prepared.program is not None:
            homes = redirection.homes_of(one.old, prepared.plan, prepared.program)
            yield from (replace(one, flow=home) for home in homes if home != wish.home)


@on_application
def seats(model: Model, opened: OpenApplication, asked: act.Seats, outside: Surroundings) -> Done | No:
    """Who could stand for whom; the value is a `view.SeatsView`."""
    prepared = ready(opened, outside.site, syntax_of(model))
    if prepared.plan is None or prepared.program is None:
        return No(f"{opened.name} has nothing to run")
    known = [record.task for library in open_libraries(outside.site.directories) for record in library.tasks.values()]
    found = redirection.seats(prepared.program, prepared.plan, opened.redirects, known)
    flows = {flow: tuple(map(_seat, some)) for flow, some in found.items()}
    return Done(model, value=SeatsView(flows if len(flows) < 2 else {"": _everywhere(flows), **flows}))


def _everywhere(flows: dict[str, tuple[SeatView, ...]]) -> tuple[SeatView, ...]:
    """The seats of all flows as those of one: who is to stand in all of them has to be able to in each."""
    found: dict[str, list[SeatView]] = {}
    for some in flows.values():
        for one in some:
            found.setdefault(one.task, []).append(one)
    return tuple(map(_joined, found.values()))


def _joined(seats: Sequence[SeatView]) -> SeatView:
    first, holders = seats[0], {one.taken_by for one in seats}
    reasons: dict[str, dict[str, None]] = {}
    for each in (each for one in seats for each in one.candidates):
        reasons.setdefault(each.name, {}).update(dict.fromkeys(each.reasons))
    candidates = [structs.replace(each, reasons=tuple(reasons[each.name])) for each in first.candidates]
    candidates.sort(key=lambda each: (bool(each.reasons), each.name))
    return structs.replace(first, taken_by=first.taken_by if len(holders) == 1 else "", candidates=tuple(candidates))


def _seat(one: Seat) -> SeatView:
    candidates = tuple(
        CandidateView(
            each.task.name, each.task.description, each.more, tuple(refusal.reason for refusal in each.refusals)
        )
        for each in one.candidates
    )
    is_hardware = bool(list(devices(one.task)))
    return SeatView(one.task.name, one.taken_by, candidates, one.task.description, is_hardware)
