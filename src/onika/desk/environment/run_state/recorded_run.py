"""A recorded run that is looked at: its file, what was shown of it at any instant, what a page has to know of it."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from threading import Event

from msgspec import structs

from onika.desk.environment.run_state.event_marks import marks
from onika.desk.environment.run_state.messages import IconWording
from onika.desk.environment.run_state.replay import RunHistory
from onika.desk.environment.run_state.run import Run, begun
from onika.desk.environment.run_state.step_mapping import StepMapping
from onika.desk.environment.run_state.subsystem_views import planned
from onika.desk.environment.run_state.variable_cache import VariableCache
from onika.desk.run.recorded_run import recorded_run
from onika.desk.run.recording_digest import black_box_line
from onika.desk.run.run_review import Review, ReviewedFlow
from onika.desk.run.settings import RecordingSource
from onika.record.run import HERE
from onika.record.series import Series
from onika.wire import event
from onika.wire.view import (
    FlowRunView,
    PassageView,
    RecordedFlowView,
    RecordedVariableView,
    RecordingView,
    RedirectView,
)
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True, eq=False)
class ReviewedRun:
    """One recorded run; equal only to itself."""

    review: Review
    replay: RunHistory
    view: RecordingView
    wording: IconWording
    """The words of its icons."""
    samples: VariableCache = field(default_factory=VariableCache)
    """Of the variables that were plotted."""
    away: Event = field(default_factory=Event)
    """Set where nobody looks at it any more."""

    @property
    def path(self) -> Path:
        """Its file."""
        return Path(self.view.path)

    def is_of(self, other: "ReviewedRun") -> bool:
        """Whether both were made when the same recording was opened: it may be shown at other icons since."""
        return self.review is other.review


def subject(review: Review, recast: StepMapping, durations: Mapping[tuple[int, int], float]) -> ReviewedRun:
    """Made of a recording, and of the steps of the open application that its actions are."""
    run = begun(recast.doc, recast.plan, 0, _began(review.run.began), recast.belonging)
    run = replace(run, wording=recast.wording, durations=durations)
    steps_by_task = run.view.steps_by_task
    run = run.shown(flows=_flows(run, review.run.stations))
    run = run.shown(state="running", recording=str(review.path), steps_by_task={})  # told once, not at every instant
    view = structs.replace(_view(review, run, recast), steps_by_task=steps_by_task)
    return ReviewedRun(review, RunHistory(run, review.events), view, run.wording)


def _flows(run: Run, stations: Mapping[str, str]) -> dict[str, FlowRunView]:
    """What is shown of its flows, with where each was carried out; empty: at the first station."""
    return {
        home: structs.replace(flow, station=_station(stations.get(home, HERE))) for home, flow in run.view.flows.items()
    }


def _station(name: str) -> str:
    return "" if name == HERE else name


def _view(review: Review, run: Run, recast: StepMapping) -> RecordingView:
    begin_s, end_s = review.span_s
    flow_plan = review.run.prepare.plan
    return RecordingView(
        path=str(review.path),
        name=flow_plan.application,
        is_virtual=review.run.is_virtual,
        is_whole=review.is_whole,
        is_completed=review.ending.get("completed") == "yes",
        cause=run.wording.with_icons(_cause(review)),
        begin_s=begin_s,
        end_s=end_s,
        flows={
            flow.subsystem: RecordedFlowView(order, _passages(flow, run, order))
            for order, flow in enumerate(review.flows)
        },
        variables={address: _variable(series) for address, series in review.series.items()},
        worlds=review.worlds,
        marks=marks(run, review),
        notes=(*_black_box(review), *_losses(review), *recast.notes),
        cannot_continue=_cannot_continue(review.path),
        doc=recast.doc,
        began_at_s=_began(review.run.began),
        redirects=tuple(_redirects(review)),
        inside={flow.subsystem: planned(flow_plan.application, flow.tasks) for flow in flow_plan.flows},
    )


def _black_box(review: Review) -> Iterator[Reason]:
    if review.black_box is not None:
        yield black_box_line(review.black_box, is_by_hand=review.run.is_by_hand)
        if not review.worlds:
            yield Reason.of("desk.digest_black_box_workcell")


def _redirects(review: Review) -> Iterator[RedirectView]:
    """Flows are meant by their order: what runs may be called otherwise than a flow of the application."""
    plan = review.run.prepare.plan
    for order, flow in enumerate(plan.flows):
        home = f"flow{order}"
        stands = [(old.name, name) for name, old in flow.replaced]
        stands += [(f"{named}:", f"{driven}:") for named, driven in flow.worlds if named != driven]
        for old_name, new_name in stands:
            yield RedirectView(old_name, new_name, home if len(plan.flows) > 1 else "", (home,))


def _passages(flow: ReviewedFlow, run: Run, number: int) -> tuple[PassageView, ...]:
    return tuple(
        PassageView(
            interval.action,
            run.called(flow.subsystem, interval.action) or interval.name,
            interval.begin_s,
            interval.end_s,
            run.step_at(flow.subsystem, interval.action),
        )
        for interval in flow.intervals
    )


def _variable(series: Series) -> RecordedVariableView:
    return RecordedVariableView(series.unit, () if series.is_picture else tuple(series.labels))


def _losses(review: Review) -> Iterator[Reason]:
    """What is not in the recording."""
    if not review.is_whole:
        yield Reason.of("run.lost_cut")
    missed, untold = (int(review.ending.get(key, "0") or 0) for key in ("missed", "untold"))
    if missed:
        yield Reason.of("run.lost_values", count=missed)
    if untold:
        yield Reason.of("run.lost_events", count=untold)
    if not review.run.is_virtual:
        yield Reason.of("run.lost_exactness")


def _cause(review: Review) -> Reason:
    """Why it ended: as its last event says, else as the recording's own summary does."""
    results = (message for _, _, message in reversed(review.events) if isinstance(message, event.Result))
    return next((result.cause for result in results), Reason.plain(review.ending.get("cause", "")))


def _cannot_continue(path: Path) -> Reason:
    source = recorded_run(RecordingSource(path))
    if isinstance(source, tuple):
        return Reason.of("run.together", parts=tuple(fault.reason for fault in source))
    return NOTHING


def _began(iso: str) -> float:
    """Seconds since 1970; 0 where it was not said."""
    try:
        return datetime.fromisoformat(iso).timestamp()
    except ValueError:
        return 0.0
