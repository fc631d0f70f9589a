"""Redirection from the page: who stands for whom in an application as long as it is open (E09, §5.9.1)."""

from dataclasses import replace

from onika.desk import redirection
from onika.desk.environment.model import Model
from onika.desk.environment.outcome import Done, No
from onika.desk.environment.surroundings import Surroundings
from onika.desk.redirection import Seat
from onika.desk.upper.flow.on_application import on_application, on_resting_application, syntax_of
from onika.desk.upper.flow.open_application import OpenApplication
from onika.desk.upper.run.beginning import ready
from onika.model.redirect import Redirect
from onika.store.library import open_libraries
from onika.wire import act
from onika.wire.view import CandidateView, SeatsView, SeatView


@on_resting_application
def redirect(model: Model, opened: OpenApplication, asked: act.Redirect, outside: Surroundings) -> Done | No:
    """Let a task stand for another one; refused with all reasons why it cannot."""
    wish = Redirect(asked.old, asked.new or asked.old, asked.flow)
    others = tuple(one for one in opened.redirects if (one.home, one.old) != (wish.home, wish.old))
    redirects = others if wish.new == wish.old else (*others, wish)
    prepared = ready(replace(opened, redirects=redirects), outside.site, syntax_of(model))
    if wish in redirects and prepared.plan is not None and prepared.program is not None:
        faults = list(redirection.faults((wish,), prepared.plan, prepared.program))
        if faults:
            reasons = "; ".join(fault.found for fault in faults)
            return No(f"{wish.new} cannot stand for {wish.old}: {reasons}")
    changed = replace(opened, redirects=redirects, judgement=None, marks={})
    return Done(model.with_application(changed))


@on_application
def seats(model: Model, opened: OpenApplication, asked: act.Seats, outside: Surroundings) -> Done | No:
    """Who could stand for whom; the value is a `view.SeatsView`."""
    prepared = ready(opened, outside.site, syntax_of(model))
    if prepared.plan is None or prepared.program is None:
        return No(f"{opened.name} has nothing to run")
    known = [record.task for library in open_libraries(outside.site.directories) for record in library.tasks.values()]
    found = redirection.seats(prepared.program, prepared.plan, opened.redirects, known)
    return Done(model, value=SeatsView({flow: tuple(map(_seat, some)) for flow, some in found.items()}))


def _seat(one: Seat) -> SeatView:
    candidates = tuple(
        CandidateView(
            each.task.name, each.task.description, each.more, tuple(refusal.reason for refusal in each.refusals)
        )
        for each in one.candidates
    )
    return SeatView(one.task.name, one.taken_by, candidates)
