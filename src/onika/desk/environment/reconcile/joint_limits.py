"""Bounds of targets that only a robot knows, as its joint limits: asked for as soon as a task that tells them lives."""

from dataclasses import replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import inputs_of
from onika.wire import event, live, request


def heard(model: Model, told: event.Event) -> tuple[Order, ...]:
    """A task has come to life, of an application too: ask for what it tells."""
    if not isinstance(told, event.TaskState) or told.state != "OFF":
        return ()
    return _orders(model, told.subsystem, (told.task,))


def connected(model: Model, document: Document) -> tuple[Order, ...]:
    """Tasks that lived already when a configuration was connected with them tell nothing by themselves."""
    known = document.live
    return _orders(model, known.subsystem, tuple(known.tasks)) if known else ()


def _orders(model: Model, subsystem: str, tasks: tuple[str, ...]) -> tuple[Order, ...]:
    known = model.shelf.tasks
    told = {name for task in tasks if task in known for name in known[task].svars(known[task].outconst)}
    names = tuple(sorted(told & _wanted(model))) if told else ()
    then = partial(_read, names=names)
    return (Order(live.Read(subsystem, names), then),) if names else ()


def _wanted(model: Model) -> set[str]:
    """The constants that bound what tasks take from targets."""
    found = set()
    for task in model.shelf.tasks.values():
        if task.object_type is not None:
            aliases = dict(task.aliases)
            bounds = (bound for one in inputs_of(model.shelf, task) for bound in (one.low, one.high))
            found |= {aliases.get(one, one) for one in bounds if isinstance(one, str)}
    return found


def _read(model: Model, response: request.Response, names: tuple[str, ...]) -> Done:
    if not isinstance(response, live.Values):
        return Done(model)
    told = {name: _numbers(response.values[name]) for name in names if name in response.values}
    return Done(replace(model, limits={**model.limits, **told}))


def _numbers(value: object) -> tuple[float, ...]:
    return tuple(map(float, value)) if isinstance(value, list) else (float(str(value)),)
