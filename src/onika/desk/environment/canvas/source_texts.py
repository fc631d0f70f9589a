"""The texts behind tasks, to be read and edited: `.rmod` files, the code of modules, their tests (C05, C23, C31)."""

import os
import re
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import libraries
from onika.desk.environment.canvas.library_tasks import saved_as_own, unknown
from onika.desk.environment.outcome.code_faults import LineFault, compiled
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.replacing import kept, present_text
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.trouble import said
from onika.desk.environment.state.model import Model
from onika.files import rmod, whole
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.own_copy import copied_with_code, copied_with_tasks
from onika.store.shipped import is_shipped
from onika.store.site import Site
from onika.wire import act, page
from onika.wire.view import Remedy, TextView
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import PLAIN, Reason

_STAMP = re.compile(r"[0-9a-f]{64}\Z")


def read_text(model: Model, command: act.ReadText, _outside: Services) -> Done | No:
    """The text of a task's `.rmod`, of its module's code or of its test, with what is wrong with it."""
    path = _path(model, command.task, command.kind)
    if isinstance(path, No):
        return path
    text, faults = whole.read(path)
    if text is None:
        return No(Reason.of("run.faults_together", faults=tuple(fault.sentence for fault in faults)))
    return Done(model, value=_view(path, *text))


def write_text(model: Model, command: act.WriteText, outside: Services) -> Done | No:
    """Save such a text whole or not at all, also a half-done one, and tell its faults; a `.rmod` counts at once.

    Of a shipped file a copy of the user's own is written, which stands before it.
    """
    path = _path(model, command.task, command.kind)
    if isinstance(path, No):
        return path
    if not _STAMP.match(command.stamp):
        return No(Reason.of("desk.text_unstamped"))
    if is_shipped(path):
        return _copied(model, path, command, outside.site)
    former = present_text(path)
    try:
        refused = whole.write(path, command.text, whole.ANYTHING if command.overwrites else command.stamp)
    except ValueError:
        return No(Reason.of("store.text_not_utf8"))
    if isinstance(refused, Refusal):
        return _refused(path, refused, command)
    view = _view(path, command.text, refused)
    done = libraries.reread(model, {path})
    left_out = command.kind == "rmod" and path.stem not in done.model.libraries.tasks
    message = page.Say("warning", Reason.of("desk.saved_at_fault", name=path.name))
    says = (message,) if left_out else done.says
    return replace(done, value=view, says=(*says, *kept(path, former, outside)))


def _copied(model: Model, path: Path, command: act.WriteText, site: Site) -> Done | No:
    """The text in a copy of the user's own, where the shipped file is still what was read."""
    there, _ = whole.read(path)
    if there is None or (there[1] != command.stamp and not command.overwrites):
        return _refused(path, Refusal(Reason.of("desk.shipped_changed", path=str(path))), command)
    task, home = model.libraries.tasks.get(command.task), BaseDirectory(path.parent.parent)
    if command.kind == "rmod":
        filed = model.libraries.filed(command.task) or Task(command.task, command.task)
        code = site.code_file(filed) if task else None
        copied = copied_with_code(path, command.text, filed, code, site)
    else:
        module = path.stem
        shipped = next(library for library in model.libraries.libraries if library.base == home)
        companions = [record.task for record in shipped.tasks.values() if record.task.module == module]
        copied = copied_with_tasks(path, command.text, companions, site)
    if isinstance(copied, Refusal):
        return No(copied.reason)
    done = libraries.saved_here(model, set(copied))
    view = _view(copied[0], command.text, whole.stamp(command.text))
    return replace(done, value=view, says=(*done.says, saved_as_own(copied[0], home)))


def _path(model: Model, task: str, kind: str) -> Path | No:
    """Where the text is; always inside an open library."""
    path = _PLACES[kind](model, task)
    if isinstance(path, No):
        return path
    file = path.resolve()
    if not any(file.is_relative_to(library.base.path.resolve()) for library in model.libraries.libraries):
        return No(Reason.of("desk.outside_libraries", path=str(path)))
    return path


def _rmod(model: Model, task: str) -> Path | No:
    """The file of a task, of one that is left out for its faults too."""
    home = model.libraries.homes.get(task)
    if home is not None:
        return home.base.task_file(task)
    files = (library.base.task_file(task) for library in model.libraries.libraries) if TASK_NAME.match(task) else ()
    return next((file for file in files if file.is_file()), unknown(task))


def _code(model: Model, task: str) -> Path | No:
    """The code of a task's module: beside its file, else in the first library that has it."""
    described = model.libraries.tasks.get(task)
    if described is None:
        return unknown(task)
    path = model.libraries.code_file(task)
    if path is None:
        return No(Reason.of("desk.no_source", module=described.module, task=task))
    return path


def _test(model: Model, task: str) -> Path | No:
    """The test of a task's module, in the base directory in which the code is."""
    code = _code(model, task)
    if isinstance(code, No):
        return code
    path = code.parent.parent / "tests" / f"test_{code.stem}.py"
    if path.is_file():
        return path
    return No(Reason.of("desk.no_test", module=code.stem, path=str(path)))


_PLACES = {"rmod": _rmod, "code": _code, "test": _test}


def _refused(path: Path, refused: Refusal, command: act.WriteText) -> No:
    """With what stands there now, so that one can choose."""
    text, _ = whole.read(path)
    fields = {}
    if text is not None and text[1] != command.stamp:
        fields = {"theirs": Reason(PLAIN, text[0]), "stamp": Reason(PLAIN, text[1])}
    again = act.WriteText(command.task, command.kind, command.text, command.stamp, overwrites=True)
    is_other = bool(fields) or not path.exists()
    overwrite = Remedy(Reason.of("desk.overwrite_it"), again)
    return No(refused.reason, (overwrite,) if is_other else (), fields)


def _view(path: Path, text: str, stamp: whole.Stamp) -> TextView:
    faults = _rmod_faults(path, text) if path.suffix == rmod.ENDING else _code_faults(path, text)
    is_read_only = not is_shipped(path) and not (os.access(path, os.W_OK) and os.access(path.resolve().parent, os.W_OK))
    return TextView(str(path), text, stamp, tuple(faults), is_read_only)


def _rmod_faults(path: Path, text: str) -> list[tuple[int, Reason]]:
    _, faults = rmod.read(text, path.stem, path.name)
    return [(fault.place.line, said(fault)) for fault in faults]


def _code_faults(path: Path, text: str) -> list[LineFault]:
    """What the compiler says; nothing of the module is run."""
    fault, remarks = compiled(text, path.name)
    return [*remarks] if fault is None else [fault]
