"""A runtime follows the breakpoints of the application that runs (requirement E07)."""

from collections.abc import Iterator

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.run_state.membership import icons
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.model import Model
from onika.model.application import Application
from onika.wire import page, request, steer
from onika.words.reason import Reason


def changed_breakpoints(before: Model, after: Model) -> tuple[Order, ...]:
    """What the runtime is asked for where breakpoints of the application that runs were set or removed."""
    return tuple(order for run in after.going for order in _changed(before, after, run))


def _changed(before: Model, after: Model, run: Run) -> tuple[Order, ...]:
    if run.doc not in after.applications or run.doc not in before.applications:
        return ()
    old, new = before.applications[run.doc].application, after.applications[run.doc].application
    if old is new:
        return ()
    former, now = _breakpoints(old), _breakpoints(new)
    changed = [step for step in {**former, **now} if former.get(step) != now.get(step)]
    marks = [mark for step in changed for mark in _mark(run, step, now)]
    return tuple(Order(mark, _marked, station=run.station_of(mark.subsystem)) for mark in marks)


def _mark(run: Run, step: int, now: dict[int, str]) -> Iterator[steer.Mark]:
    """For each action of a step; of an application only for the last one in it."""
    places = list(run.actions_of(step))
    is_nested = any(len(action.spot) > 1 for place in places if (action := run.action(*place)) is not None)
    for flow, index in places[-1:] if is_nested else places:
        yield steer.Mark(run.homes[flow], index, step in now, now.get(step, ""))


def _breakpoints(application: Application) -> dict[int, str]:
    return {icon.number: icon.marker_if for icon in icons(application) if icon.marker}


def _marked(model: Model, response: request.Response) -> Done:
    if isinstance(response, request.Done):
        return Done(model)
    message = page.Say("warning", Reason.of("run.breakpoint_later", why=refusal(response)))
    return Done(model, says=(message,))
