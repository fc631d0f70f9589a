"""What every change of an application comes to: other flows, new numbers, and a step that Undo takes back."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.application import AppFlow, Application
from onika.model.flow_path import StepAddress, flows_by_path, numbered, spot_of, spots, with_flows
from onika.wire import act
from onika.words.reason import Reason


def altered(model: Model, opened: OpenApplication, application: Application, label: Reason, value: Any = None) -> Done:
    """With other content; steps that are new get their numbers."""
    application, last = numbered(application, opened.last_number)
    now = replace(opened, application=application, last_number=last)
    return Done(model.with_application(now), label=label, doc=opened.id, value=value)


def reflowed(
    model: Model, opened: OpenApplication, flows: Mapping[str, AppFlow], label: Reason, value: Any = None
) -> Done:
    """With other flows, by their paths."""
    return altered(model, opened, with_flows(opened.application, dict(flows)), label, value)


def flow_at(application: Application, path: str) -> AppFlow | None:
    """The flow of this path."""
    return next((flow for flow_path, flow in flows_by_path(application) if flow_path == path), None)


def place_behind(application: Application, path: str, after: int) -> tuple[str, int] | No:
    """The flow and position of the step `after`, wherever it is now; of 0 the beginning of the flow `path`."""
    if not after:
        if flow_at(application, path) is not None:
            return (path, -1)
        return No(Reason.of("desk.flow_gone"))
    spot = spot_of(application, after)
    if spot:
        return (spot.path, spot.position)
    return No(Reason.of("desk.place_gone"))


def spots_of(application: Application, steps: act.Steps) -> list[StepAddress] | No:
    """Where steps stand, in their order there; those that somebody else has deleted are passed over."""
    wanted = set(steps)
    there = [spot for number, spot in spots(application).items() if number in wanted]
    return there or No(Reason.of("desk.selection_gone") if wanted else Reason.of("desk.nothing_selected"))
