"""A target is taken from where the robot is: what runs now is asked for what it measures (D13, D23, K07)."""

from collections.abc import Mapping, Sequence

from onika.desk.environment.icons.measured_variables import MeasuredVariable, measures_of, values_of
from onika.desk.environment.icons.measuring_remedies import ways_to_measure
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.planned import task_of
from onika.model.syntax import IconType
from onika.wire import act, live
from onika.wire.view import TaughtView
from onika.words.reason import NOTHING, Reason

Writers = Mapping[str, str]
"""By variable: the task that writes it now."""


def teach(model: Model, command: act.Teach, _outside: Services) -> Procedure:
    """Ask for what is measured now; the value is a `view.TaughtView`, of which what nothing measures is left out."""
    kind = model.syntax.find(command.type) if model.syntax else None
    if kind is None or not kind.is_target:
        return No(
            Reason.of("desk.no_target_type", kind=kind_named(command.type)),
            fields={"type": Reason.of("desk.target_type_form")},
        )
    measures = measures_of(model, kind)
    if not measures:
        return No(Reason.of("desk.nothing_measures", kind=a_kind(kind.name)))
    if model.runtime.state != "linked":
        return No(Reason.of("desk.no_robot"), ways_to_measure(model, measures))
    model, standing = yield Ask(model, live.Survey())
    if not isinstance(standing, live.Standing):
        return No(refusal(standing))
    places = {home.name: writers for home in standing.subsystems if (writers := _writers(home, measures))}
    why = _unmeasured(places, measures, command.subsystem, kind)
    if why:
        return No(why, ways_to_measure(model, measures))
    subsystem = command.subsystem or _nearest(model, places)
    others = tuple(name for name in places if name != subsystem)
    model, response = yield Ask(model, live.Read(subsystem, tuple(places[subsystem])))
    if not isinstance(response, live.Values):
        return No(refusal(response))
    return _taught(model, response, measures, places[subsystem], subsystem, others)


def _unmeasured(
    places: Mapping[str, Writers], measures: Sequence[MeasuredVariable], subsystem: str, kind: IconType
) -> Reason:
    """Why nothing is measured, there or anywhere; nothing: it is."""
    if subsystem and subsystem not in places:
        return Reason.of("desk.not_measured_in", subsystem=subsystem, kind=a_kind(kind.name))
    if places:
        return NOTHING
    return Reason.of("desk.not_measured", names=tuple(dict.fromkeys(measure.variable for measure in measures)))


def _taught(
    model: Model,
    response: live.Values,
    measures: Sequence[MeasuredVariable],
    writers: Writers,
    subsystem: str,
    others: tuple[str, ...],
) -> Done | No:
    """What was measured, as far as it fits the type."""
    taken: dict[str, tuple[float, ...]] = {}
    wrong: list[Reason] = []
    for measure in measures:
        if measure.variable in response.values and measure.item not in taken:
            values = values_of(measure, response.values[measure.variable])
            if isinstance(values, Reason):
                wrong.append(values)
            else:
                taken[measure.item] = values
    if not taken:
        return No(Reason.of("desk.measured_unfit", reasons=tuple(wrong)))
    used = {measure.variable for measure in measures if measure.item in taken and measure.variable in writers}
    sources = tuple(
        Reason.of("desk.measured_by", name=name, task=writers[name], subsystem=subsystem)
        for name in writers
        if name in used
    )
    source = Reason.of("desk.measured_sources", sources=sources)
    return Done(model, value=TaughtView(taken, source, subsystem, others))


def _writers(subsystem: live.SubsystemStanding, measures: Sequence[MeasuredVariable]) -> dict[str, str]:
    """What tasks that are ON write of what is wanted: else it is old, or never was."""
    wanted = {measure.variable for measure in measures}
    writers: dict[str, str] = {}
    for standing in subsystem.tasks:
        if standing.state == "ON":
            task = task_of(standing.task)
            writers |= dict.fromkeys(sorted(task.outputs & wanted), task.name)
    return writers


def _nearest(model: Model, places: Mapping[str, Writers]) -> str:
    """The subsystem of an open configuration before others."""
    here = [
        document.live.subsystem
        for document in model.documents.values()
        if document.live and document.live.state == "live"
    ]
    return next((name for name in here if name in places), next(iter(places)))
