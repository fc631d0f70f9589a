"""Flows: of the application and of its branches, and which of them runs (requirements D04, D10, D13)."""

from dataclasses import replace

from onika.desk.environment.icons.alteration import altered, flow_at
from onika.desk.environment.outcome.on_file import on_resting_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import MOST_FLOWS, OpenApplication
from onika.model.application import AppFlow, Application, Branch
from onika.model.flow_path import spots, with_step
from onika.wire import act
from onika.wire.view import Remedy, ShowStep
from onika.words.condition import Condition
from onika.words.reason import Reason, reason_of


@on_resting_application
def set_conditions(model: Model, opened: OpenApplication, command: act.SetConditions, _outside: Services) -> Done | No:
    """Say which flow of a branch runs."""
    branch = _branch(opened.application, command.step)
    if isinstance(branch, No):
        return branch
    conditions = conditions_of(command.conditions, len(branch.flows))
    if isinstance(conditions, No):
        return conditions
    application = with_step(opened.application, command.step, replace(branch, conditions=conditions))
    return altered(model, opened, application, Reason.of("desk.saying_flow_of_branch"))


@on_resting_application
def add_flow(model: Model, opened: OpenApplication, command: act.AddFlow, _outside: Services) -> Done | No:
    """One more flow, empty; the value is its path."""
    application = opened.application
    if not command.step:
        if len(application.flows) >= MOST_FLOWS:
            return _too_many()
        flows = (*application.flows, AppFlow(()))
        path = str(len(application.flows))
        return altered(model, opened, replace(application, flows=flows), Reason.of("desk.adding_flow"), path)
    branch = _branch(application, command.step)
    if isinstance(branch, No):
        return branch
    if len(branch.flows) >= MOST_FLOWS:
        return _too_many()
    if branch.conditions:
        freed = act.SetConditions(opened.id, command.step, ())
        remedies = (
            Remedy(Reason.of("desk.choose_by_returned"), freed),
            Remedy(Reason.of("desk.show_branch"), show=ShowStep(command.step)),
        )
        return No(Reason.of("desk.branch_has_conditions"), remedies)
    grown = replace(branch, flows=(*branch.flows, AppFlow(())))
    path = f"{spots(application)[command.step].path}/{command.step}/{len(branch.flows)}"
    return altered(
        model, opened, with_step(application, command.step, grown), Reason.of("desk.adding_flow_to_branch"), path
    )


@on_resting_application
def remove_flow(model: Model, opened: OpenApplication, command: act.RemoveFlow, _outside: Services) -> Done | No:
    """Take a flow away with all that is in it; of a branch its condition too."""
    application = opened.application
    if flow_at(application, command.flow) is None:
        return No(Reason.of("desk.flow_gone"))
    *way, last = command.flow.split("/")
    number = int(last)
    if not way:
        if len(application.flows) == 1:
            return No(Reason.of("desk.application_without_flow"))
        flows = _but(application.flows, number)
        return altered(model, opened, replace(application, flows=flows), Reason.of("desk.deleting_flow"))
    branch = _branch(application, int(way[-1]))
    if isinstance(branch, No):
        return branch
    if len(branch.flows) == 1:
        remedy = Remedy(Reason.of("desk.delete_branch"), act.RemoveIcons(opened.id, (branch.number,)))
        return No(Reason.of("desk.branch_without_flow"), (remedy,))
    gone = min(number, len(branch.conditions) - 1)  # the last flow has none: then what was the last but one is it
    conditions = (*branch.conditions[:gone], *branch.conditions[gone + 1 :]) if branch.conditions else ()
    shrunk = replace(branch, flows=_but(branch.flows, number), conditions=conditions)
    return altered(
        model, opened, with_step(application, branch.number, shrunk), Reason.of("desk.deleting_flow_of_branch")
    )


@on_resting_application
def set_parallel(model: Model, opened: OpenApplication, command: act.SetParallel, _outside: Services) -> Done | No:
    """Whether the flows run side by side, or one of them is chosen."""
    label = Reason.of("desk.making_parallel") if command.is_parallel else Reason.of("desk.making_conditional")
    if opened.application.is_parallel == command.is_parallel:
        return Done(model)
    return altered(model, opened, replace(opened.application, is_parallel=command.is_parallel), label)


def branch_of(flows: int, conditions: tuple[str, ...]) -> Branch | No:
    """A branch with so many empty flows."""
    if not 2 <= flows <= MOST_FLOWS:
        return No(
            Reason.of("desk.branch_flow_count", most=MOST_FLOWS, flows=flows),
            fields={"flows": Reason.of("desk.flow_count_form", most=MOST_FLOWS)},
        )
    parsed = conditions_of(conditions, flows)
    if isinstance(parsed, No):
        return parsed
    return Branch((AppFlow(()),) * flows, parsed)


def conditions_of(texts: tuple[str, ...], flows: int) -> tuple[str, ...] | No:
    """The conditions of a branch with so many flows, as they are written; none, or one less than flows."""
    if not texts:
        return ()
    if len(texts) != flows - 1:
        return No(Reason.of("desk.condition_count", count=flows - 1, flows=flows, given=len(texts)))
    wrong: dict[str, Reason] = {}
    parsed = []
    for at, text in enumerate(texts):
        try:
            parsed.append(Condition.parse(text).text)
        except ValueError as error:
            wrong[f"conditions[{at}]"] = reason_of(error)
    if wrong:
        return No(Reason.of("desk.several_reasons", reasons=tuple(wrong.values())), fields=wrong)
    return tuple(parsed)


def _branch(application: Application, number: int) -> Branch | No:
    spot = spots(application).get(number)
    if spot is None:
        return No(Reason.of("desk.branch_gone"))
    if isinstance(spot.step, Branch):
        return spot.step
    return No(Reason.of("desk.not_a_branch"))


def _but(flows: tuple[AppFlow, ...], number: int) -> tuple[AppFlow, ...]:
    return (*flows[:number], *flows[number + 1 :])


def _too_many() -> No:
    return No(Reason.of("desk.flows_too_many", most=MOST_FLOWS))
