"""A target is taken from where the robot is: what runs now is asked for what it measures (D13, D23, K07)."""

from collections.abc import Mapping, Sequence

from msgspec import structs

from onika.desk.environment.icons.meant_arms import arms_meant
from onika.desk.environment.icons.measured_variables import MeasuredVariable, measures_of, values_of
from onika.desk.environment.icons.measuring_remedies import ways_to_measure
from onika.desk.environment.icons.moment import measured
from onika.desk.environment.icons.program_arms import MeasuringTasks
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import items_of
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.planned import task_of
from onika.model.syntax import IconType
from onika.wire import act, live
from onika.wire.runtime_standing import Standing, SubsystemStanding
from onika.wire.view import TaughtView
from onika.words.reason import NOTHING, Reason

Writers = Mapping[str, str]
"""By variable: the task that writes it now."""


def teach(model: Model, command: act.Teach, outside: Services) -> Procedure:
    """Ask for what is measured now; the value is a `view.TaughtView`, of which what nothing measures is left out."""
    kind = _kind(model, command)
    if isinstance(kind, No):
        return kind
    measures = measures_of(model, kind)
    if not measures:
        return No(Reason.of("desk.nothing_measures", kind=a_kind(kind.name)))
    arms = arms_meant(model, command, measures, outside)
    if model.runtime.state != "linked" and not arms:
        return No(Reason.of("desk.no_robot"), ways_to_measure(model, measures, kind))
    model, standing = yield Ask(model, live.Survey(), RequiredRuntime() if arms else None)
    if not isinstance(standing, Standing):
        return No(refusal(standing))
    if arms and not command.subsystem:
        return (yield from _of_arm(model, standing, kind, measures, arms))
    places = {home.name: writers for home in standing.subsystems if (writers := _writers(home, measures))}
    why = _unmeasured(places, measures, command.subsystem, kind)
    if why:
        return No(why, ways_to_measure(model, measures, kind))
    subsystem = command.subsystem or _nearest(model, places)
    others = tuple(name for name in places if name != subsystem)
    model, response = yield Ask(model, live.Read(subsystem, tuple(places[subsystem])))
    if not isinstance(response, live.Values):
        return No(refusal(response))
    sources = _sources(measures, response, places[subsystem], subsystem)
    return _taught(model, response, measures, TaughtView({}, sources, subsystem, others, kind.name))


def _kind(model: Model, command: act.Teach) -> IconType | No:
    """The type of target that is measured: the one that is named, else the first that something measures."""
    kinds = model.syntax.types if model.syntax else ()
    kind = model.syntax.find(command.type) if model.syntax else None
    is_target = kind is not None and kind.is_target
    is_free = not command.type or (is_target and command.or_another)
    if is_free and not (kind is not None and measures_of(model, kind)):
        kind = next((other for other in kinds if other.is_target and measures_of(model, other)), kind)
    if kind is not None and kind.is_target:
        return kind
    return No(
        Reason.of("desk.no_target_type", kind=kind_named(command.type)),
        fields={"type": Reason.of("desk.target_type_form")},
    )


def _of_arm(
    model: Model,
    standing: Standing,
    kind: IconType,
    measures: Sequence[MeasuredVariable],
    arms: Sequence[MeasuringTasks],
) -> Procedure:
    """What an arm measures: where its driver is ON it is read there, else it lives for a moment."""
    arm = arms[0]
    variables = tuple(dict.fromkeys(measure.variable for measure in measures))
    home = next((home for home in standing.subsystems if _is_driven(home, arm)), None)
    if home is not None and _writers(home, measures):
        model, response = yield Ask(model, live.Read(home.name, tuple(_writers(home, measures))))
        values = response if isinstance(response, live.Values) else No(refusal(response))
    else:
        model, values = yield from measured(model, standing, arm, variables)
    if isinstance(values, No):
        turns = (way for way in ways_to_measure(model, measures, kind) if isinstance(way.act, act.Turn))
        return No(values.reason, values.remedies or tuple(turns))
    source = Reason.of("desk.where_arm_stands", arm=arm.arm)
    names = tuple(sorted(each.arm for each in arms))
    return _taught(
        model,
        values,
        measures,
        TaughtView(
            {},
            source,
            type=kind.name,
            arm=arm.arm,
            device=min(arm.devices),
            arms=names,
            made_for=_made_for(model, kind, arm),
        ),
    )


def _made_for(model: Model, kind: IconType, arm: MeasuringTasks) -> str:
    """The arm of a target of this type: joints are those of one arm, a pose may be any one's."""
    is_of_joints = any(item.place == "joints" for item in items_of(model, kind.name))
    return arm.made_for if is_of_joints else ""


def _is_driven(home: SubsystemStanding, arm: MeasuringTasks) -> bool:
    """Whether a task that is ON there drives the arm."""
    return any(task.state == "ON" and task.claims in arm.devices for task in home.tasks)


def _unmeasured(
    places: Mapping[str, Writers], measures: Sequence[MeasuredVariable], subsystem: str, kind: IconType
) -> Reason:
    """Why nothing is measured, there or anywhere; nothing: it is."""
    if subsystem and subsystem not in places:
        return Reason.of("desk.not_measured_in", subsystem=subsystem, kind=a_kind(kind.name))
    if places:
        return NOTHING
    return Reason.of("desk.not_measured", names=tuple(dict.fromkeys(measure.variable for measure in measures)))


def _taught(model: Model, response: live.Values, measures: Sequence[MeasuredVariable], view: TaughtView) -> Done | No:
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
    return Done(model, value=structs.replace(view, values=taken))


def _sources(measures: Sequence[MeasuredVariable], response: live.Values, writers: Writers, subsystem: str) -> Reason:
    """The variables that give something, with who writes each."""
    used = {measure.variable for measure in measures if measure.variable in response.values}
    sources = tuple(
        Reason.of("desk.measured_by", name=name, task=writers[name], subsystem=subsystem)
        for name in writers
        if name in used
    )
    return Reason.of("desk.measured_sources", sources=sources)


def _writers(subsystem: SubsystemStanding, measures: Sequence[MeasuredVariable]) -> dict[str, str]:
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
