"""Acts on how a placed task runs: its rate, and the processing unit it lives on (C11, readings 10 and 12)."""

from dataclasses import replace
from math import isfinite

from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.other_tasks import with_other_tasks
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import UNKNOWN_RTPU, Placed
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.name import TASK_NAME


@on_document
def rate(model: Model, document: Document, command: act.Rate, _outside: Surroundings) -> Done | No:
    """The rate of a task in this configuration; 0: as its file says."""
    placed = document.content.placed(command.task)
    if placed is None:
        return No(f"there is no {command.task} on the canvas")
    if not isfinite(command.hz) or command.hz < 0:
        return _no_rate(command, "expected a rate above 0 Hz, or 0 for that of its file")
    task = model.shelf.tasks.get(command.task)
    if task is not None and task.frequency is None and command.hz:
        return _no_rate(command, f"expected none: {command.task} runs once for each command or event")
    words = f"{command.hz:g} Hz" if command.hz else "the rate of its file"
    return _with(model, document, placed, replace(placed, frequency=command.hz), f"giving {command.task} {words}")


@on_document
def unit(model: Model, document: Document, command: act.Unit, _outside: Surroundings) -> Done | No:
    """The unit that a task of this configuration lives on; one that lives is exchanged for itself over there."""
    placed = document.content.placed(command.task)
    if placed is None:
        return No(f"there is no {command.task} on the canvas")
    rtpu = command.rtpu or UNKNOWN_RTPU
    if not TASK_NAME.match(rtpu):
        text = "expected a name of letters, digits and _ . - that begins with a letter"
        return No(f"{rtpu!r} is no name for a processing unit", fields={"rtpu": text})
    subsystem_facts = document.live
    if subsystem_facts is not None and subsystem_facts.state == "live":
        units = model.runtime.units
        if rtpu != UNKNOWN_RTPU and (rtpu not in units or units[rtpu].is_lost):
            there = ", ".join(name for name, unit in units.items() if not unit.is_lost)
            return No(f"the runtime has no unit {rtpu} that lives", fields={"rtpu": f"expected one of {there}"})
        if subsystem_facts.state_of(command.task) in ("ON", "ASKING"):
            off = Remedy(f"Turn {command.task} OFF", act.Turn(document.id, (command.task,), is_on=False))
            return No(
                f"{command.task} is {subsystem_facts.state_of(command.task)}: it moves to another unit while it is OFF",
                (off,),
            )
    return _with(model, document, placed, replace(placed, rtpu=rtpu), f"moving {command.task} to {rtpu}")


def _no_rate(command: act.Rate, text: str) -> No:
    return No(f"{command.hz:g} Hz is no rate for {command.task}", fields={"hz": text})


def _with(model: Model, document: Document, old: Placed, new: Placed, label: str) -> Done:
    configuration = document.content.configuration
    placed = tuple(new if placed is old else placed for placed in configuration.placed)
    return with_other_tasks(model, document, replace(configuration, placed=placed), label)
