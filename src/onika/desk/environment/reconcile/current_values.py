"""Where a task that asks stands at present: what it measures of the kind that it asks for, as a possible answer."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.port import PortKind
from onika.wire import live, request


def ask_present(model: Model, document: Document, task: str) -> tuple[Order, ...]:
    """Ask for what a task measures of the same shape and unit as its inputs have; nothing where it measures none."""
    if document.live is None:
        return ()
    moving = [name for name, facts in document.live.tasks.items() if facts.state == "ON"]
    wanted = measured(model.libraries_of(document), task, moving)
    if not wanted:
        return ()
    names = tuple(dict.fromkeys(wanted.values()))
    then = partial(_told, doc=document.id, task=task, wanted=wanted)
    return (Order(live.Read(document.live.subsystem, names), then),)


def measured(libraries: OpenLibraries, task: str, moving: Collection[str]) -> dict[str, str]:
    """By input of a task: the variable of its kind that it reads and that one of the tasks that are ON writes."""
    library_tasks = libraries.tasks
    written = {svar for name in moving if name in library_tasks for svar in library_tasks[name].outputs}
    return {name: svar for name, svar in _wanted(libraries, task).items() if svar in written}  # else it is old


def values_of(values: live.Values, wanted: Mapping[str, str]) -> dict[str, tuple[float, ...]]:
    """What was read, by input."""
    return {name: tuple(_flat(values.values[svar])) for name, svar in wanted.items() if svar in values.values}


def _wanted(libraries: OpenLibraries, name: str) -> Mapping[str, str]:
    """By input: the variable that is read and is of its kind."""
    task = libraries.tasks.get(name)
    sheet = libraries.sheets.get(task.module) if task else None
    if task is None or sheet is None:
        return {}
    read = [port for port in sheet.ports if PortKind(port.kind).is_input and PortKind(port.kind).at_cycle]
    aliases = dict(task.aliases)
    return {
        input_sheet.name: aliases.get(port.name, port.name)
        for input_sheet in sheet.inputs
        for port in reversed(read)  # of several the first
        if "[" in input_sheet.shape and (port.shape, port.unit) == (input_sheet.shape, input_sheet.unit)
    }


def _told(model: Model, response: request.Response, doc: str, task: str, wanted: Mapping[str, str]) -> Done:
    document = model.documents.get(doc)
    subsystem_facts = document.live if document else None
    facts = subsystem_facts.tasks.get(task) if subsystem_facts else None
    if document is None or subsystem_facts is None or facts is None or not isinstance(response, live.Values):
        return Done(model)
    message = subsystem_facts.with_task(task, replace(facts, present=values_of(response, wanted)))
    return Done(model.with_document(replace(document, live=message)))


def _flat(value: object) -> list[float]:
    if isinstance(value, list):
        return [number for part in value for number in _flat(part)]
    return [float(str(value))]
