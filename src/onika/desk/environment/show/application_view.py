"""An open application as a page is shown it: its flows, and what is wrong with it (requirements D04, D20).

What has not changed is the same object again, so that a change of one icon is sent as that.
"""

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from msgspec import structs

from onika.desk.environment.outcome.on_file import syntax_of
from onika.desk.environment.show.step_view import MadeStep, step_views
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Foretelling, OpenApplication, PreflightResult
from onika.desk.environment.state.undo_order import label_of, redoable, undoable
from onika.model.application import AppFlow, Hole
from onika.model.flow_path import flows_by_path
from onika.model.redirect import Redirect
from onika.model.syntax import END, START, Syntax
from onika.wire.view import (
    AppFlowView,
    ApplicationView,
    FaultView,
    ForecastView,
    RedirectView,
    Remedy,
    ShowStep,
    StepView,
)
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class _Flow:
    """What was made of a flow."""

    flow: AppFlow
    view: AppFlowView
    step_views: Mapping[int, MadeStep]
    steps: Mapping[str, StepView]
    holes: int


class ApplicationProjector:
    """Makes the view of one application, and remembers what it made of which flows."""

    def __init__(self) -> None:
        self._flows: dict[str, _Flow] = {}
        self._of: tuple[object, object] = (None, None)
        self._faults: tuple[object, object, object, object, dict[str, FaultView]] = (None, None, None, None, {})

    def view(self, opened: OpenApplication, order: int, model: Model, *, is_running: bool) -> ApplicationView:
        """The application as it is now; `order` is its place among those that are open."""
        self._look(opened, model)
        looked = opened.looked_at(model.runtime_at(opened.lone_station or "").address)
        return ApplicationView(
            name=opened.name,
            order=order,
            path=str(opened.opened.path) if opened.opened else "",
            base=str(opened.base or ""),
            is_dirty=opened.is_dirty,
            has_changed_on_disk=opened.has_changed_on_disk,
            undo=label_of(undoable(model, opened)),
            redo=label_of(redoable(model, opened)),
            is_parallel=opened.application.is_parallel,
            flows={path: flow.view for path, flow in self._flows.items()},
            steps=self._marked(opened if looked else None),
            holes=sum(flow.holes for flow in self._flows.values()),
            faults=self._told(opened, looked),
            is_judged=opened.is_judged,
            is_checked=looked is not None,
            is_running=is_running,
            stations=dict(opened.stations),
            puzzle=opened.puzzle,
            redirects=tuple(_wish(opened, redirect) for redirect in opened.redirects),
            forecast=_forecast(opened),
            worlds=dict(opened.judgement.worlds) if opened.judgement is not None else {},
            guests=dict(opened.judgement.guests) if opened.judgement is not None else {},
        )

    def _marked(self, looked_at: OpenApplication | None) -> dict[str, StepView]:
        """The steps by their numbers, with what became of them where a runtime has looked at what is here now."""
        steps = {number: view for flow in self._flows.values() for number, view in flow.steps.items()}
        for number, note in (looked_at.marks if looked_at is not None else {}).items():
            if (view := steps.get(str(number))) is not None:
                steps[str(number)] = structs.replace(view, note=note)
        return steps

    def _look(self, opened: OpenApplication, model: Model) -> None:
        """Make anew what changed; all of it where the types or the dictionaries are others."""
        of = (model.syntax, model.dictionaries)
        is_same = all(part is other for part, other in zip(of, self._of, strict=True))
        former, self._of = self._flows if is_same else {}, of
        flows = dict(flows_by_path(opened.application))
        stays = {path for path, before in former.items() if before.flow is flows.get(path)}
        former_steps = {
            number: step_view for path in former.keys() - stays for number, step_view in former[path].step_views.items()
        }
        self._flows = {
            path: former[path] if path in stays else _seen(path, flow, model, former.get(path), former_steps)
            for path, flow in flows.items()
        }

    def _told(self, opened: OpenApplication, looked: PreflightResult | None) -> dict[str, FaultView]:
        """What is wrong with its file, then with what is here, as it was looked at last, and what is foreseen."""
        of = (opened.file_faults, opened.judgement, looked, opened.foretold)
        *made_of, faults = self._faults
        if all(part is other for part, other in zip(of, made_of, strict=True)):
            return faults
        judged = opened.judgement.faults if opened.judgement else ()
        shown_already = {(fault.step, fault.text) for fault in judged}
        more = [fault for fault in looked.faults if (fault.step, fault.text) not in shown_already] if looked else []
        fault_views = _keyed("file", opened.file_faults) | _keyed("here", judged) | _keyed("runtime", more)
        fault_views |= _keyed("forecast", _foreseen(opened.foretold))
        self._faults = (*of, fault_views)
        return fault_views


def _forecast(opened: OpenApplication) -> ForecastView:
    """What is foreseen, in short."""
    of = opened.foretold
    if of is None or (not of.is_going and not of.lasts_s and not of.cause):
        return ForecastView()
    if of.is_going:
        return ForecastView("going")
    unwatched = tuple(world for world, is_watched in of.watched.items() if not is_watched)
    state: Literal["part", "whole"] = "part" if of.cause else "whole"
    return ForecastView(state, of.lasts_s, of.cause, len(of.mishaps), of.standing, tuple(of.watched), unwatched)


def _foreseen(of: Foretelling | None) -> Iterable[FaultView]:
    """What is foreseen to happen, as something worth knowing of its steps."""
    for number, mishap in enumerate(of.mishaps if of is not None else (), 1):
        text = Reason.of("run.foreseen_at", at_s=mishap.at_s, what=mishap.text)
        show = (Remedy(Reason.of("run.show_it"), show=ShowStep(mishap.step)),) if mishap.step else ()
        yield FaultView(text, "warning", mishap.step, show, instant=number)


def _keyed(where: str, faults: Iterable[FaultView]) -> dict[str, FaultView]:
    """By where they were found, their steps, and a count of those: one more at one step gives no other a new key."""
    counts: Counter[int] = Counter()
    keyed = {}
    for fault in faults:
        counts[fault.step] += 1
        keyed[f"{where} {fault.step} {counts[fault.step]}"] = fault
    return keyed


def _wish(opened: OpenApplication, redirect: Redirect) -> RedirectView:
    homes = opened.judgement.homes.get(redirect.old, ()) if opened.judgement is not None else ()
    return RedirectView(redirect.old, redirect.new, redirect.home, (redirect.home,) if redirect.home else homes)


def _seen(path: str, flow: AppFlow, model: Model, before: _Flow | None, former_steps: Mapping[int, MadeStep]) -> _Flow:
    syntax = syntax_of(model)
    made = step_views(flow, path, model, former_steps, before.flow if before else None)
    view = AppFlowView(tuple(made), end=_edge(END, syntax, is_left=True), start=_edge(START, syntax, is_left=False))
    if before is not None and before.view == view:
        view = before.view
    steps = {str(number): step_view.view for number, step_view in made.items()}
    return _Flow(flow, view, made, steps, sum(isinstance(step, Hole) for step in flow.steps))


def _edge(name: str, syntax: Syntax, *, is_left: bool) -> str:
    kind = syntax.find(name)
    if kind is None:
        return ""
    return str(kind.left_edge if is_left else kind.right_edge)
