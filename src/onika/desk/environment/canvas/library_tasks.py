"""Acts on tasks of the libraries: aliases and rates; kept for the session or saved (requirements C04, C23)."""

import math
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import own_lines
from onika.desk.environment.canvas.libraries import reread, saved_here
from onika.desk.environment.canvas.own_lines import placed_in
from onika.desk.environment.outcome import pin_changes
from onika.desk.environment.outcome.clash import clashes, refused
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting
from onika.desk.environment.outcome.replacing import kept, present_text
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state import task_edit
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.state.restoration import own_step
from onika.files import rmod
from onika.model.own_lines import NO_OWN_LINES
from onika.model.task import Task, TaskType
from onika.store.base_directory import BaseDirectory
from onika.store.own_copy import copied_with_code
from onika.store.shipped import is_shipped
from onika.wire import act, page
from onika.wire.view import Remedy, ShowLibraries
from onika.words.fault import Refusal
from onika.words.name import SVAR_NAME
from onika.words.reason import Reason


def alias(model: Model, command: act.Alias, _outside: Services) -> Done | No:
    """Give the variable behind a pin: of a placed task in its configuration, else everywhere it is placed.

    Every open configuration that it concerns must bear it.
    """
    placed = placed_in(model, command.doc, command.task)
    libraries = model.libraries_of(placed[0]) if placed else model.libraries
    task, filed = libraries.tasks.get(command.task), libraries.filed(command.task)
    if task is None or filed is None:
        return unknown(command.task)
    if command.pin not in task.kinds():
        return No(Reason.of("desk.no_pin", task=command.task, pin=command.pin))
    svar = command.svar.strip()
    if svar and not SVAR_NAME.match(svar):
        expected = Reason.of("desk.variable_form")
        return No(Reason.of("desk.no_variable_name", svar=svar), fields={"svar": expected})
    changed = task_edit.aliased(task, command.pin, svar, filed)
    name = svar or command.pin
    label = Reason.of("desk.aliasing", pin=command.pin, task=command.task, name=name)
    cannot = Reason.of("desk.pin_cannot_be", pin=command.pin, task=command.task, name=name)
    if placed:
        return own_lines.changed(model, placed, changed, label, cannot)
    libraries = model.libraries.edited({command.task: changed})
    against = clashes(model, libraries, (command.task,))
    if against:
        return refused(cannot, against, "svar")
    return Done(taken_over(model, libraries), label, command.doc)


def library_rate(model: Model, command: act.LibraryRate, _outside: Services) -> Done | No:
    """A rate for later placements of this session (reading 10)."""
    task = model.libraries.tasks.get(command.task)
    if task is None:
        return unknown(command.task)
    if task.type is not TaskType.PERIODIC:
        reason = Reason.of("desk.not_periodic", task=command.task, type=task.type.value)
        return No(reason, fields={"hz": reason})
    if not (math.isfinite(command.hz) and command.hz > 0):
        reason = Reason.of("desk.rate_form", hz=str(command.hz))
        return No(Reason.of("desk.rate_unfit", task=command.task, why=reason), fields={"hz": reason})
    rate = None if command.hz == task.frequency else command.hz
    former = model.libraries.rates.get(command.task) or task.frequency or command.hz
    before, label = act.LibraryRate(command.task, former), Reason.of("run.changing_rate", task=command.task)
    step = own_step(label, before, act.LibraryRate(command.task, command.hz))
    own = step if former != command.hz else None
    return Done(replace(model, libraries=model.libraries.rated({command.task: rate})), own=own)


def save_task(model: Model, command: act.SaveTask, outside: Services) -> Done | No:
    """Write what was changed of a task, its rate too, to its file; of a shipped one to a copy of the user's own.

    What was changed of a placed task is the file's from then on, no longer of its configuration alone.
    """
    placed = placed_in(model, command.doc, command.task)
    libraries = model.libraries_of(placed[0]) if placed else model.libraries
    task, name = libraries.tasks.get(command.task), placed[1].file if placed else command.task
    if task is None:
        return unknown(command.task)
    done = _saved(model, replace(task, name=name), command, outside)
    if placed is None or isinstance(done, No):
        return done
    return replace(done, model=own_lines.dropped(done.model, placed))


def _saved(model: Model, task: Task, command: act.SaveTask, outside: Services) -> Done | No:
    name = task.name
    base, record = model.libraries.homes[name].base, model.libraries.records[name]
    path = base.task_file(name)
    changed = replace(task, frequency=model.libraries.rates.get(name, task.frequency))
    if changed == record.task:
        return Done(model, value=str(path))
    if is_shipped(base.path):
        return _copied(model, name, changed, outside)
    former = present_text(path)
    done = base.save_task(record, changed, overwrites=command.overwrites)
    if isinstance(done, Refusal):
        remedies = (
            *overwriting(done, act.SaveTask(command.task, overwrites=True, doc=command.doc)),
            Remedy(Reason.of("desk.take_as_filed"), act.ForgetTask(command.task, command.doc)),
        )
        return No(done.reason, remedies)
    filed = _as_filed(model, name, path)
    return replace(filed, value=str(path), says=(*filed.says, *kept(path, former, outside)))


def forget_task(model: Model, command: act.ForgetTask, _outside: Services) -> Done | No:
    """A task as its file says now, where every open configuration bears it; a placed one as its library has it."""
    placed = placed_in(model, command.doc, command.task)
    if placed and placed[1].own != NO_OWN_LINES:
        return own_lines.as_in_library(model, placed, Reason.of("desk.taking_as_filed", task=command.task))
    if command.task not in model.libraries.tasks:
        return unknown(command.task)
    path = model.libraries.homes[command.task].base.task_file(command.task)
    done = _as_filed(model, command.task, path)
    against = clashes(model, done.model.libraries, (command.task,))
    if against:
        return refused(Reason.of("desk.not_as_filed", task=command.task), against)
    return done


def _copied(model: Model, name: str, changed: Task, outside: Services) -> Done | No:
    """A changed task of a shipped library as the user's own, which stands before it."""
    home, record = model.libraries.homes[name].base, model.libraries.records[name]
    code, shipped = outside.site.code_file(record.task), home.task_file(name)
    copied = copied_with_code(shipped, rmod.write(record, changed), changed, code, outside.site)
    if isinstance(copied, Refusal):
        return No(copied.reason, (Remedy(Reason.of("desk.take_as_filed"), act.ForgetTask(name)),))
    done = saved_here(model, set(copied))
    unchanged = done.model.libraries.edited({name: None}).rated({name: None})
    says = (*done.says, saved_as_own(copied[0], home))
    return replace(done, model=taken_over(done.model, unchanged), says=says, value=str(copied[0]))


def saved_as_own(path: Path, base: BaseDirectory) -> page.Say:
    """What is said of a copy that stands before a shipped file from now on."""
    return page.Say("success", Reason.of("desk.saved_as_own", path=str(path), base=base.path.name))


def unknown(name: str) -> No:
    """No open library has the task."""
    return No(Reason.of("desk.no_task", name=name), (Remedy(Reason.of("desk.open_library"), show=ShowLibraries()),))


def taken_over(model: Model, libraries: OpenLibraries) -> Model:
    """With changed tasks, wherever they are placed."""
    return pin_changes.resettled(replace(model, libraries=libraries), model.libraries)


def _as_filed(model: Model, name: str, path: Path) -> Done:
    """With the file read again, and nothing changed of it here."""
    done = reread(model, {path})
    unchanged = done.model.libraries.edited({name: None}).rated({name: None})
    return replace(done, model=taken_over(done.model, unchanged))
