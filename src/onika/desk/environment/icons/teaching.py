"""A target is taken from where the robot is: what runs now is asked for what it measures (D13, D23, K07)."""

from collections.abc import Mapping, Sequence

from onika.desk.environment.icons.measured_variables import Measure, measures_of, values_of
from onika.desk.environment.icons.measuring_remedies import ways_to_measure
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.model import Model
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.planned import task_of
from onika.wire import act, live
from onika.wire.view import TaughtView

Writers = Mapping[str, str]
"""By variable: the task that writes it now."""


def teach(model: Model, command: act.Teach, _outside: Surroundings) -> Procedure:
    """Ask for what is measured now; the value is a `view.TaughtView`, of which what nothing measures is left out."""
    kind = model.syntax.find(command.type) if model.syntax else None
    if kind is None or not kind.is_target:
        return No(f"{kind_named(command.type)} is no type of target", fields={"type": "expected a type of target"})
    measures = measures_of(model, kind)
    if not measures:
        return No(f"no task that takes {a_kind(kind.name)} measures anything like it: its values are typed in")
    if model.runtime.state != "linked":
        return No("no robot is connected: nothing is measured", ways_to_measure(model, measures))
    model, standing = yield Ask(model, live.Survey())
    if not isinstance(standing, live.Standing):
        return No(refusal(standing))
    places = {home.name: writers for home in standing.subsystems if (writers := _writers(home, measures))}
    if command.subsystem and command.subsystem not in places:
        return No(f"nothing in {command.subsystem} measures {a_kind(kind.name)} now", ways_to_measure(model, measures))
    if not places:
        names = " or ".join(dict.fromkeys(measure.variable for measure in measures))
        return No(f"nothing that runs measures {names} now", ways_to_measure(model, measures))
    subsystem = command.subsystem or _nearest(model, places)
    others = tuple(name for name in places if name != subsystem)
    model, response = yield Ask(model, live.Read(subsystem, tuple(places[subsystem])))
    if not isinstance(response, live.Values):
        return No(refusal(response))
    return _taught(model, response, measures, places[subsystem], subsystem, others)


def _taught(
    model: Model,
    response: live.Values,
    measures: Sequence[Measure],
    writers: Writers,
    subsystem: str,
    others: tuple[str, ...],
) -> Done | No:
    """What was measured, as far as it fits the type."""
    taken: dict[str, tuple[float, ...]] = {}
    wrong: list[str] = []
    for measure in measures:
        if measure.variable in response.values and measure.item not in taken:
            values = values_of(measure, response.values[measure.variable])
            if isinstance(values, str):
                wrong.append(values)
            else:
                taken[measure.item] = values
    if not taken:
        return No("what is measured does not fit: " + "; ".join(wrong))
    used = {measure.variable for measure in measures if measure.item in taken and measure.variable in writers}
    source = " and ".join(f"{name}, as {writers[name]} measures it in {subsystem}" for name in writers if name in used)
    return Done(model, value=TaughtView(taken, source, subsystem, others))


def _writers(subsystem: live.SubsystemStanding, measures: Sequence[Measure]) -> dict[str, str]:
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
