"""A state variable that lives is looked at: which targets its present value makes (requirements C30, D08)."""

from onika.desk.environment.canvas.inspection import readable_subsystem
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import inputs_of, ports_of
from onika.desk.plan.target_inputs import measured_kinds, unit_of_variable
from onika.desk.plan.target_refusal import unfit
from onika.desk.run.readings_text import types_of
from onika.files.line import show_number
from onika.model.rules.target_fit import TargetFit, VariableValue, fits_in
from onika.model.task import Task
from onika.wire import act, live
from onika.wire.sheet import InputSheet
from onika.wire.view import TargetFitsView, TargetFitView
from onika.words.reason import Reason
from onika.words.value import Value


def fit_targets(model: Model, command: act.FitTargets, _outside: Services) -> No | Procedure:
    """The types of targets that take what a variable holds now; the value is a `view.TargetFitsView`."""
    subsystem = command.subsystem or _of_document(model, command.doc)
    if isinstance(subsystem, No):
        return subsystem
    return _fitting(model, command.variable, subsystem)


def _of_document(model: Model, doc: str) -> str | No:
    document = model.documents.get(doc)
    if document is None:
        return No(Reason.of("run.configuration_closed"))
    return readable_subsystem(model, document)


def _fitting(model: Model, name: str, subsystem: str) -> Procedure:
    model, response = yield Ask(model, live.Read(subsystem, (name,)))
    if not isinstance(response, live.Values):
        return No(refusal(response))
    if name not in response.values:
        return No(Reason.of("desk.no_variable_there", name=name, subsystem=subsystem))
    variable = VariableValue(name, types_of(response)[name], response.values[name], _unit(model, name))
    kinds = measured_kinds(model.syntax, _inputs(model))
    fits = [fit for kind, units in kinds for fit in fits_in(kind, variable, units)]
    if not fits:
        return No(unfit(variable, kinds))
    source = Reason.of("desk.variable_read", name=name, subsystem=subsystem)
    return Done(model, value=TargetFitsView(name, variable.described, source, tuple(map(_view, fits))))


def _inputs(model: Model) -> list[tuple[Task, tuple[InputSheet, ...]]]:
    """The tasks of the open libraries with what they take."""
    return [(task, inputs_of(model.libraries, task)) for task in model.libraries.tasks.values()]


def _unit(model: Model, name: str) -> str:
    tasks = model.libraries.tasks.values()
    return unit_of_variable(name, ((task, ports_of(model.libraries, task)) for task in tasks))


def _view(fit: TargetFit) -> TargetFitView:
    return TargetFitView(fit.type, fit.item, tuple(map(_word, fit.values)))


def _word(value: Value) -> str:
    return show_number(value) if isinstance(value, float) else str(value)
