"""Adds to a fault the tasks that could stand for the one that cannot live as it is (requirement X02)."""

from collections.abc import Sequence
from dataclasses import replace

from onika.desk.plan.preparation import PreparedRun
from onika.desk.plan.redirection import RedirectableTask, seats
from onika.model.redirect import Redirect
from onika.model.task import Task
from onika.store.library import open_libraries
from onika.store.site import Site
from onika.words.fault import Fault
from onika.words.reason import Reason

_MOST = 4


def with_substitutes(
    faults: Sequence[Fault], prepared: PreparedRun, redirects: Sequence[Redirect], site: Site
) -> list[Fault]:
    """The faults, those of a task's own file with the tasks that could stand for it.

    These have its outputs and conflict with nobody; whether they reach every target is seen when they are tried.
    """
    if prepared.program is None or prepared.plan is None:
        return list(faults)
    places = {task.place: task.name for flow in prepared.plan.flows for task in flow.tasks}
    if not any(fault.place.file in places for fault in faults):
        return list(faults)  # as nearly always: no library need be read
    tasks = [record.task for library in open_libraries(site.directories) for record in library.tasks.values()]
    every = seats(prepared.program, prepared.plan, redirects, tasks)
    taken = {seat.taken_by: seat for some in every.values() for seat in some}
    return [_helped(fault, taken.get(places.get(fault.place.file, ""))) for fault in faults]


def _helped(fault: Fault, seat: RedirectableTask | None) -> Fault:
    if seat is None or fault.remedies:
        return fault
    fit = [
        candidate.task
        for candidate in seat.candidates
        if not candidate.refusals and candidate.task.name != seat.taken_by
    ]
    fit.sort(key=lambda task: _world(task) != _world(seat.task))  # who stands in the same workcell is likelier meant
    names = [task.name for task in fit[:_MOST]]
    return replace(fault, remedies=tuple(Reason.of("desk.redirect_to", old=seat.task.name, new=name) for name in names))


def _world(task: Task) -> str:
    """The world in which its device is; nothing, where it has none."""
    words = next((line.words for line in task.local if line.key == "DEVICE"), ())
    return words[0].partition(":")[0] if words else ""
