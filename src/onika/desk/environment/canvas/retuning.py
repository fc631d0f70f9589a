"""Acts on how a placed task runs: its rate, and the processing unit it lives on (C11, readings 10 and 12)."""

from dataclasses import replace
from math import isfinite

from onika.desk.environment.canvas.placement import changed
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import UNKNOWN_RTPU, Placed
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.name import TASK_NAME


@on_document
def rate(model: Model, document: Document, asked: act.Rate, _outside: Surroundings) -> Done | No:
    """The rate of a task in this configuration; 0: as its file says."""
    placed = document.content.placed(asked.task)
    if placed is None:
        return No(f"there is no {asked.task} on the canvas")
    if not isfinite(asked.hz) or asked.hz < 0:
        return _no_rate(asked, "expected a rate above 0 Hz, or 0 for that of its file")
    task = model.shelf.tasks.get(asked.task)
    if task is not None and task.frequency is None and asked.hz:
        return _no_rate(asked, f"expected none: {asked.task} runs once for each command or event")
    words = f"{asked.hz:g} Hz" if asked.hz else "the rate of its file"
    return _with(model, document, placed, replace(placed, frequency=asked.hz), f"giving {asked.task} {words}")


@on_document
def unit(model: Model, document: Document, asked: act.Unit, _outside: Surroundings) -> Done | No:
    """The unit that a task of this configuration lives on; one that lives is exchanged for itself over there."""
    placed = document.content.placed(asked.task)
    if placed is None:
        return No(f"there is no {asked.task} on the canvas")
    rtpu = asked.rtpu or UNKNOWN_RTPU
    if not TASK_NAME.match(rtpu):
        text = "expected a name of letters, digits and _ . - that begins with a letter"
        return No(f"{rtpu!r} is no name for a processing unit", fields={"rtpu": text})
    known = document.live
    if known is not None and known.state == "live":
        units = model.runtime.units
        if rtpu != UNKNOWN_RTPU and (rtpu not in units or units[rtpu].is_lost):
            there = ", ".join(name for name, one in units.items() if not one.is_lost)
            return No(f"the runtime has no unit {rtpu} that lives", fields={"rtpu": f"expected one of {there}"})
        if known.state_of(asked.task) in ("ON", "ASKING"):
            off = Remedy(f"Turn {asked.task} OFF", act.Turn(document.id, (asked.task,), is_on=False))
            return No(f"{asked.task} is {known.state_of(asked.task)}: it moves to another unit while it is OFF", (off,))
    return _with(model, document, placed, replace(placed, rtpu=rtpu), f"moving {asked.task} to {rtpu}")


def _no_rate(asked: act.Rate, text: str) -> No:
    return No(f"{asked.hz:g} Hz is no rate for {asked.task}", fields={"hz": text})


def _with(model: Model, document: Document, old: Placed, new: Placed, label: str) -> Done:
    configuration = document.content.configuration
    placed = tuple(new if one is old else one for one in configuration.placed)
    return changed(model, document, replace(configuration, placed=placed), label)
