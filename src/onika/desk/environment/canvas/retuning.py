"""Acts on how a placed task runs: its rate, and the processing unit it lives on (C11, readings 10 and 12)."""

from dataclasses import replace
from math import isfinite

from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.other_tasks import with_other_tasks
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import UNKNOWN_RTPU, Placed
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.name import TASK_NAME
from onika.words.reason import Reason


@on_document
def rate(model: Model, document: Document, command: act.Rate, _outside: Services) -> Done | No:
    """The rate of a task in this configuration; 0: as its file says."""
    placed = document.content.placed(command.task)
    if placed is None:
        return No(Reason.of("desk.not_on_canvas", name=command.task))
    if not isfinite(command.hz) or command.hz < 0:
        return _no_rate(command, Reason.of("desk.rate_above_0"))
    task = model.libraries_of(document).tasks.get(command.task)
    if task is not None and task.frequency is None and command.hz:
        return _no_rate(command, Reason.of("desk.rate_of_command", task=command.task))
    filed = Reason.of("desk.giving_filed_rate", task=command.task)
    label = Reason.of("desk.giving_rate", task=command.task, hz=command.hz) if command.hz else filed
    return _with(model, document, placed, replace(placed, frequency=command.hz), label)


@on_document
def unit(model: Model, document: Document, command: act.Unit, _outside: Services) -> Done | No:
    """The unit that a task of this configuration lives on; one that lives is exchanged for itself over there."""
    placed = document.content.placed(command.task)
    if placed is None:
        return No(Reason.of("desk.not_on_canvas", name=command.task))
    rtpu = command.rtpu or UNKNOWN_RTPU
    if not TASK_NAME.match(rtpu):
        text = Reason.of("desk.name_of_letters")
        return No(Reason.of("desk.no_unit_name", name=rtpu), fields={"rtpu": text})
    subsystem_facts = document.live
    if subsystem_facts is not None and subsystem_facts.state == "live":
        units = model.runtime.units
        if rtpu != UNKNOWN_RTPU and (rtpu not in units or units[rtpu].is_lost):
            there = tuple(name for name, unit in units.items() if not unit.is_lost)
            return No(
                Reason.of("desk.no_living_unit", unit=rtpu), fields={"rtpu": Reason.of("desk.one_of", names=there)}
            )
        if subsystem_facts.state_of(command.task) in ("ON", "ASKING"):
            off = Remedy(
                Reason.of("desk.turn_off", task=command.task), act.Turn(document.id, (command.task,), is_on=False)
            )
            return No(
                Reason.of("desk.moves_while_off", task=command.task, state=subsystem_facts.state_of(command.task)),
                (off,),
            )
    return _with(
        model,
        document,
        placed,
        replace(placed, rtpu=rtpu),
        Reason.of("desk.moving_to_unit", task=command.task, unit=rtpu),
    )


def _no_rate(command: act.Rate, text: Reason) -> No:
    return No(Reason.of("desk.rate_refused", hz=command.hz, task=command.task), fields={"hz": text})


def _with(model: Model, document: Document, old: Placed, new: Placed, label: Reason) -> Done:
    configuration = document.content.configuration
    placed = tuple(new if placed is old else placed for placed in configuration.placed)
    return with_other_tasks(model, document, replace(configuration, placed=placed), label)
