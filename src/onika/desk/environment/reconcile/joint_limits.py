"""Bounds of targets that only a robot knows, as its joint limits: asked for as soon as a task that tells them lives."""

from dataclasses import replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import inputs_of
from onika.wire import event, live, request


def after_event(model: Model, message: event.Event) -> tuple[Order, ...]:
    """A task has come to life, of an application too: ask for what it tells."""
    if not isinstance(message, event.TaskState) or message.state != "OFF":
        return ()
    return _orders(model, message.subsystem, (message.task,))


def connected(model: Model, document: Document) -> tuple[Order, ...]:
    """Tasks that lived already when a configuration was connected with them tell nothing by themselves."""
    subsystem_facts = document.live
    if subsystem_facts:
        return _orders(model, subsystem_facts.subsystem, tuple(subsystem_facts.tasks))
    return ()


def _orders(model: Model, subsystem: str, tasks: tuple[str, ...]) -> tuple[Order, ...]:
    library_tasks = model.libraries.tasks
    stated = {
        name
        for task in tasks
        if task in library_tasks
        for name in library_tasks[task].svars(library_tasks[task].outconst)
    }
    names = tuple(sorted(stated & _wanted(model))) if stated else ()
    then = partial(_read, names=names)
    if names:
        return (Order(live.Read(subsystem, names), then),)
    return ()


def _wanted(model: Model) -> set[str]:
    """The constants that bound what tasks take from targets."""
    names = set()
    for task in model.libraries.tasks.values():
        if task.object_type is not None:
            aliases = dict(task.aliases)
            bounds = (
                bound
                for input_sheet in inputs_of(model.libraries, task)
                for bound in (input_sheet.low, input_sheet.high)
            )
            names |= {aliases.get(bound, bound) for bound in bounds if isinstance(bound, str)}
    return names


def _read(model: Model, response: request.Response, names: tuple[str, ...]) -> Done:
    if not isinstance(response, live.Values):
        return Done(model)
    stated = {name: _numbers(response.values[name]) for name in names if name in response.values}
    return Done(replace(model, limits={**model.limits, **stated}))


def _numbers(value: object) -> tuple[float, ...]:
    if isinstance(value, list):
        return tuple(map(float, value))
    return (float(str(value)),)
